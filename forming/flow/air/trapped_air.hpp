#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "forming/flow/air/air_pocket.hpp"

namespace parison::flow {

struct Problem;
struct Response;

/// What is behind a boundary edge of the glass: the index of a pocket, or one of these.
inline constexpr Index open_air = -1;  ///< the pressure of its boundary condition
inline constexpr Index no_air = -2;    ///< contact, or a void that opens in this step

/// The air in sealed cavities during a step.
struct TrappedAir {
  double ambient;                  ///< absolute pressure around the machine, Pa; gauge pressures count from there
  double dt;                       ///< length of the step, s
  std::vector<Index> behind;       ///< each boundary edge at the step's start
  std::vector<AirPocket> pockets;  ///< voids without air have no energy
};

/// What is behind each boundary edge with the given nodes in contact. An edge that has opened belongs to what its
/// exposed neighbours have behind them, or is a void. An edge in contact has behind it what would enter first: the air
/// of an exposed neighbour, otherwise none.
std::vector<Index> air_behind(const Problem& problem, const std::vector<bool>& in_contact);

/// Forces of the air in sealed cavities on the glass, two rows per node.
struct AirLoads {
  std::vector<Index> behind;   ///< per boundary edge
  Eigen::MatrixXd unit;        ///< N per Pa of each pocket, on edges with a node out of contact
  Eigen::MatrixXd sweep;       ///< rate of each pocket's volume per velocity, m2; edges that land count too
  Eigen::VectorXd suction;     ///< of voids that open, N
  Eigen::VectorXd tool_force;  ///< of each tool on the voids that open, N along the axis
};
AirLoads air_loads(const Problem& problem, const std::vector<bool>& in_contact);

/// Normal force of each active contact at which it would open, N: negative where no air can enter. `pressure` holds the
/// gauge pressures of the pockets, Pa. The air of a pocket enters where it presses by more than the weight of the
/// glass.
Eigen::VectorXd opening_forces(const Problem& problem, const AirLoads& loads, const Eigen::VectorXd& pressure,
                               const std::vector<bool>& in_contact, const std::vector<bool>& active);

/// Gauge pressure on each boundary edge that no tool covers, Pa.
std::vector<double> edge_pressures(const Problem& problem, const AirLoads& loads, const Eigen::VectorXd& pressure);

/// Force of each tool on the air in sealed cavities, N along the axis.
Eigen::VectorXd tool_air_forces(const Problem& problem, const AirLoads& loads, const Eigen::VectorXd& pressure);

}  // namespace parison::flow
