// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/heat/bounds/temperature_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/mesh/element.hpp"
#include "forming/step/heat/heat_step.hpp"

namespace parison::forming {

namespace {

/// Follows how far temperatures inside a body go beyond those that its surface and its start have had.
void update_bounds(const core::Mesh& mesh, const Eigen::VectorXd& temperature, const Body& body, double heating,
                   double tolerance, double dt, TemperatureBounds& bounds) {
  if (temperature.size() == 0) return;
  if (bounds.hottest == 0) {
    bounds.coldest = body.start_field ? body.start_field->min : body.initial_temperature;
    bounds.hottest = body.start_field ? body.start_field->max : body.initial_temperature;
  }
  for (const auto& edge : mesh.boundary_edges()) {
    if (mesh.kind_of(edge) == BoundaryKind::symmetry) continue;
    for (const Index node : edge.nodes) {
      bounds.coldest = std::min(bounds.coldest, temperature[node]);
      bounds.hottest = std::max(bounds.hottest, temperature[node]);
    }
  }
  bounds.undershoot += dt * std::max(0.0, bounds.coldest - temperature.minCoeff() - tolerance);
  bounds.overshoot += dt * std::max(0.0, temperature.maxCoeff() - bounds.hottest - heating - tolerance);
}

/// By which the dissipation of a step can at most heat a point of the glass, K.
double viscous_heating(const Scene& scene, const State& state, const std::vector<double>& dissipation, double dt) {
  const core::Mesh& mesh = state.glass.mesh;
  const std::size_t points = dissipation.size() / mesh.cells().size();
  double densest = 0;
  for (std::size_t cell = 0; cell < mesh.cells().size() && points > 0; ++cell) {
    const auto& nodes = mesh.cells()[cell];
    const core::Point a = mesh.nodes[nodes[0]], b = mesh.nodes[nodes[1]] - a, c = mesh.nodes[nodes[2]] - a;
    const double volume = 0.5 * std::abs(b[0] * c[1] - b[1] * c[0]) * core::depth(scene.geometry, a + (b + c) / 3);
    const auto first = dissipation.begin() + static_cast<std::ptrdiff_t>(cell * points);
    densest = std::max(densest, std::accumulate(first, first + static_cast<std::ptrdiff_t>(points), 0.0) / volume);
  }
  return dt * densest / (state.glass.density * scene.glass.thermal->heat_capacity(scene.glass.initial_temperature));
}

}  // namespace

void update_temperature_bounds(const Scene& scene, const std::vector<double>& dissipation, double dt, State& state) {
  if (!dissipation.empty()) state.totals.viscous_heating += viscous_heating(scene, state, dissipation, dt);
  for (Index b = 0; b < body_count(state); ++b)
    update_bounds(mesh_of(state, b), temperature_of(state, b), body_of(scene, b),
                  b == glass_body ? state.totals.viscous_heating : 0, temperature_tolerance(scene), dt,
                  b == glass_body ? state.glass.bounds : state.tools[b - 1].bounds);
}

}  // namespace parison::forming
