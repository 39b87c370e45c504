#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/contact/constraints.hpp"

namespace parison::flow {

/// Forces of the contacts on the glass, N, one entry per candidate.
struct ContactForces {
  Eigen::VectorXd normal;    ///< positive in compression
  Eigen::VectorXd axial;     ///< component of the whole force along the axis
  Eigen::VectorXd sideways;  ///< component along the surface (the normal turned left); 0 at a node with two contacts

  /// Adds a multiple of other forces of the same candidates.
  void add(double factor, const ContactForces& other) {
    normal += factor * other.normal;
    axial += factor * other.axial;
    sideways += factor * other.sideways;
  }
};

/// Splits the nodal reactions (two per node, N) of constrained nodes among their contacts. A node with two contacts has
/// a normal force of each and no tangential force.
ContactForces contact_forces(const Problem& problem, const std::vector<NodeConstraint>& constraints,
                             const Eigen::VectorXd& reaction);

/// Adds half of each mid-side value to the vertices of its edge.
Eigen::VectorXd distribute_mid_sides(const core::Mesh& mesh, const Eigen::VectorXd& nodal);

/// Normal forces per node, N, those of mid-side nodes added in halves to the vertices of their edge (lumping to linear
/// shape functions). At mid-side nodes the consistent force itself.
Eigen::VectorXd lumped_forces(const Problem& problem, const std::vector<bool>& active,
                              const Eigen::VectorXd& normal_force);

/// Contact pressure per node, Pa, linear along each edge: lumped force over lumped contact area (`area`, m2 per node).
Eigen::VectorXd contact_pressure(const Problem& problem, const std::vector<bool>& active,
                                 const Eigen::VectorXd& normal_force, const Eigen::VectorXd& area);

/// Flags of the nodes with an active candidate.
std::vector<bool> nodes_in_contact(const Problem& problem, const std::vector<bool>& active);

}  // namespace parison::flow
