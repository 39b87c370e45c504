// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled as cells/cell_kernels.cpp is.
#include "thermal/radiation/light_cells.hpp"

#include "thermal/problem.hpp"

namespace parison::thermal {

namespace {

template <int N>
[[gnu::always_inline]] inline void interpolate_all(const BatchIndices<6>* batches, const double* unknowns,
                                                   Field& values) {
  UnknownValues<N> own;
  for (std::size_t g = 0; g < values.size(); ++g) {
    core::gather(unknowns, batches[g], own);
    core::interpolate(cell_shapes<N>().value, own, values[g]);
  }
}

template <int N>
[[gnu::always_inline]] inline void integrate_all(const BatchIndices<6>* batches, const Field& values,
                                                 double* unknowns) {
  for (std::size_t g = 0; g < values.size(); ++g) {
    UnknownValues<N> sum{};
    core::integrate(cell_shapes<N>().value, values[g], sum);
    core::scatter(sum, batches[g], batch_size, unknowns);
  }
}

template <int N>
[[gnu::always_inline]] inline void set_local(const CellBatch& cells, const PointValues& volume,
                                             const PointValues* relative, double mean_diffusion, double mean_absorption,
                                             std::array<UnknownValues<N>, N>& local) {
  const auto& shapes = cell_shapes<N>();
  local = {};
  for (int q = 0; q < core::cell_points; ++q) {
    const VectorizedArray more = relative ? (*relative)[q] : VectorizedArray{} + 1;
    const VectorizedArray diffusion = mean_diffusion / more, absorption = mean_absorption * more;
    for (int j = 0; j < N; ++j) {
      const double da = shapes.derivative_a(q, j), db = shapes.derivative_b(q, j);
      const VectorizedArray flow_a = diffusion * (da * cells.aa[q] + db * cells.ab[q]),
                            flow_b = diffusion * (da * cells.ab[q] + db * cells.bb[q]),
                            absorbed = absorption * shapes.value(q, j) * volume[q];
      for (int i = j; i < N; ++i)
        local[i][j] +=
            shapes.derivative_a(q, i) * flow_a + shapes.derivative_b(q, i) * flow_b + shapes.value(q, i) * absorbed;
    }
  }
}

template <int N>
[[gnu::always_inline]] inline void assemble_of_order(const std::vector<CellBatch>& cells, const Field& volumes,
                                                     const Field* relative, core::Index cell_count, double diffusion,
                                                     double absorption, core::Assembly& assembly) {
  std::array<UnknownValues<N>, N> local;
  std::array<double, N * N> of_cell{};
  for (std::size_t g = 0; g < cells.size(); ++g) {
    set_local<N>(cells[g], volumes[g], relative ? &(*relative)[g] : nullptr, diffusion, absorption, local);
    const auto batch = static_cast<core::Index>(g);
    for (int lane = 0; lane < core::filled_lanes(cell_count, batch); ++lane) {
      for (int i = 0; i < N; ++i)
        for (int j = 0; j <= i; ++j) of_cell[i * N + j] = local[i][j][lane];
      core::add_clique(assembly.matrix, assembly.scatter, batch_size * batch + lane, N, of_cell.data());
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

[[gnu::target_clones("avx2", "default")]] Field at_points(const BatchIndices<6>* batches, std::size_t count, int order,
                                                          const double* unknowns) {
  Field values(count);
  if (order == 2)
    interpolate_all<6>(batches, unknowns, values);
  else
    interpolate_all<3>(batches, unknowns, values);
  return values;
}

[[gnu::target_clones("avx2", "default")]] void add_from_points(const BatchIndices<6>* batches, const Field& values,
                                                               int order, double* unknowns) {
  if (order == 2)
    integrate_all<6>(batches, values, unknowns);
  else
    integrate_all<3>(batches, values, unknowns);
}

[[gnu::target_clones("avx2", "default")]] void assemble_group(const std::vector<CellBatch>& cells, const Field& volumes,
                                                              const Field* relative, core::Index cell_count, int order,
                                                              double diffusion, double absorption,
                                                              core::Assembly& assembly) {
  if (order == 2)
    assemble_of_order<6>(cells, volumes, relative, cell_count, diffusion, absorption, assembly);
  else
    assemble_of_order<3>(cells, volumes, relative, cell_count, diffusion, absorption, assembly);
}

}  // namespace parison::thermal
