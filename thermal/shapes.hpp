#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include <Eigen/Core>

#include "core/element.hpp"

namespace parison::thermal {

/// Numbers at the six points of triangle_rule(4) in a cell.
using PointArray = Eigen::Array<double, 6, 1>;

/// Shape functions and their derivatives in reference coordinates, a row for each point of triangle_rule(4).
template <int N>
struct CellShapes {
  Eigen::Matrix<double, 6, N> value, slope_a, slope_b;
  Eigen::Matrix<double, N, 6> value_back, slope_a_back, slope_b_back;  ///< transposed: points into unknowns
};
/// Quadratic on a cell's 6 nodes, or linear on its 3 vertices.
template <int N>
const CellShapes<N>& cell_shapes();

/// Quadratic shape functions at the points of edge_rule(3), [point][node].
using EdgeShapes = std::array<std::array<double, 3>, 3>;
const EdgeShapes& edge_shapes();

/// Weights of the unknowns of an edge from those of its nodes. Where only the vertices are unknowns, a mid-side node
/// gives half its weight to either end and keeps none.
inline std::array<double, 3> unknown_weights(const std::array<double, 3>& shape, int order) {
  if (order == 2) return shape;
  return {shape[0] + 0.5 * shape[2], shape[1] + 0.5 * shape[2], 0};
}

/// Values of a cell's unknowns, and their way back into a sum.
template <int N>
Eigen::Matrix<double, N, 1> gather(const Eigen::VectorXd& values, const std::array<core::Index, 6>& unknowns) {
  Eigen::Matrix<double, N, 1> own;
  for (int i = 0; i < N; ++i) own[i] = values[unknowns[i]];
  return own;
}
template <int N>
void scatter(const Eigen::Matrix<double, N, 1>& own, const std::array<core::Index, 6>& unknowns, Eigen::VectorXd& sum) {
  for (int i = 0; i < N; ++i) sum[unknowns[i]] += own[i];
}

/// Value at a point of an edge from its three unknowns.
inline double interpolate(const Eigen::VectorXd& values, const core::Index* unknowns,
                          const std::array<double, 3>& shape) {
  return shape[0] * values[unknowns[0]] + shape[1] * values[unknowns[1]] + shape[2] * values[unknowns[2]];
}

}  // namespace parison::thermal
