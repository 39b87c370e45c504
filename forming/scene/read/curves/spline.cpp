// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/curves/spline.hpp"

#include "forming/scene/read/curves/curve_arcs.hpp"
#include "forming/scene/read/drawing/read_section.hpp"

namespace parison::forming {
namespace {

using core::Point;
using Weighted = Eigen::Vector3d;

/// The place and derivative within a span of knots by the algorithm of de Boor (C. de Boor, J. Approximation Theory 6
/// (1972) 50-62).
CurvePoint place_on(const Spline& spline, double t, std::size_t span) {
  const std::size_t degree = spline.degree;
  const auto& knots = spline.knots;
  std::vector<Weighted> d(spline.points.begin() + static_cast<std::ptrdiff_t>(span - degree),
                          spline.points.begin() + static_cast<std::ptrdiff_t>(span + 1));
  Weighted rate = Weighted::Zero();
  for (std::size_t r = 1; r <= degree; ++r) {
    if (r == degree) rate = static_cast<double>(degree) * (d[degree] - d[degree - 1]) / (knots[span + 1] - knots[span]);
    for (std::size_t j = degree; j >= r; --j) {
      const double first = knots[j + span - degree], width = knots[j + 1 + span - r] - first;
      d[j] += (t - first) / width * (d[j] - d[j - 1]) - (d[j] - d[j - 1]);
    }
  }
  const double w = d[degree][2];
  const Point x = d[degree].head<2>() / w;
  return {x, (rate.head<2>() - rate[2] * x) / w};
}

}  // namespace

std::vector<core::Segment> arcs_of_spline(const Spline& spline, double tolerance) {
  std::vector<core::Segment> arcs;
  const double least = 1e-9 * (spline.knots.back() - spline.knots.front());
  // A polynomial of high degree bends often in one span.
  const std::size_t parts = spline.degree > 3 ? spline.degree : 1;
  for (std::size_t span = spline.degree; span < spline.points.size(); ++span) {
    const double first = spline.knots[span], width = spline.knots[span + 1] - first;
    if (!(width > least) || arcs.size() > max_segments) continue;
    const auto curve = [&](double t) { return place_on(spline, t, span); };
    if (spline.degree == 1) {
      arcs.emplace_back();
      arcs.back().start = curve(first).x;
      arcs.back().end = curve(first + width).x;
      continue;
    }
    for (std::size_t i = 0; i < parts; ++i) {
      const auto part = arcs_of(curve, first + width * double(i) / double(parts),
                                first + width * double(i + 1) / double(parts), tolerance);
      arcs.insert(arcs.end(), part.begin(), part.end());
    }
  }
  return arcs;
}

}  // namespace parison::forming
