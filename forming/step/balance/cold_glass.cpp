// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/balance/cold_glass.hpp"

#include <cmath>

#include "core/math/numbers.hpp"
#include "forming/flow/solver.hpp"
#include "forming/step/balance/expansion.hpp"
#include "forming/step/contact/carrier.hpp"

namespace parison::forming {
namespace {

/// Change of volume of each quadrature point in one step of straight motion that scales lengths rightly.
std::vector<double> shrinkage(const Scene& scene, const State& state) {
  const auto& shapes = core::cell_shapes<6>().value;
  const core::Table density = scene.glass.relative_density();
  const double cold = density(core::room_temperature);
  std::vector<double> change;
  for (const auto& cell : state.glass.mesh.cells())
    for (int q = 0; q < core::cell_points; ++q) {
      double temperature = 0;
      for (int i = 0; i < 6; ++i) temperature += shapes(q, i) * state.glass.temperature[cell[i]];
      change.push_back(3 * (std::cbrt(density(temperature) / cold) - 1));
    }
  return change;
}

}  // namespace

std::optional<core::Mesh> cold_glass(const Scene& scene, const State& state) {
  if (!follows_density(scene) || scene.stages[state.stage].cools) return {};
  core::Mesh mesh = state.glass.mesh;
  flow::Material uniform{};
  uniform.viscosity.constant = 1;
  flow::Problem problem{};
  problem.mesh = &mesh;
  problem.geometry = scene.geometry;
  problem.material = &uniform;
  problem.temperature = &state.glass.temperature;
  problem.expansion_rate = shrinkage(scene, state);
  for (const auto& boundary : mesh.boundaries()) {
    flow::BoundaryCondition condition;
    if (boundary.kind == BoundaryKind::symmetry) condition.kind = flow::BoundaryCondition::Kind::symmetry;
    problem.boundary_conditions.push_back(condition);
  }
  std::vector<bool> active;
  if (floats(problem)) add_carrier(problem, active, std::nullopt);
  const auto solution = flow::Solver(state.glass.mesh).solve(problem, active);
  if (!solution.converged) return {};
  for (Index n = 0; n < mesh.node_count(); ++n) mesh.nodes[n] += flow::node_velocity(solution.velocity, n);
  return mesh;
}

}  // namespace parison::forming
