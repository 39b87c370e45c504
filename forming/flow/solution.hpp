#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "forming/flow/balance.hpp"
#include "forming/flow/discretisation.hpp"

namespace parison::flow {

/// How the contact iteration ended and what it cost.
struct Convergence {
  bool converged = false;
  std::string reason;  ///< a sentence where it did not converge
  int iterations = 0;  ///< of the active set, refinements included
  int factorisations = 0;
  int contact_changes = 0;   ///< contacts closed or opened, over all iterations
  int locked = 0;            ///< contacts in tension that were kept closed, because opening them would cycle
  std::vector<bool> active;  ///< per candidate
};

/// Velocities, pressures, contact forces and tool velocities that balance each other with the active contacts, ready to
/// be evaluated.
struct Equilibrium : Convergence {
  Response response;
  Constraints constraints;  ///< of the nodes, friction included
  Discretisation discretisation;
  /// Velocities that dilate the glass at div v = 1/s, keep the contacts closed and put no force on driven tools; empty
  /// where they were not asked for or do not exist. Their stress is in none of the pressures and forces.
  Eigen::VectorXd dilatation_mode;           ///< two per node, m/s
  std::vector<double> tool_dilatation_mode;  ///< velocities of the tools with it, m/s
  double dilatation_rate = 0;                ///< share of the mode in the velocities, 1/s
  std::optional<AirLoads> air;               ///< of trapped air, where the problem has some
};

/// A pocket of trapped air at the end of a step.
struct PocketAfter {
  double pressure, volume;  ///< absolute, Pa; m3
  double outflow;           ///< of p V through the vent in the step, J
};

/// Adds `rate` (1/s) times the dilatation mode to the velocities of glass and tools, and to the prescribed div v;
/// pressures and forces stay as they are.
void add_dilatation(double rate, Equilibrium& equilibrium);

/// What the rest of a time step needs to know of the flow.
struct Solution : Convergence {
  Eigen::VectorXd velocity;                  ///< m/s, two per node
  Eigen::VectorXd pressure;                  ///< Pa, per vertex
  Eigen::VectorXd contact_pressure;          ///< Pa, per node, 0 without contact
  std::vector<double> tool_velocity;         ///< along the axis, m/s
  std::vector<double> tool_force;            ///< of the tool on the glass along the axis, N
  std::vector<double> dissipation;           ///< W at each quadrature point: cells x triangle_rule(4)
  double friction_power = 0;                 ///< lost by the glass where it slides along tools, W
  double impact_power = 0;                   ///< lost by glass that comes to rest on a tool within the step, W
  double correction_power = 0;               ///< of the corrections of volume and penetration, W: not physical
  double recovery_power = 0;                 ///< part of it that takes penetrated nodes out of tools, W
  double expansion_power = 0;                ///< taken by the change of density against the stress, W; negative: given
  Eigen::VectorXd dilatation_mode;           ///< m/s, two per node: Equilibrium::dilatation_mode
  std::vector<double> tool_dilatation_mode;  ///< m/s: likewise
  std::vector<bool>
      exposed;  ///< per boundary edge: at least one node free, so that gas pressure and surface tension act
  std::vector<PocketAfter> pockets;    ///< of trapped air, in the order of the problem
  std::vector<double> edge_pressure;   ///< gauge, per boundary edge, Pa, where exposed; empty without trapped air
  std::vector<Index> air_behind;       ///< per boundary edge, as in AirLoads; empty without trapped air
  std::vector<double> tool_air_force;  ///< of the tool on trapped air along the axis, N; empty without it
  double mean_rate = 0;                ///< root mean square of the rate of deformation sqrt(2 D:D) over the volume, 1/s
  double high_rate = 0;                ///< rate of deformation that `high_rate_fraction` of the volume exceeds, 1/s
};

/// Evaluates contact pressures, dissipation and powers of an equilibrium of `problem`. Of one that did not converge
/// only the convergence is passed on.
Solution evaluate(const Problem& problem, Equilibrium equilibrium);

}  // namespace parison::flow
