#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// Quadratic triangles four at a time, one in each lane of a vector register, like the cell batches of MatrixFree in
// deal.II (Kronbichler & Kormann 2012). Each lane does the operations of a scalar loop, so the results have the same
// bits on every processor. All functions are inlined into their callers, which may be compiled for several instruction
// sets (target_clones); vectors are passed by reference because their calling convention differs between those.
#include <algorithm>
#include <array>

#include "core/mesh/element.hpp"

namespace parison::core {

/// Number of cells of a batch, which are computed side by side, each in a lane.
inline constexpr int batch_size = 4;
/// One number of each cell of a batch; arithmetic is lane by lane. A class and no bare vector type: the alignment of
/// that depends on the instruction set of the function that uses it, and templates drop an alignment asked for.
struct alignas(batch_size * sizeof(double)) VectorizedArray {
  typedef double Lanes __attribute__((vector_size(batch_size * sizeof(double))));
  Lanes lanes;

  [[gnu::always_inline]] double operator[](int lane) const { return lanes[lane]; }
  [[gnu::always_inline]] double& operator[](int lane) { return reinterpret_cast<double*>(&lanes)[lane]; }
  [[gnu::always_inline]] VectorizedArray& operator+=(const VectorizedArray& x) { return lanes += x.lanes, *this; }
  [[gnu::always_inline]] VectorizedArray& operator-=(const VectorizedArray& x) { return lanes -= x.lanes, *this; }
  [[gnu::always_inline]] VectorizedArray& operator*=(const VectorizedArray& x) { return lanes *= x.lanes, *this; }
  [[gnu::always_inline]] VectorizedArray& operator/=(const VectorizedArray& x) { return lanes /= x.lanes, *this; }
  [[gnu::always_inline]] VectorizedArray& operator*=(double x) { return lanes *= x, *this; }
};
[[gnu::always_inline]] inline VectorizedArray operator-(const VectorizedArray& x) {
  return {-x.lanes};
}
[[gnu::always_inline]] inline VectorizedArray operator+(const VectorizedArray& x, const VectorizedArray& y) {
  return {x.lanes + y.lanes};
}
[[gnu::always_inline]] inline VectorizedArray operator+(double x, const VectorizedArray& y) {
  return {x + y.lanes};
}
[[gnu::always_inline]] inline VectorizedArray operator+(const VectorizedArray& x, double y) {
  return {x.lanes + y};
}
[[gnu::always_inline]] inline VectorizedArray operator-(const VectorizedArray& x, const VectorizedArray& y) {
  return {x.lanes - y.lanes};
}
[[gnu::always_inline]] inline VectorizedArray operator-(double x, const VectorizedArray& y) {
  return {x - y.lanes};
}
[[gnu::always_inline]] inline VectorizedArray operator-(const VectorizedArray& x, double y) {
  return {x.lanes - y};
}
[[gnu::always_inline]] inline VectorizedArray operator*(const VectorizedArray& x, const VectorizedArray& y) {
  return {x.lanes * y.lanes};
}
[[gnu::always_inline]] inline VectorizedArray operator*(double x, const VectorizedArray& y) {
  return {x * y.lanes};
}
[[gnu::always_inline]] inline VectorizedArray operator*(const VectorizedArray& x, double y) {
  return {x.lanes * y};
}
[[gnu::always_inline]] inline VectorizedArray operator/(const VectorizedArray& x, const VectorizedArray& y) {
  return {x.lanes / y.lanes};
}
[[gnu::always_inline]] inline VectorizedArray operator/(double x, const VectorizedArray& y) {
  return {x / y.lanes};
}
[[gnu::always_inline]] inline VectorizedArray operator/(const VectorizedArray& x, double y) {
  return {x.lanes / y};
}

/// |x|, of each lane.
[[gnu::always_inline]] inline double absolute(double x) {
  return x < 0 ? -x : x;
}
[[gnu::always_inline]] inline VectorizedArray absolute(const VectorizedArray& x) {
  return {x.lanes < 0 ? -x.lanes : x.lanes};
}
/// x, but zero where that is negative.
[[gnu::always_inline]] inline double positive_part(double x) {
  return x < 0 ? 0 : x;
}
[[gnu::always_inline]] inline VectorizedArray positive_part(const VectorizedArray& x) {
  return {x.lanes < 0 ? VectorizedArray::Lanes{} : x.lanes};
}

/// Number of batches of so many cells.
inline Index batch_count(Index cells) {
  return (cells + batch_size - 1) / batch_size;
}
/// Number of lanes of a batch that have a cell of their own; the others repeat the last cell.
inline int filled_lanes(Index cells, Index batch) {
  return static_cast<int>(std::min<Index>(batch_size, cells - batch * batch_size));
}
/// Cell in a lane of a batch.
inline Index cell_in_lane(Index cells, Index batch, int lane) {
  return std::min(batch * batch_size + lane, cells - 1);
}

/// Quadrature points of a cell: triangle_rule(4).
inline constexpr int cell_points = 6;
/// Numbers at the quadrature points of a batch, [point].
using PointValues = std::array<VectorizedArray, cell_points>;
/// Numbers of the N unknowns or nodes of a batch's cells, [unknown].
template <int N>
using UnknownValues = std::array<VectorizedArray, N>;
/// Vectors at the six nodes of a batch's cells, [component][node].
using NodeVectors = std::array<UnknownValues<6>, dim>;
/// Indices of the N unknowns or nodes of a batch's cells in a global vector, [unknown][lane].
template <int N>
using BatchIndices = std::array<std::array<Index, batch_size>, N>;

/// Nodes of a batch's cells, [node][lane].
[[gnu::always_inline]] inline void set_nodes(const std::vector<std::array<Index, 6>>& cells, Index batch,
                                             BatchIndices<6>& nodes) {
  for (int lane = 0; lane < batch_size; ++lane) {
    const auto& cell = cells[cell_in_lane(static_cast<Index>(cells.size()), batch, lane)];
    for (int i = 0; i < 6; ++i) nodes[i][lane] = cell[i];
  }
}

/// Values of a batch's first N unknowns in a global vector. The lanes are put together where they are used: a vector
/// that was stored lane by lane is slow to load.
template <std::size_t N, std::size_t M>
[[gnu::always_inline]] inline void gather(const double* values, const std::array<std::array<Index, batch_size>, M>& at,
                                          std::array<VectorizedArray, N>& x) {
  static_assert(N <= M);
  for (std::size_t i = 0; i < N; ++i)
    x[i] = VectorizedArray{values[at[i][0]], values[at[i][1]], values[at[i][2]], values[at[i][3]]};
}
/// Vectors at a batch's nodes; component a of node n is values[dim n + a].
[[gnu::always_inline]] inline void gather(const double* values, const BatchIndices<6>& nodes, NodeVectors& x) {
  for (int i = 0; i < 6; ++i) {
    const double* from[batch_size];
    for (int lane = 0; lane < batch_size; ++lane) from[lane] = values + dim * nodes[i][lane];
    for (int a = 0; a < dim; ++a) x[a][i] = VectorizedArray{from[0][a], from[1][a], from[2][a], from[3][a]};
  }
}
/// Adds the filled lanes of a batch's first N unknowns to a global vector, cell after cell.
template <std::size_t N, std::size_t M>
[[gnu::always_inline]] inline void scatter(const std::array<VectorizedArray, N>& x,
                                           const std::array<std::array<Index, batch_size>, M>& at, int filled,
                                           double* sum) {
  static_assert(N <= M);
  for (int lane = 0; lane < filled; ++lane)
    for (std::size_t i = 0; i < N; ++i) sum[at[i][lane]] += x[i][lane];
}

/// Sum over the filled lanes, of which there is at least one.
inline double sum(const VectorizedArray& x, int filled) {
  if (filled == batch_size) return (x[0] + x[2]) + (x[1] + x[3]);
  double sum = x[0];
  for (int lane = 1; lane < filled; ++lane) sum += x[lane];
  return sum;
}

/// Shape functions of a cell with N nodes and their derivatives with respect to the reference coordinates a and b, a
/// row for each of `points` points.
template <int N, int points = cell_points>
struct CellShapes {
  Eigen::Matrix<double, points, N> value, derivative_a, derivative_b;
};
/// Sets row q of the quadratic shape functions at the reference coordinates a and b.
template <int points>
inline void set_shapes(double a, double b, int q, CellShapes<6, points>& shapes) {
  const auto value = triangle_shape(a, b);
  const auto derivative = triangle_shape_derivative(a, b);
  for (int i = 0; i < 6; ++i) {
    shapes.value(q, i) = value[i];
    shapes.derivative_a(q, i) = derivative[i][0];
    shapes.derivative_b(q, i) = derivative[i][1];
  }
}
/// At the points of triangle_rule(4): quadratic on the six nodes (N = 6), or linear on the three vertices (N = 3).
template <int N>
const CellShapes<N>& cell_shapes();

/// Value at one point from those of the unknowns, by a row of shape functions or of their derivatives.
template <typename Number, int points, int N>
[[gnu::always_inline]] inline void interpolate(const Eigen::Matrix<double, points, N>& shape, int q,
                                               const std::array<Number, std::size_t(N)>& x, Number& value) {
  value = shape(q, 0) * x[0];
  for (int i = 1; i < N; ++i) value += shape(q, i) * x[i];
}
/// Values at all points.
template <int N>
[[gnu::always_inline]] inline void interpolate(const Eigen::Matrix<double, cell_points, N>& shape,
                                               const std::array<VectorizedArray, std::size_t(N)>& x,
                                               PointValues& values) {
  for (int q = 0; q < cell_points; ++q) interpolate(shape, q, x, values[q]);
}
/// The transpose of `interpolate`: adds what acts at the points to the unknowns.
template <int N>
[[gnu::always_inline]] inline void integrate(const Eigen::Matrix<double, cell_points, N>& shape,
                                             const PointValues& values,
                                             std::array<VectorizedArray, std::size_t(N)>& x) {
  for (int i = 0; i < N; ++i)
    for (int q = 0; q < cell_points; ++q) x[i] += shape(q, i) * values[q];
}

/// Isoparametric map of a quadratic cell at one point; Number is double or a batch.
template <typename Number>
struct MappedPoint {
  std::array<Number, dim> position;          ///< m
  std::array<Number, dim> along_a, along_b;  ///< derivatives with respect to the reference coordinates, m
  Number determinant;                        ///< of the Jacobian, m2; not positive where the cell is inverted
};
/// Maps point q of `shapes`; x contains the nodes' coordinates, [component][node].
template <typename Number, int points>
[[gnu::always_inline]] inline void map_point(const CellShapes<6, points>& shapes, int q,
                                             const std::array<std::array<Number, 6>, dim>& x, MappedPoint<Number>& at) {
  for (int a = 0; a < dim; ++a) {
    interpolate(shapes.value, q, x[a], at.position[a]);
    interpolate(shapes.derivative_a, q, x[a], at.along_a[a]);
    interpolate(shapes.derivative_b, q, x[a], at.along_b[a]);
  }
  at.determinant = at.along_a[0] * at.along_b[1] - at.along_b[0] * at.along_a[1];
}
/// Gradients of the six shape functions at point q, 1/m, [node][component]: the inverse transposed Jacobian times their
/// derivatives on the reference cell.
template <typename Number, int points, typename Gradients>
[[gnu::always_inline]] inline void set_gradients(const CellShapes<6, points>& shapes, int q,
                                                 const MappedPoint<Number>& at, Gradients& gradient) {
  const Number s = 1 / at.determinant;
  const Number da_dr = s * at.along_b[1], da_dz = -s * at.along_b[0];
  const Number db_dr = -s * at.along_a[1], db_dz = s * at.along_a[0];
  for (int i = 0; i < 6; ++i) {
    gradient[i][0] = shapes.derivative_a(q, i) * da_dr + shapes.derivative_b(q, i) * db_dr;
    gradient[i][1] = shapes.derivative_a(q, i) * da_dz + shapes.derivative_b(q, i) * db_dz;
  }
}

/// What a unit of cross-section area represents: 2 pi r, or 1 m; both linear in r.
struct Depth {
  double at_axis, growth;

  explicit Depth(Geometry geometry)
      : at_axis(core::depth(geometry, Point::Zero())), growth(core::depth(geometry, Point::Ones()) - at_axis) {}
  template <typename Number>
  [[gnu::always_inline]] void set(const Number& r, Number& depth) const {
    depth = at_axis + growth * r;
  }
};

}  // namespace parison::core
