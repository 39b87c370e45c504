#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "core/mesh.hpp"
#include "thermal/shapes.hpp"

namespace parison::thermal {

/// Cells that are worked on together, a number of each in every Pack.
inline constexpr int group_size = 4;

/// Numbers at the six points of triangle_rule(4) in the cells of a group.
using PointPacks = Packs<6>;

/// What depends on neither temperature nor unknowns in a group of cells, at their quadrature points; nothing for cells that a
/// body's last group lacks.
struct CellGroup {
  PointPacks aa, ab, bb;  ///< present volume times the products of the gradients of the reference coordinates a, b, m
  PointPacks mass;        ///< kg
  PointPacks thin_wall;   ///< factor on the Rosseland conductivity
};
struct BodyView;
std::vector<CellGroup> make_groups(const BodyView& body, core::Geometry geometry);

/// Unknowns of a group, those of its cells together; a cell that the group lacks has the last one's.
using GroupUnknowns = std::array<std::array<core::Index, group_size>, 6>;

/// Values of the unknowns of a group, and their way back into a sum.
template <int N>
[[gnu::always_inline]] inline void gather(const Eigen::VectorXd& values, const GroupUnknowns& unknowns, Packs<N>& own) {
  for (int i = 0; i < N; ++i) {
    const auto& at = unknowns[i];
    own[i] = Pack{values[at[0]], values[at[1]], values[at[2]], values[at[3]]};
  }
}
template <int N>
[[gnu::always_inline]] inline void scatter(const Packs<N>& own, const GroupUnknowns& unknowns, Eigen::VectorXd& sum) {
  for (int c = 0; c < group_size; ++c)
    for (int i = 0; i < N; ++i) sum[unknowns[i][c]] += own[i][c];
}

/// Values at the points from those of the unknowns, by shape functions or their derivatives.
template <int N>
[[gnu::always_inline]] inline void interpolate(const Eigen::Matrix<double, 6, N>& shape, const Packs<N>& own,
                                               PointPacks& at) {
  for (int q = 0; q < 6; ++q) {
    at[q] = shape(q, 0) * own[0];
    for (int i = 1; i < N; ++i) at[q] += shape(q, i) * own[i];
  }
}
/// Adds the transposed: points into unknowns.
template <int N>
[[gnu::always_inline]] inline void collect(const Eigen::Matrix<double, 6, N>& shape, const PointPacks& at, Packs<N>& own) {
  for (int i = 0; i < N; ++i)
    for (int q = 0; q < 6; ++q) own[i] += shape(q, i) * at[q];
}

}  // namespace parison::thermal
