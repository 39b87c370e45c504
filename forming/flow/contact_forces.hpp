#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/constraints.hpp"

namespace parison::flow {

/// What the contacts do to the glass: per candidate the normal force, N (positive presses), the whole force along the
/// axis, N, and that along the surface (the normal turned left), N, which a node in a corner does not have.
struct ContactForces {
  Eigen::VectorXd normal, axial, sideways;
};

/// Splits the nodal reactions (two per node, N) of constrained nodes among their contacts.
ContactForces contact_forces(const Problem& problem, const std::vector<NodeConstraint>& constraints,
                             const Eigen::VectorXd& reaction);

/// Normal forces with those of mid-side nodes shared by their edge's ends: the weights by which a vertex is pressed or
/// pulled. At mid-side nodes the force itself.
Eigen::VectorXd lumped_forces(const Problem& problem, const std::vector<bool>& active,
                              const Eigen::VectorXd& normal_force);

/// Contact pressure per node, Pa: linear along each edge, from the shared forces over the shared contact areas `area`,
/// m2.
Eigen::VectorXd contact_pressure(const Problem& problem, const std::vector<bool>& active,
                                 const Eigen::VectorXd& normal_force, const Eigen::VectorXd& area);

/// Which nodes an active candidate presses.
std::vector<bool> nodes_in_contact(const Problem& problem, const std::vector<bool>& active);

}  // namespace parison::flow
