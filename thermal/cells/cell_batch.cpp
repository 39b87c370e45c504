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
      const auto slope = core::triangle_shape_derivative(rule[q].a, rule[q].b);
      for (int i = 0; i < 6; ++i) {
        made.value(q, i) = value[i];
        made.slope_a(q, i) = slope[i][0];
        made.slope_b(q, i) = slope[i][1];
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
      made.slope_a.row(q) << -1, 1, 0;
      made.slope_b.row(q) << -1, 0, 1;
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
  Packs<core::dim> along_a, along_b;  ///< derivatives of the position
  Pack determinant, depth;
};
using NodePacks = std::array<Packs<core::dim>, 6>;

[[gnu::always_inline]] inline void gather_nodes(const core::Mesh& mesh, const std::array<Index, group_size>& cells,
                                                NodePacks& nodes) {
  for (int i = 0; i < 6; ++i) {
    const auto node = [&](int c) -> const core::Point& { return mesh.nodes[mesh.cells[cells[c]][i]]; };
    for (int d = 0; d < core::dim; ++d) nodes[i][d] = Pack{node(0)[d], node(1)[d], node(2)[d], node(3)[d]};
  }
}

[[gnu::always_inline]] inline void map_at(const NodePacks& nodes, core::Geometry geometry, int q, Map& map) {
  const CellShapes<6>& shapes = cell_shapes<6>();
  Packs<core::dim> x{};
  map.along_a = map.along_b = {};
  for (int i = 0; i < 6; ++i)
    for (int d = 0; d < core::dim; ++d) {
      x[d] += shapes.value(q, i) * nodes[i][d];
      map.along_a[d] += shapes.slope_a(q, i) * nodes[i][d];
      map.along_b[d] += shapes.slope_b(q, i) * nodes[i][d];
    }
  map.determinant = map.along_a[0] * map.along_b[1] - map.along_a[1] * map.along_b[0];
  const auto depth = [&](int c) { return core::depth(geometry, core::Point(x[0][c], x[1][c])); };
  map.depth = Pack{depth(0), depth(1), depth(2), depth(3)};
}

/// Factors on the Rosseland conductivity. Thickness is linear in the cell: a quadratic through jumps would turn
/// negative.
[[gnu::always_inline]] inline void set_thin_wall(const BodyView& body, const std::array<Index, group_size>& cells,
                                                 PointPacks& factor) {
  Packs<3> own;
  PointPacks thickness;
  for (int i = 0; i < 3; ++i) {
    const auto at = [&](int c) { return (*body.wall_thickness)[body.mesh->cells[cells[c]][i]]; };
    own[i] = Pack{at(0), at(1), at(2), at(3)};
  }
  interpolate<3>(cell_shapes<3>().value, own, thickness);
  for (int q = 0; q < 6; ++q) factor[q] = thin_wall_factor(*body.material->radiation, thickness[q]);
}

[[gnu::always_inline]] inline void set_group(const BodyView& body, core::Geometry geometry,
                                             const std::array<Index, group_size>& cells, const Pack& there,
                                             CellGroup& group) {
  const auto& rule = core::triangle_rule(4);
  const bool same = body.mesh == body.mass_mesh;
  NodePacks now, before;
  gather_nodes(*body.mesh, cells, now);
  if (!same) gather_nodes(*body.mass_mesh, cells, before);
  for (int q = 0; q < 6; ++q) {
    Map map, then;
    map_at(now, geometry, q, map);
    if (same)
      then = map;
    else
      map_at(before, geometry, q, then);
    const Pack &ua = map.along_a[0], &va = map.along_a[1], &ub = map.along_b[0], &vb = map.along_b[1];
    const Pack scale = there * rule[q].weight * map.depth / map.determinant;
    group.aa[q] = scale * (ub * ub + vb * vb);
    group.ab[q] = -scale * (ua * ub + va * vb);
    group.bb[q] = scale * (ua * ua + va * va);
    group.mass[q] = there * body.density * rule[q].weight * then.determinant * then.depth;
    group.thin_wall[q] = Pack{} + 1;
  }
  if (has_thin_wall(body)) set_thin_wall(body, cells, group.thin_wall);
}

}  // namespace

[[gnu::target_clones("avx2", "default")]] std::vector<CellGroup> make_groups(const BodyView& body,
                                                                             core::Geometry geometry) {
  const Index count = body.mesh->cell_count();
  std::vector<CellGroup> groups((count + group_size - 1) / group_size);
  for (Index first = 0; first < count; first += group_size) {
    std::array<Index, group_size> cells;
    for (int c = 0; c < group_size; ++c) cells[c] = std::min(first + c, count - 1);
    const Pack there{1, double(first + 1 < count), double(first + 2 < count), double(first + 3 < count)};
    set_group(body, geometry, cells, there, groups[first / group_size]);
  }
  return groups;
}

}  // namespace parison::thermal
