#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/mesh/profile.hpp"

namespace parison::forming {

/// A plane rational B-spline.
struct Spline {
  std::size_t degree;
  std::vector<double> knots;            ///< rising, as many as points and degree and 1 together
  std::vector<Eigen::Vector3d> points;  ///< x w, y w (m) and the weight w
};

/// Lines and arcs within `tolerance`, m, of a spline: its knots are ends of theirs, so that its corners stay corners.
/// A spline of degree 1 comes as its lines.
std::vector<core::Segment> arcs_of_spline(const Spline& spline, double tolerance);

}  // namespace parison::forming
