// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/diagnostics/temperature_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/mesh/element.hpp"
#include "forming/step/heat/heat_step.hpp"

namespace parison::forming {

namespace {

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

/// The highest temperature of any body, K.
double hottest_of_all(const State& state) {
  double hottest = 0;
  for (Index body = 0; body < body_count(state); ++body)
    if (const auto& temperature = temperature_of(state, body); temperature.size() > 0)
      hottest = std::max(hottest, temperature.maxCoeff());
  return hottest;
}

}  // namespace

double hottest_source(const Scene& scene, double viscous_heating) {
  return temperature_range(scene).max_temperature + viscous_heating + temperature_tolerance(scene);
}

double hot_work(const Scene& scene, const State& state, const Eigen::VectorXd& temperature,
                const std::vector<double>& dissipation, double source, double dt) {
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

void follow_hot_glass(const Scene& scene, const State& before, const StepResult& step, HotGlass& hot) {
  const State& now = step.at_heat;
  const double dt = step.report.dt;
  hot.overshoot = std::max(hot.overshoot, hottest_of_all(now) - temperature_range(scene).max_temperature);
  if (!step.dissipation.empty()) {
    hot.work += hot_work(scene, before, step.flow_temperature, step.dissipation,
                         hottest_source(scene, hot.viscous_heating), dt);
    hot.viscous_heating += viscous_heating(scene, now, step.dissipation, dt);
  }
  const double source = hottest_source(scene, hot.viscous_heating);
  Index node = 0;
  const double above = now.glass.temperature.maxCoeff(&node) - source;
  if (!(above > hot.above)) return;
  const Point& x = now.glass.mesh.nodes[node];
  hot.above = above, hot.r = x[0], hot.z = x[core::dim - 1];
  hot.time = before.time + dt, hot.stage = before.stage;
  hot.volume_share = share_above(scene, now, source + told_excess);
}

void follow_bounds(const Scene& scene, const StepResult& step, Index body, double heating, TemperatureBounds& bounds) {
  const core::Mesh& mesh = mesh_of(step.at_heat, body);
  const Eigen::VectorXd& temperature = temperature_of(step.at_heat, body);
  if (temperature.size() == 0) return;
  const double tolerance = temperature_tolerance(scene), dt = step.report.dt;
  const Body& data = body_of(scene, body);
  if (bounds.hottest == 0) {
    bounds.coldest = data.start_field ? data.start_field->min : data.initial_temperature;
    bounds.hottest = data.start_field ? data.start_field->max : data.initial_temperature;
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

}  // namespace parison::forming
