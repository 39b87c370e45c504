// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/cells/element_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/mesh/element.hpp"
#include "forming/flow/cells/memory.hpp"

namespace parison::flow {

using core::dim;

namespace {

/// Viscosity of frozen glass, of what it would be.
constexpr double frozen_factor = 1e6;
/// Bulk viscosity in units of the shear viscosity at the same point.
constexpr double bulk_ratio = 1e10;

/// Viscosity, weights and body force at one quadrature point of a batch.
struct PointWeights {
  VectorizedArray viscous, compliance;     ///< viscosity and compliance, each times the volume
  VectorizedArray ring;                    ///< twice the viscous weight over r squared
  std::array<VectorizedArray, dim> force;  ///< N
};
using BatchWeights = std::array<PointWeights, cell_points>;

/// The arrays have one entry for each quadrature point; the density is over that of the material and empty where it is
/// the same everywhere.
BatchWeights batch_weights(const Problem& problem, const CellGeometry& geometry, Index batch,
                           const std::vector<double>& viscosity, const Eigen::ArrayXd& density) {
  const Point weight = problem.material->density * problem.gravity * core::axis_direction();
  BatchWeights weights;
  for (int q = 0; q < cell_points; ++q) {
    const auto& at = geometry.at(batch, q);
    VectorizedArray eta;
    for (int lane = 0; lane < batch_size; ++lane) eta[lane] = viscosity[geometry.cell(batch, lane) * cell_points + q];
    weights[q].viscous = eta * at.volume;
    weights[q].ring = 2 * weights[q].viscous * at.hoop * at.hoop;
    weights[q].compliance = problem.memory ? at.volume / problem.memory->bulk : at.volume / (bulk_ratio * eta);
    for (int a = 0; a < dim; ++a) weights[q].force[a] = weight[a] * at.volume;
    for (int lane = 0; density.size() > 0 && lane < batch_size; ++lane)
      for (auto& force : weights[q].force) force[lane] *= density[geometry.cell(batch, lane) * cell_points + q];
    if (!problem.force) continue;
    for (int lane = 0; lane < batch_size; ++lane) {
      const Point more = problem.force(geometry.position(geometry.cell(batch, lane), q));
      for (int a = 0; a < dim; ++a) weights[q].force[a][lane] += more[a] * at.volume[lane];
    }
  }
  return weights;
}

/// Shape functions at the quadrature points, (point, node), and their products of nodes i and j <= i at packed(i, j).
struct Shapes {
  const Eigen::Matrix<double, cell_points, 6>& value = core::cell_shapes<6>().value;
  const Eigen::Matrix<double, cell_points, 3>& linear = core::cell_shapes<3>().value;
  double product[21][cell_points], linear_product[6][cell_points];

  Shapes() {
    for (int q = 0; q < cell_points; ++q) {
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j <= i; ++j) product[packed(i, j)][q] = value(q, i) * value(q, j);
      for (int p = 0; p < 3; ++p)
        for (int s = 0; s <= p; ++s) linear_product[packed(p, s)][q] = linear(q, p) * linear(q, s);
    }
  }
};

/// The viscous weight times the gradient of a node's shape function, at each quadrature point.
struct WeightedGradient {
  VectorizedArray at[cell_points][dim];
};

/// Viscous forces between the velocities of nodes i, whose weighted gradient is given, and j <= i.
[[gnu::always_inline]] inline void set_pair(const CellGeometry::AtPoint* at, const WeightedGradient& weighted, int i,
                                            int j, VectorizedArray* matrix) {
  VectorizedArray along_r{}, along_z{}, rz{}, zr{};
  for (int q = 0; q < cell_points; ++q) {
    const VectorizedArray &r = at[q].gradient[j][0], &z = at[q].gradient[j][1];
    along_r += weighted.at[q][0] * r;
    along_z += weighted.at[q][1] * z;
    rz += weighted.at[q][1] * r;
    zr += weighted.at[q][0] * z;
  }
  matrix[packed(dim * i, dim * j)] = 2 * along_r + along_z;
  matrix[packed(dim * i + 1, dim * j)] = zr;
  matrix[packed(dim * i + 1, dim * j + 1)] = along_r + 2 * along_z;
  if (j < i) matrix[packed(dim * i, dim * j + 1)] = rz;
}

/// Adds the forces of the rings' stretching.
[[gnu::always_inline]] inline void add_rings(const Shapes& shapes, const BatchWeights& weights,
                                             VectorizedArray* matrix) {
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j <= i; ++j) {
      const double* product = shapes.product[packed(i, j)];
      VectorizedArray ring{};
      for (int q = 0; q < cell_points; ++q) ring += product[q] * weights[q].ring;
      matrix[packed(dim * i, dim * j)] += ring;
    }
}

