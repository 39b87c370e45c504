#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include <Eigen/Core>

#include "core/element.hpp"

namespace parison::thermal {

/// Four numbers; arithmetic is lane by lane.
typedef double Pack __attribute__((vector_size(32), aligned(32)));
/// Packs in a row. Not a std::array, which would lose the alignment.
template <int N>
struct alignas(32) Packs {
  Pack own[N];

  Pack& operator[](int i) { return own[i]; }
  const Pack& operator[](int i) const { return own[i]; }
};

/// Shape functions and their derivatives in reference coordinates, a row for each point of triangle_rule(4).
template <int N>
struct CellShapes {
  Eigen::Matrix<double, 6, N> value, slope_a, slope_b;
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

/// Adds to the values of six unknowns.
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
