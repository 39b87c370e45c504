#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>

namespace parison::core {

using Index = int;

/// Number of coordinates of a point: (r, z) in axisymmetric scenes, (x, y) in planar ones.
inline constexpr int dim = 2;
/// Position or displacement, m; in axisymmetric scenes the axis of symmetry is the last coordinate's.
using Point = Eigen::Matrix<double, dim, 1>;
using Tensor = Eigen::Matrix<double, dim, dim>;
/// Of two vectors, the area of their parallelogram: above zero where `b` lies to the left of `a`.
inline double cross(const Point& a, const Point& b) {
  return a[0] * b[1] - a[1] * b[0];
}
/// Direction along which tools move and gravity acts.
inline Point axis_direction() {
  return Point::Unit(dim - 1);
}

}  // namespace parison::core
