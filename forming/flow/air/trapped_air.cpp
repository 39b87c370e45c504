// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/air/trapped_air.hpp"

#include <algorithm>
#include <cmath>

#include "core/mesh/element.hpp"
#include "forming/flow/surface.hpp"

namespace parison::flow {

using core::dim;

namespace {

bool carries_air(const Problem& problem, const core::BoundaryEdge& edge) {
  return problem.boundary_conditions[edge.boundary_id].kind == BoundaryCondition::Kind::free;
}

/// Passes what is behind exposed edges on to exposed neighbours that opened in this step, in both senses.
void spread(const std::vector<bool>& exposed, const std::vector<Index>& neighbour, std::vector<Index>& behind) {
  std::vector<Index> front;
  for (std::size_t e = 0; e < behind.size(); ++e)
    if (exposed[e] && behind[e] != no_air) front.push_back(static_cast<Index>(e));
  for (std::size_t i = 0; i < front.size(); ++i) {
    const Index to = neighbour[front[i]];
    if (!exposed[to] || behind[to] != no_air) continue;
    behind[to] = behind[front[i]];
    front.push_back(to);
  }
}

/// int N_i n dA of an edge, m2, for its three nodes.
std::array<Point, 3> normal_areas(const Problem& problem, const core::BoundaryEdge& edge) {
  std::array<Point, 3> areas{Point::Zero(), Point::Zero(), Point::Zero()};
  for (const auto& rule : core::edge_rule(3)) {
    const auto at = core::map_edge_point(*problem.mesh, edge.nodes, problem.geometry, rule);
    for (int i = 0; i < 3; ++i) areas[i] += at.area * at.shape[i] * at.normal;
  }
  return areas;
}

/// The tool that each node may touch, -1 without one.
std::vector<Index> nearest_tools(const Problem& problem) {
  std::vector<Index> tools(problem.mesh->nodes.size(), -1);
  for (const auto& candidate : problem.candidates)
    if (tools[candidate.node] < 0) tools[candidate.node] = candidate.tool;
  return tools;
}

/// Pressure that the weight of the glass makes over its whole height, Pa.
double weight_pressure(const Problem& problem) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Point& x : problem.mesh->nodes) {
    low = std::min(low, x.dot(core::axis_direction()));
    high = std::max(high, x.dot(core::axis_direction()));
  }
  return problem.material->density * std::abs(problem.gravity) * (high - low);
}

double gauge(const TrappedAir& air, Index behind, const Eigen::VectorXd& pressure) {
  return behind >= 0 ? pressure[behind] : behind == no_air ? -air.ambient : 0.0;
}

}  // namespace

std::vector<Index> air_behind(const Problem& problem, const std::vector<bool>& in_contact) {
  const core::Mesh& mesh = *problem.mesh;
  const core::BoundaryChain chain(mesh);
  std::vector<bool> exposed;
  for (const auto& edge : mesh.boundary_edges())
    exposed.push_back(carries_air(problem, edge) && !wholly_in_contact(edge, in_contact));
  std::vector<Index> behind = problem.air->behind;
  spread(exposed, chain.next, behind);
  spread(exposed, chain.previous, behind);
  std::vector<Index> result = behind;
  for (std::size_t e = 0; e < behind.size(); ++e)
    if (!exposed[e] && behind[e] != open_air) {
      result[e] = no_air;
      for (const Index neighbour : {chain.previous[e], chain.next[e]})
        if (result[e] == no_air && exposed[neighbour]) result[e] = behind[neighbour];
    }
  return result;
}

AirLoads air_loads(const Problem& problem, const std::vector<bool>& in_contact) {
  const core::Mesh& mesh = *problem.mesh;
  const TrappedAir& air = *problem.air;
  const Index rows = dim * mesh.node_count(), pockets = static_cast<Index>(air.pockets.size());
  AirLoads loads{air_behind(problem, in_contact), Eigen::MatrixXd::Zero(rows, pockets),
                 Eigen::MatrixXd::Zero(rows, pockets), Eigen::VectorXd::Zero(rows),
                 Eigen::VectorXd::Zero(static_cast<Index>(problem.tools.size()))};
  const auto tools = nearest_tools(problem);
  for (std::size_t e = 0; e < loads.behind.size(); ++e) {
    const auto& edge = mesh.boundary_edges()[e];
    const bool exposed = !wholly_in_contact(edge, in_contact);
    const Index behind = exposed ? loads.behind[e] : air.behind[e];  // an edge that lands sweeps its pocket
    if (behind == open_air || !carries_air(problem, edge) || (!exposed && behind < 0)) continue;
    const auto areas = normal_areas(problem, edge);
    for (int i = 0; i < 3; ++i) {
      const auto at = Eigen::seqN(dim * edge.nodes[i], dim);
      if (behind >= 0) loads.sweep(at, behind) -= areas[i];
      if (behind >= 0 && exposed) loads.unit(at, behind) -= areas[i];
      if (behind == no_air) loads.suction(at) += air.ambient * areas[i];
    }
    if (const Index tool = tools[edge.nodes[2]]; behind == no_air && tool >= 0)
      for (const Point& area : areas) loads.tool_force[tool] += air.ambient * area.dot(core::axis_direction());
  }
  return loads;
}

Eigen::VectorXd opening_forces(const Problem& problem, const AirLoads& loads, const Eigen::VectorXd& pressure,
                               const std::vector<bool>& in_contact, const std::vector<bool>& active) {
  const core::Mesh& mesh = *problem.mesh;
  // Glass that rests on the air of a cavity presses on the wall by less than that air, the more so the higher: air
  // creeps up there, by rates of the weight over the viscosity that vanish with the length of the seam.
  const double resting = weight_pressure(problem);
  Eigen::VectorXd nodal = Eigen::VectorXd::Zero(dim * mesh.node_count());
  for (std::size_t e = 0; e < loads.behind.size(); ++e) {
    const auto& edge = mesh.boundary_edges()[e];
    if (!wholly_in_contact(edge, in_contact) || !carries_air(problem, edge)) continue;
    const double p = gauge(*problem.air, loads.behind[e], pressure) - (loads.behind[e] >= 0 ? resting : 0);
    if (p == 0) continue;
    const auto areas = normal_areas(problem, edge);
    for (int i = 0; i < 3; ++i) nodal.segment<dim>(dim * edge.nodes[i]) -= p * areas[i];
  }
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(static_cast<Index>(problem.candidates.size()));
  for (std::size_t i = 0; i < active.size(); ++i)
    if (active[i])
      forces[Index(i)] = problem.candidates[i].normal.dot(node_velocity(nodal, problem.candidates[i].node));
  return forces;
}

std::vector<double> edge_pressures(const Problem& problem, const AirLoads& loads, const Eigen::VectorXd& pressure) {
  std::vector<double> pressures;
  for (std::size_t e = 0; e < loads.behind.size(); ++e)
    pressures.push_back(loads.behind[e] == open_air
                            ? problem.boundary_conditions[problem.mesh->boundary_edges()[e].boundary_id].pressure
                            : gauge(*problem.air, loads.behind[e], pressure));
  return pressures;
}

Eigen::VectorXd tool_air_forces(const Problem& problem, const AirLoads& loads, const Eigen::VectorXd& pressure) {
  Eigen::VectorXd forces = loads.tool_force;
  for (std::size_t j = 0; j < problem.air->pockets.size(); ++j)
    for (Index t = 0; t < forces.size(); ++t) forces[t] -= pressure[Index(j)] * problem.air->pockets[j].tool_area[t];
  return forces;
}

}  // namespace parison::flow
