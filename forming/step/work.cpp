// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/work.hpp"

#include <algorithm>
#include <numeric>

#include "core/mesh/element.hpp"
#include "forming/flow/cells/cell_geometry.hpp"
#include "forming/state/initial_state.hpp"

namespace parison::forming {

using core::dim;

namespace {

/// Of the glass's mass, with the mass where it was last distributed.
double gravity_power(const Scene& scene, const State& start, const Eigen::VectorXd& velocity) {
  const Point moved = flow::integral(mass_mesh(start), scene.geometry, velocity);
  return start.glass.density * scene.stages[start.stage].gravity * moved.dot(core::axis_direction());
}

/// Of the over-pressures on the exposed edges of a mesh.
double air_power(const Scene& scene, const Stage& stage, const core::Mesh& mesh, const flow::Solution& flow) {
  std::vector<double> pressure;
  for (const auto& boundary : mesh.boundaries()) {
    const auto given = stage.pressure.find(boundary.name);
    pressure.push_back(given == stage.pressure.end() ? 0 : given->second);
  }
  double power = 0;
  for (std::size_t e = 0; e < mesh.boundary_edges().size(); ++e) {
    const auto& edge = mesh.boundary_edges()[e];
    if (!flow.exposed[e] || pressure[edge.boundary_id] == 0) continue;
    for (const auto& rule : core::edge_rule(4)) {
      const auto at = core::map_edge_point(mesh, edge.nodes, scene.geometry, rule);
      for (int i = 0; i < 3; ++i)
        power -= pressure[edge.boundary_id] * at.area * at.shape[i] *
                 at.normal.dot(flow::node_velocity(flow.velocity, edge.nodes[i]));
    }
  }
  return power;
}

/// Of the exposed edges that are no symmetry planes nor fixed, m2.
double open_area(const Scene& scene, const core::Mesh& mesh, const std::vector<bool>& exposed) {
  double area = 0;
  for (std::size_t e = 0; e < mesh.boundary_edges().size(); ++e) {
    const auto& edge = mesh.boundary_edges()[e];
    const BoundaryKind kind = mesh.boundaries()[edge.boundary_id].kind;
    if (!exposed[e] || kind == BoundaryKind::symmetry || kind == BoundaryKind::fixed) continue;
    for (const auto& rule : core::edge_rule(4))
      area += core::map_edge_point(mesh, edge.nodes, scene.geometry, rule).area;
  }
  return area;
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
  if (stage.gravity != 0) work.gravity += dt * gravity_power(scene, start, flow.velocity);
  if (!stage.pressure.empty())  // Simpson's rule is exact
    work.air += dt / 6 *
                (air_power(scene, stage, first, flow) + 4 * air_power(scene, stage, middle, flow) +
                 air_power(scene, stage, last, flow));
  work.dissipation += dt * std::accumulate(flow.dissipation.begin(), flow.dissipation.end(), 0.0);
  work.friction += dt * flow.friction_power;
  work.impact_loss += dt * flow.impact_power;
  work.correction += dt * flow.correction_power;
  work.surface += scene.glass.flow->surface_tension *
                  (open_area(scene, last, flow.exposed) - open_area(scene, first, flow.exposed));
}

double work_imbalance(const Work& work) {
  const double done = work.tools + work.gravity + work.air, lost = work.dissipation + work.friction + work.impact_loss;
  return (done - lost - work.surface) / lost;
}

}  // namespace parison::forming
