// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled as cell_kernels.cpp is.
#include "thermal/cells/cell_batch.hpp"

#include "thermal/problem.hpp"
#include "thermal/properties.hpp"

namespace parison::thermal {

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

using MappedPoint = core::MappedPoint<VectorizedArray>;

/// Factors on the Rosseland conductivity. Thickness is linear in the cell: a quadratic through jumps would turn
/// negative.
[[gnu::always_inline]] inline void set_thin_wall(const BodyView& body, const BatchIndices<6>& nodes,
                                                 PointValues& factor) {
  const BatchIndices<3> vertices{nodes[0], nodes[1], nodes[2]};
  UnknownValues<3> at_vertices;
  PointValues thickness;
  core::gather(body.wall_thickness->data(), vertices, at_vertices);
  core::interpolate(cell_shapes<3>().value, at_vertices, thickness);
  for (int q = 0; q < core::cell_points; ++q) factor[q] = thin_wall_factor(*body.material->radiation, thickness[q]);
}

/// Gives the points the mass of the density that their temperature had where the mass lies.
void weigh_by_density(const BodyView& body, const BatchIndices<6>& nodes, CellBatch& batch) {
  UnknownValues<6> at_nodes;
  PointValues temperature, density;
  core::gather(body.mass_temperature->data(), nodes, at_nodes);
  core::interpolate(cell_shapes<6>().value, at_nodes, temperature);
  detail::set_each(temperature, body.material->relative_density, density);
  for (int q = 0; q < core::cell_points; ++q) batch.mass[q] *= density[q];
}

[[gnu::always_inline]] inline void set_batch(const BodyView& body, const core::Depth& depth,
                                             const BatchIndices<6>& nodes, const VectorizedArray& filled,
                                             CellBatch& batch) {
  const auto& rule = core::triangle_rule(4);
  const auto& shapes = cell_shapes<6>();
  const bool same = body.mesh == body.mass_mesh;
  core::NodeVectors now, before;
  core::gather(body.mesh->nodes.front().data(), nodes, now);
  if (!same) core::gather(body.mass_mesh->nodes.front().data(), nodes, before);
  for (int q = 0; q < core::cell_points; ++q) {
    MappedPoint at, mass_at;
    VectorizedArray depth_there, mass_depth;
    core::map_point(shapes, q, now, at);
    if (same)
      mass_at = at;
    else
      core::map_point(shapes, q, before, mass_at);
    depth.set(at.position[0], depth_there);
    depth.set(mass_at.position[0], mass_depth);
    const VectorizedArray &ua = at.along_a[0], &va = at.along_a[1], &ub = at.along_b[0], &vb = at.along_b[1];
    const VectorizedArray scale = filled * rule[q].weight * depth_there / at.determinant;
    batch.aa[q] = scale * (ub * ub + vb * vb);
    batch.ab[q] = -scale * (ua * ub + va * vb);
    batch.bb[q] = scale * (ua * ua + va * va);
    batch.mass[q] = filled * body.density * rule[q].weight * mass_at.determinant * mass_depth;
    batch.thin_wall[q] = VectorizedArray{} + 1;
  }
  if (has_thin_wall(body)) set_thin_wall(body, nodes, batch.thin_wall);
  if (body.mass_temperature) weigh_by_density(body, nodes, batch);
}

}  // namespace

[[gnu::target_clones("avx2", "default")]] std::vector<CellBatch> make_batches(const BodyView& body,
                                                                              core::Geometry geometry) {
  const Index count = body.mesh->cell_count();
  const core::Depth depth(geometry);
  std::vector<CellBatch> batches(core::batch_count(count));
  BatchIndices<6> nodes;
  for (Index b = 0; b < core::batch_count(count); ++b) {
    const int lanes = core::filled_lanes(count, b);
    const VectorizedArray filled{1, double(lanes > 1), double(lanes > 2), double(lanes > 3)};
    core::set_nodes(body.mesh->cells(), b, nodes);
    set_batch(body, depth, nodes, filled, batches[b]);
  }
  return batches;
}

}  // namespace parison::thermal
