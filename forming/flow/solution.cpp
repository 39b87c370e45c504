// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/solution.hpp"

#include <utility>

#include "forming/flow/cells/expansion.hpp"
#include "forming/flow/contact/grip.hpp"

namespace parison::flow {

using core::dim;

namespace {

/// Power that friction dissipates where the glass slides along tools, W.
double friction_power(const Constraints& constraints, const Response& response) {
  double power = 0;
  for (const auto& constraint : constraints.nodes) {
    if (constraint.friction_tool < 0) continue;
    const Point relative = node_velocity(response.unknowns, constraint.node) -
                           response.tool_velocity[constraint.friction_tool] * core::axis_direction();
    const double slip = constraint.basis.col(dim - 1).dot(relative);
    power += (constraints.tangential_stiffness[constraint.node] * slip + constraints.tangential_load[constraint.node]) *
             slip;
  }
  return power;
}

/// Power lost by glass that lands on tools within the step (an inelastic impact), W. A node moves freely until it lands
/// and rests from then on, so the tool does no work on it; but the product of its mean force and mean velocity over the
/// step is not zero, and this product is missing in the dissipation of the mean velocities.
double impact_power(const Problem& problem, const std::vector<bool>& active, const Constraints& constraints,
                    const ContactForces& forces) {
  double power = 0;
  for (std::size_t i = 0; i < active.size(); ++i) {
    if (!active[i]) continue;
    const auto& candidate = problem.candidates[i];
    if (candidate.rate < 0) power -= forces.normal[i] * candidate.rate;
    if (sticks(problem, candidate) && constraints.find(candidate.node)->friction_tool < 0)
      power -= forces.sideways[i] * (1 - candidate.contact_fraction) *
               candidate.approach_velocity.dot(perpendicular(candidate.normal));
  }
  return power;
}

/// Power of the corrections, W: the prescribed change of volume `volume_load` (minus m3/s per vertex) against the
/// pressure, and the tools that push penetrated nodes out.
double correction_power(const Problem& problem, const std::vector<bool>& active, const ContactForces& forces,
                        const Eigen::VectorXd& pressure, const Eigen::VectorXd& volume_load) {
  double power = pressure.dot(volume_load);
  for (std::size_t i = 0; i < active.size(); ++i)
    if (active[i] && problem.candidates[i].rate > 0) power -= forces.normal[i] * problem.candidates[i].rate;
  return power;
}

/// Power of the tools that push penetrated nodes out, W.
double recovery_power(const Problem& problem, const std::vector<bool>& active, const ContactForces& forces) {
  double power = 0;
  for (std::size_t i = 0; i < active.size(); ++i)
    if (active[i]) power -= forces.normal[i] * problem.candidates[i].recovery;
  return power;
}

/// Contact pressures, forces on tools, and the edges that air and surface tension act on.
void evaluate_contact(const Problem& problem, const Equilibrium& equilibrium, Solution& result) {
  const auto& mesh = *problem.mesh;
  const ContactForces& forces = equilibrium.response.forces;
  const auto in_contact = nodes_in_contact(problem, equilibrium.active);
  const Eigen::VectorXd area = contact_areas(mesh, equilibrium.discretisation.surface, in_contact);
  result.contact_pressure = contact_pressure(problem, equilibrium.active, forces.normal, area);
  result.tool_force.assign(problem.tools.size(), 0.0);
  for (std::size_t i = 0; i < problem.candidates.size(); ++i)
    result.tool_force[problem.candidates[i].tool] += forces.axial[i];
  for (const auto& edge : mesh.boundary_edges())
    result.exposed.push_back(!(in_contact[edge.nodes[0]] && in_contact[edge.nodes[1]] && in_contact[edge.nodes[2]]));
}

/// Forces of the tools that hold glass by their form, and what it loses that moves against them.
void evaluate_grips(const Problem& problem, const Equilibrium& equilibrium, Solution& result) {
  Eigen::VectorXd resistance = equilibrium.discretisation.grip_resistance;
  if (resistance.size() == 0) return;
  for (const ContactCandidate& candidate : problem.candidates) {
    if (!held_by_form(problem, candidate)) continue;
    const Point relative =
        node_velocity(result.velocity, candidate.node) - result.tool_velocity[candidate.tool] * core::axis_direction();
    const double here = std::exchange(resistance[candidate.node], 0);  // a node in a corner counts once
    result.tool_force[candidate.tool] -= here * relative.dot(core::axis_direction());
    result.friction_power += here * relative.squaredNorm();
  }
}

/// What the step leaves of trapped air.
void evaluate_air(const Problem& problem, const Equilibrium& equilibrium, Solution& result) {
  if (!problem.air) return;
  const TrappedAir& air = *problem.air;
  const Eigen::VectorXd& pressure = equilibrium.response.air_pressure;
  result.air_behind = equilibrium.air->behind;
  result.edge_pressure = edge_pressures(problem, *equilibrium.air, pressure);
  const Eigen::VectorXd force = tool_air_forces(problem, *equilibrium.air, pressure);
  result.tool_air_force.assign(force.begin(), force.end());
  const Eigen::VectorXd swept = equilibrium.air->sweep.transpose() * result.velocity;
  for (std::size_t j = 0; j < air.pockets.size(); ++j) {
    const AirPocket& pocket = air.pockets[j];
    double rate = swept[Index(j)];
    for (std::size_t t = 0; t < result.tool_velocity.size(); ++t) rate += pocket.tool_area[t] * result.tool_velocity[t];
    const double absolute = air.ambient + pressure[Index(j)];
    result.pockets.push_back(
        {absolute, pocket.volume + air.dt * rate, air.dt * vent_outflow(pocket.vent, absolute, air.ambient).value});
  }
}

/// Dissipation, rates of deformation, and the powers of friction, impact and corrections.
void evaluate_powers(const Problem& problem, const Equilibrium& equilibrium, Solution& result) {
  const Discretisation& discretisation = equilibrium.discretisation;
  Eigen::VectorXd shear = result.velocity;
  // Stress times rate of deformation: with v = u + d, d the dilatation that has no stress, 2 eta D(u):D(v) is
  // 2 eta D(v - d/2):D(v - d/2) but for 2 eta D(d/2):D(d/2), which is negligible.
  if (equilibrium.dilatation_mode.size() > 0)
    shear = result.velocity - 0.5 * (equilibrium.dilatation_rate * equilibrium.dilatation_mode);
  auto viscous = dissipation(problem, discretisation.geometry, discretisation.viscosity, shear);
  if (!problem.expansion_rate.empty())
    result.expansion_power = result.pressure.dot(discretisation.expansion_load.tail(result.pressure.size())) +
                             leave_out_expansion(problem, discretisation.geometry, discretisation.viscosity, shear,
                                                 equilibrium.dilatation_rate, viscous);
  result.dissipation = std::move(viscous.power);
  result.mean_rate = viscous.mean_rate;
  result.high_rate = viscous.high_rate;
  const Response& response = equilibrium.response;
  result.friction_power = friction_power(equilibrium.constraints, response);
  result.impact_power = impact_power(problem, equilibrium.active, equilibrium.constraints, response.forces);
  result.recovery_power = recovery_power(problem, equilibrium.active, response.forces);
  result.correction_power = correction_power(problem, equilibrium.active, response.forces, result.pressure,
                                             discretisation.load.tail(result.pressure.size()));
}

}  // namespace

void add_dilatation(double rate, Equilibrium& equilibrium) {
  const Eigen::VectorXd& mode = equilibrium.dilatation_mode;
  Response& response = equilibrium.response;
  response.unknowns.head(mode.size()) += rate * mode;
  for (std::size_t t = 0; t < response.tool_velocity.size(); ++t)
    response.tool_velocity[t] += rate * equilibrium.tool_dilatation_mode[t];
  equilibrium.discretisation.load += rate * equilibrium.discretisation.dilatation_load;
  equilibrium.dilatation_rate += rate;
}

Solution evaluate(const Problem& problem, Equilibrium equilibrium) {
  Solution result;
  static_cast<Convergence&>(result) = equilibrium;
  if (!result.converged) return result;
  const Index vertices = problem.mesh->vertex_count();
  const Eigen::VectorXd& unknowns = equilibrium.response.unknowns;
  result.velocity = unknowns.head(unknowns.size() - vertices);
  result.pressure = unknowns.tail(vertices);
  result.tool_velocity = equilibrium.response.tool_velocity;
  evaluate_contact(problem, equilibrium, result);
  evaluate_powers(problem, equilibrium, result);
  evaluate_grips(problem, equilibrium, result);
  evaluate_air(problem, equilibrium, result);
  result.dilatation_mode = std::move(equilibrium.dilatation_mode);
  result.tool_dilatation_mode = std::move(equilibrium.tool_dilatation_mode);
  return result;
}

}  // namespace parison::flow
