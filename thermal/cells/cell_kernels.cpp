// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled with -O3 and, where the processor has it, for AVX2: lane by lane the same operations, so the same bits.
#include "thermal/cells/cell_kernels.hpp"

namespace parison::thermal {

namespace {

/// Derivatives with respect to the reference coordinates.
struct Gradient {
  PointValues along_a, along_b;
};

/// Calls work(laws of the body, batch, number of the batch in the system) for each batch of each body.
template <typename Work>
[[gnu::always_inline]] inline void for_each_batch(const HeatSystem& system, const Work& work) {
  for (const BodyLaws& laws : system.bodies)
    for (Index g = 0; g < laws.batch_count(); ++g) work(laws, (*laws.cells)[g], laws.first_batch + g);
}

/// Metric times gradient: minus the heat flow for a conductivity of 1.
[[gnu::always_inline]] inline void set_flow(const CellBatch& cells, const Gradient& T, Gradient& flow) {
  for (int q = 0; q < 6; ++q) {
    flow.along_a[q] = cells.aa[q] * T.along_a[q] + cells.ab[q] * T.along_b[q];
    flow.along_b[q] = cells.ab[q] * T.along_a[q] + cells.bb[q] * T.along_b[q];
  }
}

/// Temperature and its gradient at the quadrature points.
[[gnu::always_inline]] inline void set_at_points(const UnknownValues<6>& own, PointValues& at, Gradient& gradient) {
  const CellShapes<6>& shapes = cell_shapes<6>();
  core::interpolate(shapes.value, own, at);
  core::interpolate(shapes.derivative_a, own, gradient.along_a);
  core::interpolate(shapes.derivative_b, own, gradient.along_b);
}

}  // namespace

[[gnu::target_clones("avx2", "default")]] void add_cells(const HeatSystem& system, const Eigen::VectorXd& temperature,
                                                         const Eigen::VectorXd* rate, Response& response) {
  const CellShapes<6>& shapes = cell_shapes<6>();
  const auto work = [&](const BodyLaws& laws, const CellBatch& cells, Index g) __attribute__((always_inline)) {
    const BatchIndices<6>& unknowns = system.batches[g];
    UnknownValues<6> own{}, content{}, power{};
    PointValues at, stored, k;
    Gradient gradient, flow;
    core::gather(temperature.data(), unknowns, own);
    set_at_points(own, at, gradient);
    laws.conductivity.set_values(at, cells.thin_wall, k);
    set_flow(cells, gradient, flow);
    if (rate) {
      PointValues change;
      core::gather(rate->data(), unknowns, own);
      core::interpolate(shapes.value, own, change);
      laws.enthalpy.set_capacities(at, stored);
      for (int q = 0; q < 6; ++q) stored[q] *= change[q];
    } else {
      laws.enthalpy.set_enthalpies(at, stored);
    }
    for (int q = 0; q < 6; ++q) {
      stored[q] *= cells.mass[q];
      flow.along_a[q] *= -k[q];
      flow.along_b[q] *= -k[q];
    }
    core::integrate(shapes.value, stored, content);
    core::integrate(shapes.derivative_a, flow.along_a, power);
    core::integrate(shapes.derivative_b, flow.along_b, power);
    core::scatter(content, unknowns, batch_size, response.content.data());
    core::scatter(power, unknowns, batch_size, response.power.data());
  };
  for_each_batch(system, work);
}

[[gnu::target_clones("avx2", "default")]] void linearise_cells(const HeatSystem& system,
                                                               const Eigen::VectorXd& temperature,
                                                               std::vector<BatchDerivatives>& batches) {
  batches.resize(system.batches.size());
  const auto work = [&](const BodyLaws& laws, const CellBatch& cells, Index g) __attribute__((always_inline)) {
    UnknownValues<6> own{};
    PointValues at, dk_dT;
    Gradient gradient, flow;
    core::gather(temperature.data(), system.batches[g], own);
    set_at_points(own, at, gradient);
    set_flow(cells, gradient, flow);
    BatchDerivatives& derivatives = batches[g];
    laws.enthalpy.set_capacities(at, derivatives.capacity);
    laws.conductivity.set_values(at, cells.thin_wall, derivatives.conductivity);
    laws.conductivity.set_derivatives(at, cells.thin_wall, dk_dT);
    for (int q = 0; q < 6; ++q) {
      derivatives.capacity[q] *= cells.mass[q];
      derivatives.flow_a[q] = dk_dT[q] * flow.along_a[q];
      derivatives.flow_b[q] = dk_dT[q] * flow.along_b[q];
    }
  };
  for_each_batch(system, work);
}

[[gnu::target_clones("avx2", "default")]] void apply_cells(const HeatSystem& system,
                                                           const std::vector<BatchDerivatives>& batches, double step,
                                                           const Eigen::VectorXd& change, Eigen::VectorXd& result) {
  const CellShapes<6>& shapes = cell_shapes<6>();
  const auto work = [&](const BodyLaws&, const CellBatch& cells, Index g) __attribute__((always_inline)) {
    UnknownValues<6> own{}, sum{};
    PointValues at;
    Gradient gradient, flow;
    core::gather(change.data(), system.batches[g], own);
    set_at_points(own, at, gradient);
    set_flow(cells, gradient, flow);
    const BatchDerivatives& derivatives = batches[g];
    for (int q = 0; q < 6; ++q) {
      flow.along_a[q] = step * (derivatives.conductivity[q] * flow.along_a[q] + derivatives.flow_a[q] * at[q]);
      flow.along_b[q] = step * (derivatives.conductivity[q] * flow.along_b[q] + derivatives.flow_b[q] * at[q]);
      at[q] *= derivatives.capacity[q];
    }
    core::integrate(shapes.value, at, sum);
    core::integrate(shapes.derivative_a, flow.along_a, sum);
    core::integrate(shapes.derivative_b, flow.along_b, sum);
    core::scatter(sum, system.batches[g], batch_size, result.data());
  };
  for_each_batch(system, work);
}

[[gnu::target_clones("avx2", "default")]] void assemble_cells(StepMatrix& matrix, const HeatSystem& system,
                                                              const Eigen::VectorXd& temperature, double step) {
  const auto& shapes = cell_shapes<6>();
  const auto &value = shapes.value, &derivative_a = shapes.derivative_a, &derivative_b = shapes.derivative_b;
  const auto work = [&](const BodyLaws& laws, const CellBatch& cells, Index g) __attribute__((always_inline)) {
    UnknownValues<6> own{};
    PointValues at, heat_capacity, conductivity;
    core::gather(temperature.data(), system.batches[g], own);
    core::interpolate(value, own, at);
    laws.enthalpy.set_capacities(at, heat_capacity);
    laws.conductivity.set_values(at, cells.thin_wall, conductivity);
    std::array<UnknownValues<6>, 6> local{};  // lower triangle
    for (int q = 0; q < 6; ++q) {
      const VectorizedArray capacity = heat_capacity[q] * cells.mass[q], k = step * conductivity[q];
      const VectorizedArray aa = k * cells.aa[q], ab = k * cells.ab[q], bb = k * cells.bb[q];
      for (int j = 0; j < 6; ++j) {
        const VectorizedArray stored = capacity * value(q, j);
        const VectorizedArray flow_a = aa * derivative_a(q, j) + ab * derivative_b(q, j),
                              flow_b = ab * derivative_a(q, j) + bb * derivative_b(q, j);
        for (int i = j; i < 6; ++i)
          local[i][j] += value(q, i) * stored + (derivative_a(q, i) * flow_a + derivative_b(q, i) * flow_b);
      }
    }
    const Index first = laws.first_cell + batch_size * (g - laws.first_batch);
    for (int c = 0; c < std::min(batch_size, laws.last_cell - first); ++c) {
      std::array<double, 36> of_cell;
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j <= i; ++j) of_cell[6 * i + j] = local[i][j][c];
      add_clique(matrix, system, first + c, 6, system.cells[first + c].data(), of_cell.data());
    }
  };
  for_each_batch(system, work);
}

}  // namespace parison::thermal
