#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/mesh/element.hpp"
#include "core/mesh/mesh.hpp"

namespace parison::thermal {

/// Four numbers; arithmetic is lane by lane.
typedef double VectorizedArray __attribute__((vector_size(32), aligned(32)));
/// Packs in a row. Not a std::array, which would lose the alignment.
template <int N>
struct alignas(32) VectorizedArrays {
  VectorizedArray own[N];

  VectorizedArray& operator[](int i) { return own[i]; }
  const VectorizedArray& operator[](int i) const { return own[i]; }
};

/// Shape functions and their derivatives in reference coordinates, a row for each point of triangle_rule(4).
template <int N>
struct CellShapes {
  Eigen::Matrix<double, 6, N> value, derivative_a, derivative_b;
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

/// Cells that are worked on together, a number of each in every Pack.
inline constexpr int batch_size = 4;

/// Numbers at the six points of triangle_rule(4) in the cells of a group.
using PointValues = VectorizedArrays<6>;

/// What depends on neither temperature nor unknowns in a group of cells, at their quadrature points; nothing for cells
/// that a body's last group lacks.
struct CellBatch {
  PointValues aa, ab, bb;  ///< present volume times the products of the gradients of the reference coordinates a, b, m
  PointValues mass;        ///< kg
  PointValues thin_wall;   ///< factor on the Rosseland conductivity
};
struct BodyView;
std::vector<CellBatch> make_batches(const BodyView& body, core::Geometry geometry);

/// Unknowns of a group, those of its cells together; a cell that the group lacks has the last one's.
using BatchUnknowns = std::array<std::array<core::Index, batch_size>, 6>;

/// Values of the unknowns of a group, and their way back into a sum.
template <int N>
[[gnu::always_inline]] inline void gather(const Eigen::VectorXd& values, const BatchUnknowns& unknowns,
                                          VectorizedArrays<N>& own) {
  for (int i = 0; i < N; ++i) {
    const auto& at = unknowns[i];
    own[i] = VectorizedArray{values[at[0]], values[at[1]], values[at[2]], values[at[3]]};
  }
}
template <int N>
[[gnu::always_inline]] inline void scatter(const VectorizedArrays<N>& own, const BatchUnknowns& unknowns,
                                           Eigen::VectorXd& sum) {
  for (int c = 0; c < batch_size; ++c)
    for (int i = 0; i < N; ++i) sum[unknowns[i][c]] += own[i][c];
}

/// Values at the points from those of the unknowns, by shape functions or their derivatives.
template <int N>
[[gnu::always_inline]] inline void interpolate(const Eigen::Matrix<double, 6, N>& shape, const VectorizedArrays<N>& own,
                                               PointValues& at) {
  for (int q = 0; q < 6; ++q) {
    at[q] = shape(q, 0) * own[0];
    for (int i = 1; i < N; ++i) at[q] += shape(q, i) * own[i];
  }
}
/// Adds the transposed: points into unknowns.
template <int N>
[[gnu::always_inline]] inline void collect(const Eigen::Matrix<double, 6, N>& shape, const PointValues& at,
                                           VectorizedArrays<N>& own) {
  for (int i = 0; i < N; ++i)
    for (int q = 0; q < 6; ++q) own[i] += shape(q, i) * at[q];
}

}  // namespace parison::thermal