/// Divergence of node i's velocity, against the pressures, and the force on it.
[[gnu::always_inline]] inline void set_node(const Shapes& shapes, const CellGeometry::AtPoint* at,
                                            const BatchWeights& weights, int i, VectorizedArray* matrix,
                                            VectorizedArray* load) {
  VectorizedArray divergence[3][dim]{}, force[dim]{};
  for (int q = 0; q < cell_points; ++q) {
    const double shape = shapes.value(q, i);
    const VectorizedArray &volume = at[q].volume, &r = at[q].gradient[i][0];
    const VectorizedArray part[dim] = {volume * (r + shape * at[q].hoop), volume * at[q].gradient[i][1]};
    for (int a = 0; a < dim; ++a) {
      force[a] += shape * weights[q].force[a];
      for (int p = 0; p < 3; ++p) divergence[p][a] -= shapes.linear(q, p) * part[a];
    }
  }
  for (int a = 0; a < dim; ++a) {
    load[dim * i + a] = force[a];
    for (int p = 0; p < 3; ++p) matrix[packed(cell_velocities + p, dim * i + a)] = divergence[p][a];
  }
}

[[gnu::always_inline]] inline void set_pressures(const Shapes& shapes, const BatchWeights& weights,
                                                 VectorizedArray* matrix, VectorizedArray* load) {
  for (int p = 0; p < 3; ++p) {
    load[cell_velocities + p] = VectorizedArray{};
    for (int s = 0; s <= p; ++s) {
      VectorizedArray sum{};
      for (int q = 0; q < cell_points; ++q) sum -= shapes.linear_product[packed(p, s)][q] * weights[q].compliance;
      matrix[packed(cell_velocities + p, cell_velocities + s)] = sum;
    }
  }
}

[[gnu::target_clones("avx2", "default")]] void set_batch(const Shapes& shapes, const CellGeometry::AtPoint* at,
                                                         const BatchWeights& weights, VectorizedArray* matrix,
                                                         VectorizedArray* load) {
  for (int i = 0; i < 6; ++i) {
    WeightedGradient weighted;
    for (int q = 0; q < cell_points; ++q)
      for (int a = 0; a < dim; ++a) weighted.at[q][a] = weights[q].viscous * at[q].gradient[i][a];
    for (int j = 0; j <= i; ++j) set_pair(at, weighted, i, j, matrix);
    set_node(shapes, at, weights, i, matrix, load);
  }
  add_rings(shapes, weights, matrix);
  set_pressures(shapes, weights, matrix, load);
}

/// The temperature at each quadrature point, cells x cell_points, K.
Eigen::ArrayXd temperature_at_points(const core::Mesh& mesh, const Eigen::VectorXd& temperature) {
  Eigen::ArrayXd result(mesh.cell_count() * cell_points);
  core::BatchIndices<6> nodes;
  core::UnknownValues<6> at_nodes;
  core::PointValues at_points;
  for (Index batch = 0; batch < core::batch_count(mesh.cell_count()); ++batch) {
    core::set_nodes(mesh.cells(), batch, nodes);
    core::gather(temperature.data(), nodes, at_nodes);
    core::interpolate(core::cell_shapes<6>().value, at_nodes, at_points);
    for (int lane = 0; lane < core::filled_lanes(mesh.cell_count(), batch); ++lane)
      for (int q = 0; q < cell_points; ++q) result[(batch * batch_size + lane) * cell_points + q] = at_points[q][lane];
  }
  return result;
}

