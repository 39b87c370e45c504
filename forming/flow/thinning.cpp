// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/thinning.hpp"

namespace parison::flow {

using core::dim;

namespace {

/// D:dD at a quadrature point for each velocity of a cell, 1/(m s).
using RateDerivative = std::array<Lanes, cell_velocities>;

RateDerivative rate_derivative(const CellGeometry::AtPoint& at, int q, const BatchVelocity& velocity) {
  const auto& shape = shapes_at_points()[q];
  Lanes rr = Lanes::Zero(), zz = rr, shear = rr, radial = rr;
  for (int i = 0; i < 6; ++i) {
    rr += velocity[i][0] * at.gradient[i][0];
    zz += velocity[i][1] * at.gradient[i][1];
    shear += velocity[i][0] * at.gradient[i][1] + velocity[i][1] * at.gradient[i][0];
    radial += shape[i] * velocity[i][0];
  }
  const Lanes half = 0.5 * shear, ring = at.hoop * at.hoop * radial;
  RateDerivative derivative;
  for (int i = 0; i < 6; ++i) {
    derivative[dim * i] = rr * at.gradient[i][0] + half * at.gradient[i][1] + shape[i] * ring;
    derivative[dim * i + 1] = half * at.gradient[i][0] + zz * at.gradient[i][1];
  }
  return derivative;
}

}  // namespace

void add_thinning_derivative(const Problem& problem, const CellGeometry& geometry, const std::vector<double>& viscosity,
                             const Eigen::VectorXd& velocity, CellMatrices& cells) {
  const auto& law = *problem.material->shear_thinning;
  const double square = law.time * law.time;
  for (Index batch = 0; batch < geometry.batches(); ++batch) {
    Lanes* matrix = cells.matrix.data() + std::size_t(batch) * cell_entries;
    const auto v = batch_velocity(*problem.mesh, geometry, batch, velocity);
    for (int q = 0; q < cell_points; ++q) {
      const auto& at = geometry.at(batch, q);
      Lanes eta;
      for (Index lane = 0; lane < lanes; ++lane) eta[lane] = viscosity[geometry.cell(batch, lane) * cell_points + q];
      const Lanes slope = 0.5 * (law.exponent - 1) * square * eta / (1 + 2 * square * squared_rate(at, q, v));
      const auto rate = rate_derivative(at, q, v);
      for (int i = 0; i < cell_velocities; ++i) {
        const Lanes row = 8 * slope * at.volume * rate[i];
        for (int j = 0; j <= i; ++j) matrix[packed(i, j)] += row * rate[j];
      }
    }
  }
}

bool NewtonGuard::trusts(double moved) {
  const bool contracts = moved < last_moved_;
  last_moved_ = moved;
  if (left_ > 0) return --left_ == 0;
  if (contracts) return true;
  penalty_ = 2 * penalty_ + 1;
  left_ = penalty_;
  return false;
}

}  // namespace parison::flow
