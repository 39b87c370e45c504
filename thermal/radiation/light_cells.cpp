// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled as cells/cell_kernels.cpp is.
#include "thermal/radiation/light_cells.hpp"

#include "thermal/problem.hpp"

namespace parison::thermal {

namespace {

[[gnu::always_inline]] inline void set_local(const CellBatch& cells, const PointValues& volume,
                                             const PointValues* relative, double mean_diffusion, double mean_absorption,
                                             std::array<UnknownValues<6>, 6>& local) {
  const auto& shapes = cell_shapes<6>();
  local = {};
  for (int q = 0; q < core::cell_points; ++q) {
    const VectorizedArray more = relative ? (*relative)[q] : VectorizedArray{} + 1;
    const VectorizedArray diffusion = mean_diffusion / more, absorption = mean_absorption * more;
    for (int j = 0; j < 6; ++j) {
      const double da = shapes.derivative_a(q, j), db = shapes.derivative_b(q, j);
      const VectorizedArray flow_a = diffusion * (da * cells.aa[q] + db * cells.ab[q]),
                            flow_b = diffusion * (da * cells.ab[q] + db * cells.bb[q]),
                            absorbed = absorption * shapes.value(q, j) * volume[q];
      for (int i = j; i < 6; ++i)
        local[i][j] +=
            shapes.derivative_a(q, i) * flow_a + shapes.derivative_b(q, i) * flow_b + shapes.value(q, i) * absorbed;
    }
  }
}

}  // namespace

[[gnu::target_clones("avx2", "default")]] Field make_volumes(const BodyView& body, core::Geometry geometry) {
  const auto& rule = core::triangle_rule(4);
  const core::Depth depth(geometry);
  const core::Index count = body.mesh->cell_count();
  Field volumes(core::batch_count(count));
  BatchIndices<6> nodes;
  core::NodeVectors x;
  for (core::Index b = 0; b < core::batch_count(count); ++b) {
    const int lanes = core::filled_lanes(count, b);
    const VectorizedArray filled{1, double(lanes > 1), double(lanes > 2), double(lanes > 3)};
    core::set_nodes(body.mesh->cells(), b, nodes);
    core::gather(body.mesh->nodes.front().data(), nodes, x);
    for (int q = 0; q < core::cell_points; ++q) {
      core::MappedPoint<VectorizedArray> at;
      VectorizedArray depth_there;
      core::map_point(cell_shapes<6>(), q, x, at);
      depth.set(at.position[0], depth_there);
      volumes[b][q] = filled * rule[q].weight * at.determinant * depth_there;
    }
  }
  return volumes;
}

[[gnu::target_clones("avx2", "default")]] Field at_points(const BatchIndices<6>* batches, std::size_t count,
                                                          const double* unknowns) {
  Field values(count);
  UnknownValues<6> own;
  for (std::size_t g = 0; g < count; ++g) {
    core::gather(unknowns, batches[g], own);
    core::interpolate(cell_shapes<6>().value, own, values[g]);
  }
  return values;
}

[[gnu::target_clones("avx2", "default")]] void add_from_points(const BatchIndices<6>* batches, const Field& values,
                                                               double* unknowns) {
  for (std::size_t g = 0; g < values.size(); ++g) {
    UnknownValues<6> sum{};
    core::integrate(cell_shapes<6>().value, values[g], sum);
    core::scatter(sum, batches[g], batch_size, unknowns);
  }
}

[[gnu::target_clones("avx2", "default")]] void assemble_group(const std::vector<CellBatch>& cells, const Field& volumes,
                                                              const Field* relative, core::Index cell_count,
                                                              double diffusion, double absorption,
                                                              core::Assembly& assembly) {
  std::array<UnknownValues<6>, 6> local;
  std::array<double, 36> of_cell{};
  for (std::size_t g = 0; g < cells.size(); ++g) {
    set_local(cells[g], volumes[g], relative ? &(*relative)[g] : nullptr, diffusion, absorption, local);
    const auto batch = static_cast<core::Index>(g);
    for (int lane = 0; lane < core::filled_lanes(cell_count, batch); ++lane) {
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j <= i; ++j) of_cell[6 * i + j] = local[i][j][lane];
      core::add_clique(assembly.matrix, assembly.scatter, batch_size * batch + lane, 6, of_cell.data());
    }
  }
}

}  // namespace parison::thermal
