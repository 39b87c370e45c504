// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/solid/spline_patch.hpp"

#include "core/solid/hex_element.hpp"

namespace parison::forming {

namespace {

using core::Vector3;

/// Tangent of a line through three points at the middle one, by its index: in the direction of the parabola by chord
/// length, as long as the harmonic mean of the chords. Neither passes what lies beside the longer one.
Vector3 middle_tangent(const Vector3& before, const Vector3& at, const Vector3& after) {
  const double in = (at - before).norm(), out = (after - at).norm(), both = in + out;
  if (in == 0 || out == 0) return Vector3::Zero();
  return 2 / (both * both) * (out * out * (at - before) + in * in * (after - at));
}

/// The same at the first of them.
Vector3 end_tangent(const Vector3& at, const Vector3& next, const Vector3& over_next) {
  const double first = (next - at).norm(), second = (over_next - next).norm();
  if (first == 0 || second == 0) return next - at;
  const double share = first / (first + second);
  return (1 + share) * (next - at) - share * first / second * (over_next - next);
}

/// Nodes of a grid with tangents.
class Grid {
 public:
  Grid(const GridNode& node, int spans_u, int spans_v) : node_(node), spans_{spans_u, spans_v} {}

  const Vector3& at(int i, int j) const { return *node_(i, j); }
  /// Along u (`axis` 0) or v.
  Vector3 tangent(int i, int j, int axis) const {
    const auto beside = [&](int step) { return axis == 0 ? node_(i + step, j) : node_(i, j + step); };
    const Vector3 *before = beside(-1), *after = beside(1);
    if (before && after) return middle_tangent(*before, at(i, j), *after);
    if (after) return end_tangent(at(i, j), *after, *beside(2));
    return -end_tangent(at(i, j), *before, *beside(-2));
  }
  /// Mixed derivative, by the nodes around.
  Vector3 twist(int i, int j) const {
    int low[2] = {i - 1, j - 1}, high[2] = {i + 1, j + 1};
    for (const bool along_u : {true, false}) {
      const int axis = along_u ? 0 : 1;
      for (const int other : {low[1 - axis], high[1 - axis]}) {
        const auto is_there = [&](int k) { return (along_u ? node_(k, other) : node_(other, k)) != nullptr; };
        if (low[axis] < 0 && !is_there(low[axis])) low[axis] = 0;
        if (high[axis] > spans_[axis] && !is_there(high[axis])) high[axis] = spans_[axis];
      }
    }
    const double steps = double(high[0] - low[0]) * (high[1] - low[1]);
    return (at(high[0], high[1]) - at(low[0], high[1]) - at(high[0], low[1]) + at(low[0], low[1])) / steps;
  }

 private:
  const GridNode& node_;
  int spans_[2];
};

/// The node that a control point belongs to, and on which side of it the point is: none at the ends.
struct ControlPlace {
  int node, side;
};
ControlPlace control_place(int index, int spans) {
  const bool is_end = index == 0 || index == 2 * spans + 1;
  return {index / 2, is_end ? 0 : index % 2 == 0 ? -1 : 1};
}

/// A point of the quadratic faces whose corners are the nodes with even numbers.
Vector3 on_face(const Grid& grid, double u, double v) {
  const int i = 2 * static_cast<int>(u / 2), j = 2 * static_cast<int>(v / 2);
  const auto along = core::line_shape(0.5 * (u - i)), across = core::line_shape(0.5 * (v - j));
  Vector3 sum = Vector3::Zero();
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) sum += along[a] * across[b] * grid.at(i + a, j + b);
  return sum;
}

}  // namespace

SplinePatch spline_patch(const GridNode& node, int spans_u, int spans_v) {
  const Grid grid(node, spans_u, spans_v);
  SplinePatch patch{spans_u, spans_v, {}, {}};
  for (int k = 0; k < 2 * spans_u + 2; ++k)
    for (int l = 0; l < 2 * spans_v + 2; ++l) {
      const auto [i, side_u] = control_place(k, spans_u);
      const auto [j, side_v] = control_place(l, spans_v);
      patch.control.push_back(grid.at(i, j) + side_u / 3.0 * grid.tangent(i, j, 0) +
                              side_v / 3.0 * grid.tangent(i, j, 1) + side_u * side_v / 9.0 * grid.twist(i, j));
    }
  for (int i = 0; i <= spans_u; ++i)
    for (int j = 0; j <= spans_v; ++j) {
      patch.places.push_back({double(i), double(j), grid.at(i, j)});
      if (i < spans_u && j < spans_v) patch.places.push_back({i + 0.5, j + 0.5, on_face(grid, i + 0.5, j + 0.5)});
    }
  return patch;
}

}  // namespace parison::forming
