// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled as cell_kernels.cpp is.
#include "thermal/cells/cell_batch.hpp"

#include <algorithm>

#include "thermal/problem.hpp"
#include "thermal/properties.hpp"

namespace parison::thermal {

template <>
const CellShapes<6>& cell_shapes<6>() {
  static const CellShapes<6> shapes = [] {
    CellShapes<6> made;
    const auto& rule = core::triangle_rule(4);
    for (std::size_t q = 0; q < rule.size(); ++q) {
      const auto value = core::triangle_shape(rule[q].a, rule[q].b);
      const auto derivative = core::triangle_shape_derivative(rule[q].a, rule[q].b);
      for (int i = 0; i < 6; ++i) {
        made.value(q, i) = value[i];
        made.derivative_a(q, i) = derivative[i][0];
        made.derivative_b(q, i) = derivative[i][1];
      }
    }
    return made;
  }();
  return shapes;
}

template <>
const CellShapes<3>& cell_shapes<3>() {
  static const CellShapes<3> shapes = [] {
    CellShapes<3> made;
    const auto& rule = core::triangle_rule(4);
    for (std::size_t q = 0; q < rule.size(); ++q) {
      made.value.row(q) << 1 - rule[q].a - rule[q].b, rule[q].a, rule[q].b;
      made.derivative_a.row(q) << -1, 1, 0;
      made.derivative_b.row(q) << -1, 0, 1;
    }
    return made;
  }();
  return shapes;
}

const EdgeShapes& edge_shapes() {
  static const EdgeShapes shapes = [] {
    EdgeShapes made;
    const auto& rule = core::edge_rule(3);
    for (std::size_t q = 0; q < made.size(); ++q) made[q] = core::edge_shape(rule[q].s);
    return made;
  }();
  return shapes;
}

namespace {

/// Jacobian of the cells' map at a point of triangle_rule(4).
struct Map {
  VectorizedArrays<core::dim> along_a, along_b;  ///< derivatives of the position
  VectorizedArray determinant, depth;
};
using NodeValues = std::array<VectorizedArrays<core::dim>, 6>;

[[gnu::always_inline]] inline void gather_nodes(const core::Mesh& mesh, const std::array<Index, batch_size>& cells,
                                                NodeValues& nodes) {
  for (int i = 0; i < 6; ++i) {
    const auto node = [&](int c) -> const core::Point& { return mesh.nodes[mesh.cells()[cells[c]][i]]; };
    for (int d = 0; d < core::dim; ++d) nodes[i][d] = VectorizedArray{node(0)[d], node(1)[d], node(2)[d], node(3)[d]};
  }
}

[[gnu::always_inline]] inline void map_at(const NodeValues& nodes, core::Geometry geometry, int q, Map& map) {
  const CellShapes<6>& shapes = cell_shapes<6>();
  VectorizedArrays<core::dim> x{};
  map.along_a = map.along_b = {};
  for (int i = 0; i < 6; ++i)
    for (int d = 0; d < core::dim; ++d) {
      x[d] += shapes.value(q, i) * nodes[i][d];
      map.along_a[d] += shapes.derivative_a(q, i) * nodes[i][d];
      map.along_b[d] += shapes.derivative_b(q, i) * nodes[i][d];
    }
  map.determinant = map.along_a[0] * map.along_b[1] - map.along_a[1] * map.along_b[0];
  const auto depth = [&](int c) { return core::depth(geometry, core::Point(x[0][c], x[1][c])); };
  map.depth = VectorizedArray{depth(0), depth(1), depth(2), depth(3)};
}

/// Factors on the Rosseland conductivity. Thickness is linear in the cell: a quadratic through jumps would turn
/// negative.
[[gnu::always_inline]] inline void set_thin_wall(const BodyView& body, const std::array<Index, batch_size>& cells,
                                                 PointValues& factor) {
  VectorizedArrays<3> own;
  PointValues thickness;
  for (int i = 0; i < 3; ++i) {
    const auto at = [&](int c) { return (*body.wall_thickness)[body.mesh->cells()[cells[c]][i]]; };
    own[i] = VectorizedArray{at(0), at(1), at(2), at(3)};
  }
  interpolate<3>(cell_shapes<3>().value, own, thickness);
  for (int q = 0; q < 6; ++q) factor[q] = thin_wall_factor(*body.material->radiation, thickness[q]);
}

[[gnu::always_inline]] inline void set_batch(const BodyView& body, core::Geometry geometry,
                                             const std::array<Index, batch_size>& cells, const VectorizedArray& there,
                                             CellBatch& batch) {
  const auto& rule = core::triangle_rule(4);
  const bool same = body.mesh == body.mass_mesh;
  NodeValues now, before;
  gather_nodes(*body.mesh, cells, now);
  if (!same) gather_nodes(*body.mass_mesh, cells, before);
  for (int q = 0; q < 6; ++q) {
    Map map, then;
    map_at(now, geometry, q, map);
    if (same)
      then = map;
    else
      map_at(before, geometry, q, then);
    const VectorizedArray &ua = map.along_a[0], &va = map.along_a[1], &ub = map.along_b[0], &vb = map.along_b[1];
    const VectorizedArray scale = there * rule[q].weight * map.depth / map.determinant;
    batch.aa[q] = scale * (ub * ub + vb * vb);
    batch.ab[q] = -scale * (ua * ub + va * vb);
    batch.bb[q] = scale * (ua * ua + va * va);
    batch.mass[q] = there * body.density * rule[q].weight * then.determinant * then.depth;
    batch.thin_wall[q] = VectorizedArray{} + 1;
  }
  if (has_thin_wall(body)) set_thin_wall(body, cells, batch.thin_wall);
}

}  // namespace

[[gnu::target_clones("avx2", "default")]] std::vector<CellBatch> make_batches(const BodyView& body,
                                                                              core::Geometry geometry) {
  const Index count = body.mesh->cell_count();
  std::vector<CellBatch> batches((count + batch_size - 1) / batch_size);
  for (Index first = 0; first < count; first += batch_size) {
    std::array<Index, batch_size> cells;
    for (int c = 0; c < batch_size; ++c) cells[c] = std::min(first + c, count - 1);
    const VectorizedArray there{1, double(first + 1 < count), double(first + 2 < count), double(first + 3 < count)};
    set_batch(body, geometry, cells, there, batches[first / batch_size]);
  }
  return batches;
}

}  // namespace parison::thermal
