// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solid/face_plane.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace parison::contact {

FacePlane::FacePlane(const std::vector<Vector3>& nodes, const core::QuadFace& face) {
  const auto corner = [&](int i) -> const Vector3& { return nodes[face.nodes[i]]; };
  origin = 0.25 * (corner(0) + corner(2) + corner(6) + corner(8));
  const Vector3 diagonal = corner(8) - corner(0);
  normal = diagonal.cross(corner(6) - corner(2)).normalized();
  first = (diagonal - diagonal.dot(normal) * normal).normalized();
  second = normal.cross(first);
}

ProjectedFace::ProjectedFace(const FacePlane& plane, const std::vector<Vector3>& nodes, const core::QuadFace& face) {
  for (int i = 0; i < 9; ++i) nodes_[i] = plane.project(nodes[face.nodes[i]]);
}

std::optional<std::array<double, 2>> ProjectedFace::invert(const Point& at, std::array<double, 2> from) const {
  constexpr int most = 20;
  constexpr double solved = 1e-12, lost = 3;
  for (int iteration = 0; iteration < most; ++iteration) {
    const auto shape = core::quad_shape(from[0], from[1]);
    const auto derivative = core::quad_shape_derivative(from[0], from[1]);
    Point off = at, along_a = Point::Zero(), along_b = Point::Zero();
    for (int i = 0; i < 9; ++i) {
      off -= shape[i] * nodes_[i];
      along_a += derivative[i][0] * nodes_[i];
      along_b += derivative[i][1] * nodes_[i];
    }
    const double determinant = core::cross(along_a, along_b);
    const double step_a = core::cross(off, along_b) / determinant, step_b = core::cross(along_a, off) / determinant;
    from[0] += step_a;
    from[1] += step_b;
    if (!(std::abs(from[0] - 0.5) < lost && std::abs(from[1] - 0.5) < lost)) return std::nullopt;
    if (std::abs(step_a) + std::abs(step_b) < solved) return from;
  }
  return std::nullopt;
}

Polygon outline(const ProjectedFace& face, bool turned) {
  constexpr std::array<int, 8> around{0, 1, 2, 5, 8, 7, 6, 3};
  constexpr double straight = 1e-3;
  Polygon polygon;
  for (int k = 0; k < 8; k += 2) {
    const Point &from = face.node(around[k]), &mid = face.node(around[k + 1]), &to = face.node(around[(k + 2) % 8]);
    const Point chord = to - from;
    polygon.push_back(from);
    if (std::abs(core::cross(chord, mid - from)) > straight * chord.squaredNorm()) polygon.push_back(mid);
  }
  if (turned) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) twice += core::cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return 0.5 * twice;
}

Polygon clip(const Polygon& subject, const Polygon& convex) {
  Polygon result = subject, kept;
  for (std::size_t e = 0; e < convex.size() && !result.empty(); ++e) {
    const Point& from = convex[e];
    const Point along = convex[(e + 1) % convex.size()] - from;
    if (along.squaredNorm() == 0) continue;
    kept.clear();
    for (std::size_t i = 0; i < result.size(); ++i) {
      const Point &here = result[i], &next = result[(i + 1) % result.size()];
      const double left = core::cross(along, here - from), left_next = core::cross(along, next - from);
      if (left >= 0) kept.push_back(here);
      if ((left > 0 && left_next < 0) || (left < 0 && left_next > 0))
        kept.push_back(here + left / (left - left_next) * (next - here));
    }
    result.swap(kept);
  }
  return result;
}

bool holds(const Polygon& convex, const Point& at) {
  for (std::size_t e = 0; e < convex.size(); ++e)
    if (core::cross(convex[(e + 1) % convex.size()] - convex[e], at - convex[e]) < 0) return false;
  return true;
}

}  // namespace parison::contact