/// Rate of deformation exceeded in the volume `fraction`; the pairs are D:D and volume.
double exceeded_rate(std::vector<std::pair<double, double>> squared_and_volume, double fraction) {
  // The largest are searched for among ever more candidates until these fill the share.
  const auto begin = squared_and_volume.begin(), end = squared_and_volume.end();
  auto sorted = begin;
  double above = 0;
  for (std::ptrdiff_t next = 1 + (end - begin) / 16; sorted != end; next = end - sorted) {
    const auto stop = sorted + std::min(next, end - sorted);
    std::nth_element(sorted, stop - 1, end, std::greater<>());
    std::sort(sorted, stop, std::greater<>());
    for (; sorted != stop; ++sorted) {
      above += sorted->second;
      if (above > fraction) return std::sqrt(2 * sorted->first);
    }
  }
  return 0;
}

}  // namespace

CellMatrix CellMatrices::of(Index cell) const {
  CellMatrix result;
  const VectorizedArray* entry = batch(cell / batch_size);
  for (int i = 0; i < cell_unknowns; ++i)
    for (int j = 0; j <= i; ++j) result(i, j) = result(j, i) = (*entry++)[cell % batch_size];
  return result;
}

std::vector<double> viscosity_field(const Problem& problem, const CellGeometry& geometry,
                                    const Eigen::VectorXd& velocity) {
  if (problem.memory) return problem.memory->viscosity;
  const auto& mesh = *problem.mesh;
  std::vector<double> viscosity(mesh.cells().size() * cell_points);
  Eigen::Map<Eigen::ArrayXd> at_points(viscosity.data(), Index(viscosity.size()));
  if (problem.viscosity) {
    for (Index k = 0; k < at_points.size(); ++k)
      at_points[k] = problem.viscosity(geometry.position(k / cell_points, k % cell_points));
  } else {
    at_points = problem.material->viscosity.logarithm_in_flow(temperature_at_points(mesh, *problem.temperature)).exp();
  }
  for (Index c = 0; c < Index(problem.frozen.size()); ++c)
    if (problem.frozen[c]) at_points.segment<cell_points>(c * cell_points) *= frozen_factor;
  if (problem.viscosity || !problem.material->shear_thinning || velocity.size() == 0) return viscosity;
  const auto& law = *problem.material->shear_thinning;
  for (Index batch = 0; batch < geometry.batches(); ++batch) {
    const auto v = batch_velocity(mesh, batch, velocity);
    const int lanes = core::filled_lanes(geometry.cells, batch);
    for (int q = 0; q < cell_points; ++q) {
      VectorizedArray squared;
      set_squared_rate(geometry.at(batch, q), q, v, squared);
      squared *= 2;
      for (int lane = 0; lane < lanes; ++lane)
        viscosity[std::size_t(batch * batch_size + lane) * cell_points + q] *= law(squared[lane]);
    }
  }
  return viscosity;
}

CellMatrices cell_matrices(const Problem& problem, const CellGeometry& geometry, const std::vector<double>& viscosity) {
  static const Shapes shapes;
  CellMatrices cells;
  cells.batches.resize(geometry.batches());
  Eigen::ArrayXd density;
  if (const core::Table& relative = problem.material->relative_density; !relative.x.empty())
    density = temperature_at_points(*problem.mesh, *problem.temperature).unaryExpr(std::cref(relative));
  for (Index batch = 0; batch < geometry.batches(); ++batch) {
    const auto weights = batch_weights(problem, geometry, batch, viscosity, density);
    set_batch(shapes, &geometry.at(batch, 0), weights, cells.batches[batch].matrix, cells.batches[batch].load);
  }
  if (problem.memory) leave_out_dilatation(problem, geometry, viscosity, cells);
  return cells;
}

