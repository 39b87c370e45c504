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

/// Of a cell with straight sides, m3.
double volume_of(const core::Mesh& mesh, const std::array<Index, 6>& cell, core::Geometry geometry) {
  const core::Point a = mesh.nodes[cell[0]], b = mesh.nodes[cell[1]] - a, c = mesh.nodes[cell[2]] - a;
  return 0.5 * std::abs(b[0] * c[1] - b[1] * c[0]) * core::depth(geometry, a + (b + c) / 3);
}

/// By which the dissipation of a step can at most heat a point of the glass, K.
double viscous_heating(const Scene& scene, const State& state, const std::vector<double>& dissipation, double dt) {
  const core::Mesh& mesh = state.glass.mesh;
  const std::size_t points = dissipation.size() / mesh.cells().size();
  double densest = 0;
  for (std::size_t cell = 0; cell < mesh.cells().size() && points > 0; ++cell) {
    const double volume = volume_of(mesh, mesh.cells()[cell], scene.geometry);
    const auto first = dissipation.begin() + static_cast<std::ptrdiff_t>(cell * points);
    densest = std::max(densest, std::accumulate(first, first + static_cast<std::ptrdiff_t>(points), 0.0) / volume);
  }
  return dt * densest / (state.glass.density * scene.glass.thermal->heat_capacity(scene.glass.initial_temperature));
}

/// Of a field in a cell: the nodes in the middle of its sides have it.
double mean_in(const std::array<Index, 6>& cell, const Eigen::VectorXd& field) {
  return (field[cell[3]] + field[cell[4]] + field[cell[5]]) / 3;
}

/// Share of the glass that is hotter than that, K.
double share_above(const Scene& scene, const State& state, double limit) {
  const core::Mesh& mesh = state.glass.mesh;
  double above = 0, whole = 0;
  for (const auto& cell : mesh.cells()) {
    const double volume = volume_of(mesh, cell, scene.geometry);
    whole += volume;
    if (mean_in(cell, state.glass.temperature) > limit) above += volume;
  }
  return above / whole;
}

void note_hottest_glass(const Scene& scene, double dt, State& state) {
  const Eigen::VectorXd& temperature = state.glass.temperature;
  if (temperature.size() == 0) return;
  HottestGlass& hottest = state.totals.hottest_glass;
  const double source = hottest_source(scene, state);
  Index node = 0;
  const double above = temperature.maxCoeff(&node) - source;
  if (!(above > hottest.above)) return;
  const Point& x = state.glass.mesh.nodes[node];
  hottest = {above,           x[0],        x[core::dim - 1],
             state.time + dt, state.stage, share_above(scene, state, source + told_excess)};
}

}  // namespace

double hottest_source(const Scene& scene, const State& state) {
  return temperature_range(scene).max_temperature + state.totals.viscous_heating + temperature_tolerance(scene);
}

double hot_work(const Scene& scene, const State& state, const Eigen::VectorXd& temperature,
                const std::vector<double>& dissipation, double dt) {
  const double source = hottest_source(scene, state);
  if (temperature.maxCoeff() <= source) return 0;
  const flow::Viscosity& viscosity = scene.glass.flow->viscosity;
  const auto& cells = state.glass.mesh.cells();
  const std::size_t points = dissipation.size() / cells.size();
  double power = 0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const double mean = mean_in(cells[cell], temperature);
    if (mean <= source) continue;
    const double missing = viscosity(source) / viscosity(mean) - 1;
    for (std::size_t q = 0; q < points; ++q) power += missing * dissipation[cell * points + q];
  }
  return dt * power;
}

void update_temperature_bounds(const Scene& scene, const std::vector<double>& dissipation, double dt, State& state) {
  if (!dissipation.empty()) state.totals.viscous_heating += viscous_heating(scene, state, dissipation, dt);
  note_hottest_glass(scene, dt, state);
  for (Index b = 0; b < body_count(state); ++b)
    update_bounds(mesh_of(state, b), temperature_of(state, b), body_of(scene, b),
                  b == glass_body ? state.totals.viscous_heating : 0, temperature_tolerance(scene), dt,
                  b == glass_body ? state.glass.bounds : state.tools[b - 1].bounds);
}

}  // namespace parison::forming
