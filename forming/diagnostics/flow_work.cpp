// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/diagnostics/flow_work.hpp"

#include <algorithm>
#include <numeric>

#include "core/mesh/element.hpp"
#include "remesh/sizing/recovery.hpp"

namespace parison::forming {

namespace {

/// Twice the volume of the glass over its surface, m.
double mean_wall_of(const Scene& scene, const core::Mesh& mesh) {
  double surface = 0;
  for (const auto& edge : mesh.boundary_edges())
    if (mesh.kind_of(edge) != BoundaryKind::symmetry)
      for (const auto& at : core::edge_rule(2))
        surface += core::map_edge_point(mesh, edge.nodes, scene.geometry, at).area;
  return 2 * core::volume(mesh, scene.geometry) / surface;
}

double sum(const std::vector<double>& dissipation) {
  return std::accumulate(dissipation.begin(), dissipation.end(), 0.0);
}

/// Reynolds number rho rate L^2 / eta: L is the thickness of a wall of the glass's volume and surface, eta the
/// viscosity that gives the dissipation at the mean rate of deformation.
double reynolds(const Scene& scene, const State& before, const flow::Solution& solution) {
  const double dissipation = sum(solution.dissipation), wall = mean_wall_of(scene, before.glass.mesh);
  const double rate = solution.mean_rate, viscosity = dissipation / (rate * rate * before.glass.initial_volume);
  return dissipation > 0 ? scene.glass.flow->density * rate * wall * wall / viscosity : 0;
}

/// What loads dissipate, W: not what a skin does that shrinks faster than the glass below it, which moves as far as it
/// shrinks on any mesh.
double loads_dissipate(const flow::Solution& solution) {
  const double all = sum(solution.dissipation);
  return std::clamp(all + solution.expansion_power, 0.0, all);
}

/// Compares, in one of some steps, the rate of deformation with the recovered one: the square of the relative
/// difference is the share of the dissipation that the mesh does not resolve (Zienkiewicz and Zhu 1992). Each step that
/// is looked at stands for those around it; where the share so far is not small they are three times as many, because a
/// few heavy steps decide: with every 15th alone the flute at draft has 3.0 %, with all steps 2.3 %.
void sample_resolution(const Scene& scene, const State& before, const flow::Solution& solution, double dt,
                       FlowWork& work) {
  constexpr Index seldom = 15, often = 5;
  constexpr double small = 0.01;
  const Index every = work.unresolved > small * work.sampled ? often : seldom;
  if (before.totals.steps % every != 0) return;
  const double dissipated = double(every) / seldom * dt * loads_dissipate(solution);
  const double error = remesh::rate_error(before.glass.mesh, scene.geometry, solution.velocity).relative();
  work.sampled += dissipated;
  work.unresolved += std::min(1.0, error * error) * dissipated;
}

}  // namespace

double capped_work(const Scene& scene, const State& start, const flow::Solution& flow, double dt) {
  const flow::Viscosity& viscosity = scene.glass.flow->viscosity;
  const Eigen::VectorXd& temperature = start.glass.temperature;
  const auto capped = [&](Index node) {
    return viscosity.is_softened(temperature.size() > 0 ? temperature[node] : scene.glass.initial_temperature);
  };
  const auto& cells = start.glass.mesh.cells();
  const std::size_t points = flow.dissipation.size() / cells.size();
  double power = 0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
    if (capped(cells[cell][0]) && capped(cells[cell][1]) && capped(cells[cell][2]))
      for (std::size_t q = 0; q < points; ++q) power += flow.dissipation[cell * points + q];
  return dt * power;
}

void follow_flow_work(const Scene& scene, const State& before, const StepResult& step, FlowWork& work) {
  const double dt = step.report.dt;
  work.max_reynolds = std::max(work.max_reynolds, reynolds(scene, before, step.flow));
  sample_resolution(scene, before, step.flow, dt, work);
  work.capped += capped_work(scene, before, step.flow, dt);
  work.unforeseen += step.report.unforeseen_work;
}

}  // namespace parison::forming
