#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/cells/cell_product.hpp"
#include "forming/flow/constraints.hpp"
#include "forming/flow/contact_forces.hpp"

namespace parison::flow {

/// One iteration's outcome, all tools' velocities known.
struct Instant {
  Eigen::VectorXd unknowns;
  ContactForces forces;
  std::vector<double> tool_velocity;
};

/// Superposes `solution`, whose column 0 belongs to driven tools at rest and column 1 + k to each m/s of driven tool k,
/// with the nodal `reaction` likewise, so that the driven tools are in balance or at their speed limits.
Instant balance_tools(const Problem& problem, const std::vector<NodeConstraint>& constraints,
                      const Eigen::MatrixXd& solution, const Eigen::MatrixXd& reaction);

/// What friction takes where the glass slides along tools, W.
double friction_power(const Constraints& constraints, const Instant& instant);

/// Of glass that lands on tools within a step, W. A node moves freely until it lands and rests from then on, so the
/// tool does no work on it; the means of force and velocity over the step do, and that is what the mean velocities
/// dissipate too little.
double impact_power(const Problem& problem, const std::vector<bool>& active, const ContactForces& forces);

/// What it takes to lead the volume back against the pressure, W, less what tools give to nodes that they lead out of
/// themselves; `volume_load` is the wanted change of volume, m3/s, per vertex.
double correction_power(const Problem& problem, const std::vector<bool>& active, const ContactForces& forces,
                        const Eigen::VectorXd& pressure, const Eigen::VectorXd& volume_load);

/// Velocities, pressures and the velocities of the driven tools, with K x.
struct Iterate {
  Eigen::VectorXd x, force;
  Eigen::VectorXd driven;  ///< m/s, in the order of driven_tools
};

/// The batches of cells with a held node: all that pull at these.
std::vector<Index> constrained_batches(const core::Mesh& mesh, const Constraints& constraints);

/// Load minus K x minus friction, N and m3/s; at held coordinates it contains the reaction.
Eigen::VectorXd unbalanced(const Problem& problem, const Constraints& constraints, const Eigen::VectorXd& load,
                           const Iterate& iterate);

/// Computes K x anew and returns the largest unbalanced force against the products that make it up (the componentwise
/// backward error of Oettli and Prager, by which solvers decide on refinement: M. Arioli, J. Demmel, I. Duff, 1989).
double imbalance(const Problem& problem, const CellMatrices& cells, const Constraints& constraints,
                 const Eigen::VectorXd& load, Iterate& iterate);

}  // namespace parison::flow
