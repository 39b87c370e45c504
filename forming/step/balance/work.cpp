// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/balance/work.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/mesh/element.hpp"
#include "forming/flow/cells/cell_geometry.hpp"
#include "forming/state/initial_state.hpp"

namespace parison::forming {

using core::dim;

namespace {

/// Over-pressure of each boundary of the glass, the mean of a step, Pa.
std::vector<double> mean_pressures(const Stage& stage, const State& start, double dt) {
  std::vector<double> pressure;
  for (const auto& boundary : start.glass.mesh.boundaries()) {
    const auto given = stage.pressure.find(boundary.name);
    pressure.push_back(given == stage.pressure.end() ? 0 : given->second.mean(start.stage_time, start.stage_time + dt));
  }
  return pressure;
}

/// Power of the over-pressures on the exposed edges of a mesh, W, and the area of those edges that are neither symmetry
/// planes nor fixed, m2.
struct ExposedSurface {
  double air_power = 0, area = 0;
};
ExposedSurface exposed_surface(const Scene& scene, const std::vector<double>& pressure, const core::Mesh& mesh,
                               const flow::Solution& flow) {
  ExposedSurface surface;
  for (std::size_t e = 0; e < mesh.boundary_edges().size(); ++e) {
    const auto& edge = mesh.boundary_edges()[e];
    if (!flow.exposed[e]) continue;
    const BoundaryKind kind = mesh.kind_of(edge);
    const bool open = kind != BoundaryKind::symmetry && kind != BoundaryKind::fixed;
    const double over = flow.edge_pressure.empty() ? pressure[edge.boundary_id] : flow.edge_pressure[e];
    for (const auto& rule : core::edge_rule(4)) {
      const auto at = core::map_edge_point(mesh, edge.nodes, scene.geometry, rule);
      if (open) surface.area += at.area;
      for (int i = 0; i < 3; ++i)
        surface.air_power -=
            over * at.area * at.shape[i] * at.normal.dot(flow::node_velocity(flow.velocity, edge.nodes[i]));
    }
  }
  return surface;
}

/// Velocities times the density relative to that of the material, by node.
Eigen::VectorXd by_density(const Scene& scene, const Eigen::VectorXd& temperature, Eigen::VectorXd velocity) {
  const core::Table density = scene.glass.relative_density();
  for (Index n = 0; n < temperature.size(); ++n) velocity.segment<dim>(dim * n) *= density(temperature[n]);
  return velocity;
}

}  // namespace

void accumulate_work(const Scene& scene, const State& start, const flow::Solution& flow, double dt, Work& work) {
  const Stage& stage = scene.stages[start.stage];
  const core::Mesh& first = start.glass.mesh;
  core::Mesh middle = first, last = first;
  for (Index n = 0; n < first.node_count(); ++n) {
    const Point v = flow::node_velocity(flow.velocity, n);
    middle.nodes[n] += 0.5 * dt * v;
    last.nodes[n] += dt * v;
  }
  for (const auto& tool : stage.tools) work.tools += dt * flow.tool_force[tool.tool] * flow.tool_velocity[tool.tool];
  const std::vector<double> pressure = mean_pressures(stage, start, dt);
  const auto before = exposed_surface(scene, pressure, first, flow),
             between = exposed_surface(scene, pressure, middle, flow),
             after = exposed_surface(scene, pressure, last, flow);
  work.air += dt / 6 * (before.air_power + 4 * between.air_power + after.air_power);  // Simpson's rule is exact
  work.surface += scene.glass.flow->surface_tension * (after.area - before.area);
  // Gravity acts on the mass where it was last distributed.
  const core::Mesh mass = mass_mesh(start);
  const Eigen::VectorXd momentum =
      scene.expands() ? by_density(scene, start.glass.mass_temperature, flow.velocity) : flow.velocity;
  const double sinking = flow::integral(mass, scene.geometry, momentum).dot(core::axis_direction());
  work.gravity += dt * start.glass.density * stage.gravity * sinking;
  work.dissipation += dt * std::accumulate(flow.dissipation.begin(), flow.dissipation.end(), 0.0);
  work.friction += dt * flow.friction_power;
  work.impact_loss += dt * flow.impact_power;
  work.expansion += dt * flow.expansion_power;
  work.correction += dt * flow.correction_power;
}

namespace {

double lost(const Work& work) {
  return work.dissipation + work.friction + work.impact_loss;
}

/// Work done on the glass that is neither lost nor stored, J.
double excess_work(const Work& work) {
  return work.tools + work.gravity + work.air - lost(work) - work.surface - work.expansion;
}

/// Work, J, of a strain that nobody sees in the time of a stage: less is round-off of glass that nothing loads.
double work_of_no_motion(const Scene& scene, const State& state) {
  constexpr double unseen = 1e-4;
  const double viscosity = scene.glass.flow->viscosity(scene.glass.initial_temperature);
  return unseen * unseen * viscosity * state.glass.initial_volume / scene.stages[state.stage].duration;
}

}  // namespace

double unforeseen_work(const flow::Viscosity& viscosity, const core::Mesh& mesh, const std::vector<double>& dissipation,
                       const Eigen::VectorXd& predicted, const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                       double dt) {
  const auto& cells = mesh.cells();
  const std::size_t points = dissipation.size() / cells.size();
  // The mean of the nodes in the middle of the sides is that of the cell.
  const auto mean = [](const auto& cell, const Eigen::VectorXd& temperature) {
    return (temperature[cell[3]] + temperature[cell[4]] + temperature[cell[5]]) / 3;
  };
  const auto eta = [&](double temperature) { return viscosity.in_flow(temperature); };
  double power = 0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const double first = mean(cells[cell], before), last = mean(cells[cell], after);
    const double in_flow = eta(mean(cells[cell], predicted));
    const double in_step = (eta(first) + 4 * eta(0.5 * (first + last)) + eta(last)) / 6;
    // Glass that turns out stiffer by decades would flow less: it counts once at most.
    const double change = (in_step - in_flow) / std::max(in_step, in_flow);
    for (std::size_t q = 0; q < points; ++q) power += dissipation[cell * points + q] * std::abs(change);
  }
  return dt * power;
}

