// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/cell_map.hpp"

namespace parison::core {

namespace {

/// A change of the reference coordinates after which Newton's method, which squares it, has reached round-off.
constexpr double tolerance = 1e-7;
constexpr int most_iterations = 30;
/// Reference coordinates of points that the map does not reach.
constexpr double diverged = 1e3;

[[gnu::always_inline]] inline bool all_below(double x, double bound) {
  return x < bound;
}
[[gnu::always_inline]] inline bool all_below(const VectorizedArray& x, double bound) {
  bool below = true;
  for (int lane = 0; lane < batch_size; ++lane) below &= x[lane] < bound;
  return below;
}

/// |x| + |y|.
template <typename Number>
[[gnu::always_inline]] inline void set_size(const Number& x, const Number& y, Number& size) {
  size = absolute(x) + absolute(y);
}

/// Coordinates in the triangle of the chords of points `target`, which are relative to the origin.
template <typename Number>
[[gnu::always_inline]] inline void set_chord_coordinates(const CellMap& map, const std::array<Number, 2>& target,
                                                         std::array<Number, 2>& at) {
  const Point &u = map.u, &v = map.v;
  const double area = u[0] * v[1] - u[1] * v[0];
  at[0] = (target[0] * v[1] - target[1] * v[0]) / area;
  at[1] = (u[0] * target[1] - u[1] * target[0]) / area;
}

/// One step of Newton's method on x(a, b) = u a + v b + 4 (c a m + a b n + b c p), c = 1 - a - b.
template <typename Number>
[[gnu::always_inline]] inline void newton_step(const CellMap& map, const std::array<Number, 2>& target,
                                               std::array<Number, 2>& at, Number& change) {
  const auto& [m, n, p] = map.mid_side_offset;
  const Number a = at[0], b = at[1], c = 1 - a - b;
  const Number ca = 4 * c * a, ab = 4 * a * b, bc = 4 * b * c;
  const Number c_a = 4 * (c - a), c_b = 4 * (c - b), a4 = 4 * a, b4 = 4 * b;
  Number residual[dim], along_a[dim], along_b[dim];
  for (int k = 0; k < dim; ++k) {
    residual[k] = target[k] - a * map.u[k] - b * map.v[k] - ca * m[k] - ab * n[k] - bc * p[k];
    along_a[k] = map.u[k] + c_a * m[k] + b4 * (n[k] - p[k]);
    along_b[k] = map.v[k] + c_b * p[k] + a4 * (n[k] - m[k]);
  }
  const Number scale = 1 / (along_a[0] * along_b[1] - along_a[1] * along_b[0]);
  const Number da = scale * (residual[0] * along_b[1] - residual[1] * along_b[0]);
  const Number db = scale * (along_a[0] * residual[1] - along_a[1] * residual[0]);
  at[0] += da;
  at[1] += db;
  set_size(da, db, change);
}

/// Inverts the map at `count` points or batches of points, [point][component].
template <typename Number, std::size_t count>
[[gnu::always_inline]] inline void newton(const CellMap& map, const std::array<std::array<Number, dim>, count>& x,
                                          std::array<std::array<Number, 2>, count>& at) {
  std::array<std::array<Number, dim>, count> target;
  for (std::size_t k = 0; k < count; ++k) {
    for (int d = 0; d < dim; ++d) target[k][d] = x[k][d] - map.origin[d];
    set_chord_coordinates(map, target[k], at[k]);
  }
  bool iterate = true;
  for (int iteration = 0; iterate && iteration < most_iterations; ++iteration) {
    bool converged = true, bounded = true;
    for (std::size_t k = 0; k < count; ++k) {
      Number change, size;
      newton_step(map, target[k], at[k], change);
      set_size(at[k][0], at[k][1], size);
      converged &= all_below(change, tolerance);
      bounded &= all_below(size, diverged);
    }
    iterate = !converged && bounded;
  }
}

}  // namespace

CellMap cell_map(const Mesh& mesh, Index cell) {
  const auto& n = mesh.cells()[cell];
  const auto at = [&](int k) -> const Point& { return mesh.nodes[n[k]]; };
  return {at(0),
          at(1) - at(0),
          at(2) - at(0),
          {at(3) - 0.5 * (at(0) + at(1)), at(4) - 0.5 * (at(1) + at(2)), at(5) - 0.5 * (at(2) + at(0))}};
}

std::array<double, 2> chord_coordinates(const CellMap& map, const Point& x) {
  std::array<double, 2> at;
  set_chord_coordinates(map, {x[0] - map.origin[0], x[1] - map.origin[1]}, at);
  return at;
}

std::array<double, 2> invert(const CellMap& map, const Point& x) {
  std::array<std::array<double, 2>, 1> at;
  newton(map, std::array<std::array<double, dim>, 1>{{{x[0], x[1]}}}, at);
  return at[0];
}

[[gnu::target_clones("avx2", "default")]] void invert(const CellMap& map, const PointBatches& x,
                                                      PointBatches& reference) {
  newton(map, x, reference);
}

std::array<double, 2> invert_cell_map(const Mesh& mesh, Index cell, const Point& x) {
  return invert(cell_map(mesh, cell), x);
}

}  // namespace parison::core