Dissipation dissipation(const Problem& problem, const CellGeometry& geometry, const std::vector<double>& viscosity,
                        const Eigen::VectorXd& velocity) {
  Dissipation result;
  result.power.resize(viscosity.size());
  std::vector<std::pair<double, double>> squared_and_volume(viscosity.size());
  double total = 0, sum = 0;
  for (Index batch = 0; batch < geometry.batches(); ++batch) {
    const auto v = batch_velocity(*problem.mesh, batch, velocity);
    const int lanes = core::filled_lanes(geometry.cells, batch);
    for (int q = 0; q < cell_points; ++q) {
      const auto& at = geometry.at(batch, q);
      VectorizedArray squared;
      set_squared_rate(at, q, v, squared);
      for (int lane = 0; lane < lanes; ++lane) {
        const std::size_t k = std::size_t(batch * batch_size + lane) * cell_points + q;
        squared_and_volume[k] = {squared[lane], at.volume[lane]};
        result.power[k] = 2 * viscosity[k] * squared[lane] * at.volume[lane];
        total += at.volume[lane];
        sum += 2 * squared[lane] * at.volume[lane];
      }
    }
  }
  result.mean_rate = std::sqrt(sum / total);
  result.high_rate = exceeded_rate(std::move(squared_and_volume), high_rate_fraction * total);
  return result;
}

namespace {

/// D:dD at a quadrature point for each velocity of a cell, 1/(m s).
using RateDerivative = std::array<VectorizedArray, cell_velocities>;

RateDerivative rate_derivative(const CellGeometry::AtPoint& at, int q, const core::NodeVectors& velocity) {
  const auto& shape = core::cell_shapes<6>().value;
  VectorizedArray rr{}, zz{}, shear{}, radial;
  for (int i = 0; i < 6; ++i) {
    rr += velocity[0][i] * at.gradient[i][0];
    zz += velocity[1][i] * at.gradient[i][1];
    shear += velocity[0][i] * at.gradient[i][1] + velocity[1][i] * at.gradient[i][0];
  }
  core::interpolate(shape, q, velocity[0], radial);
  const VectorizedArray half = 0.5 * shear, ring = at.hoop * at.hoop * radial;
  RateDerivative derivative;
  for (int i = 0; i < 6; ++i) {
    derivative[dim * i] = rr * at.gradient[i][0] + half * at.gradient[i][1] + shape(q, i) * ring;
    derivative[dim * i + 1] = half * at.gradient[i][0] + zz * at.gradient[i][1];
  }
  return derivative;
}

}  // namespace

void add_thinning_derivative(const Problem& problem, const CellGeometry& geometry, const std::vector<double>& viscosity,
                             const Eigen::VectorXd& velocity, CellMatrices& cells) {
  const auto& law = *problem.material->shear_thinning;
  for (Index batch = 0; batch < geometry.batches(); ++batch) {
    VectorizedArray* matrix = cells.batches[batch].matrix;
    const auto v = batch_velocity(*problem.mesh, batch, velocity);
    for (int q = 0; q < cell_points; ++q) {
      const auto& at = geometry.at(batch, q);
      VectorizedArray squared, derivative;  // square of the shear rate; of the viscosity with respect to it
      set_squared_rate(at, q, v, squared);
      squared *= 2;
      for (int lane = 0; lane < batch_size; ++lane)
        derivative[lane] = viscosity[geometry.cell(batch, lane) * cell_points + q] * law.log_derivative(squared[lane]);
      const auto rate = rate_derivative(at, q, v);
      for (int i = 0; i < cell_velocities; ++i) {
        const VectorizedArray row = 8 * derivative * at.volume * rate[i];
        for (int j = 0; j <= i; ++j) matrix[packed(i, j)] += row * rate[j];
      }
    }
  }
}

bool NewtonGuard::accepts(double moved) {
  const bool contracts = moved < last_moved_;
  last_moved_ = moved;
  if (left_ > 0) return --left_ == 0;
  if (contracts) return true;
  penalty_ = 2 * penalty_ + 1;
  left_ = penalty_;
  return false;
}

}  // namespace parison::flow