/// The least share of the whole that counts. A film that bursts takes many steps, each with little of the work and half
/// of that wrong.
constexpr double least_share = 0.1;

double measure_of_error(const Scene& scene, const State& start, const Work& before, const Work& after) {
  constexpr double negligible =
      1e-3;  // of what pressures could do: glass that they hold at rest has round-off far below
  double pressure = 0;
  for (const auto& [name, value] : scene.stages[start.stage].pressure) pressure = std::max(pressure, value.max_size());
  const double weight = start.glass.density * start.glass.initial_volume * std::abs(scene.stages[start.stage].gravity);
  const double measure =
      std::max({lost(after), std::abs(after.tools), std::abs(after.air), std::abs(after.gravity),
                weight * core::size(scene.glass.profile), negligible * pressure * start.glass.initial_volume,
                work_of_no_motion(scene, start)});
  const double own = usual_steps * (lost(after) - lost(before));
  return std::min(measure, std::max(own, least_share * measure));
}

double work_error(const Scene& scene, const State& start, const Work& before, const Work& after, double recovery) {
  const double truncation = excess_work(after) - excess_work(before) - recovery;
  const double created = std::max(0.0, before.impact_loss - after.impact_loss);
  const double counted = measure_of_error(scene, start, before, after);
  return counted > 0 ? (std::abs(truncation) + created) / counted : 0;
}

double least_loss(const Scene& scene, const State& state) {
  constexpr double negligible = 1e-6;
  const double size = core::size(scene.glass.profile), volume = state.glass.initial_volume;
  const Work& work = state.totals.work;
  double loads = std::abs(work.tools) + std::abs(work.air) + std::abs(work.gravity) +
                 scene.glass.flow->surface_tension * volume / size;
  for (Index s = 0; s <= state.stage; ++s) {
    const Stage& stage = scene.stages[s];
    loads += state.glass.density * volume * std::abs(stage.gravity) * size;
    for (const auto& [name, pressure] : stage.pressure) loads += pressure.max_size() * volume;
  }
  return negligible * loads + work_of_no_motion(scene, state);
}

double work_imbalance(const Work& work, double least_loss) {
  const double excess = excess_work(work), measure = std::max(lost(work), least_loss);
  return excess == 0 ? 0 : excess / measure;
}

double work_imbalance(const Work& work) {
  return excess_work(work) / lost(work);
}

}  // namespace parison::forming
