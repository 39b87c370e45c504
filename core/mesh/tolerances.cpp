// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/tolerances.hpp"

#include <limits>

namespace parison::core {

namespace {

/// Box around points, grown one by one.
struct Extent {
  Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;

  void add(const Point& x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
};

}  // namespace

double size(const Profile& profile) {
  Extent extent;
  for (const Segment& segment : profile.segments)
    for (const double t : {0.0, 0.5}) extent.add(point_at(segment, t));
  return (extent.high - extent.low).norm();
}

double size(const Mesh& mesh) {
  Extent extent;
  for (const Point& x : mesh.nodes) extent.add(x);
  return (extent.high - extent.low).norm();
}

}  // namespace parison::core
