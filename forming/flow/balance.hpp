#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/air/air_balance.hpp"
#include "forming/flow/cells/cell_product.hpp"
#include "forming/flow/contact/constraints.hpp"
#include "forming/flow/contact/contact_forces.hpp"

namespace parison::flow {

/// How glass and tools respond to a load: velocities and pressures of the glass (one per unknown, m/s and Pa), forces
/// of the candidates, velocities of all tools along the axis, m/s.
struct Response {
  Eigen::VectorXd unknowns;
  ContactForces forces;
  std::vector<double> tool_velocity;
  Eigen::VectorXd air_pressure;  ///< of the pockets of trapped air, gauge, Pa
};

/// The iterate of Newton's method: velocities and pressures x, the velocities of the driven tools, and the forces K x.
struct Iterate {
  Eigen::VectorXd x, force;
  Eigen::VectorXd driven;        ///< m/s, in the order of driven_tools
  Eigen::VectorXd air_pressure;  ///< of the pockets of trapped air, gauge, Pa
};

/// Solutions of the linear equations from which any velocity of the driven tools is superposed: column 0 with these
/// tools at rest and trapped air at ambient pressure, column 1 + k for each m/s of driven tool k, then one for each Pa
/// of each pocket of air. Rows: unknowns; nodal reactions at constrained nodes, N,
/// two per node.
struct ToolSuperposition {
  Eigen::MatrixXd unknowns, reaction;
};

/// The iterate plus its correction (columns as in ToolSuperposition, column 0 with the driven tools at the iterate's
/// velocities and the air at its pressures), as columns for the driven tools at rest and for each m/s of them. `cells`
/// are the matrices that gave the correction; `air` is null without trapped air.
ToolSuperposition superpose(const Problem& problem, const CellMatrices& cells, const Constraints& constraints,
                            const Eigen::VectorXd& load, Eigen::MatrixXd correction, const Iterate& iterate,
                            const AirLoads* air);

/// Superposes the columns so that every driven tool is in force balance or at its speed limit, and that trapped air has
/// the pressures that belong to its volumes. `air` is null without trapped air; `first_guess` holds its pressures, Pa.
Response balance_tools(const Problem& problem, const std::vector<NodeConstraint>& constraints,
                       const ToolSuperposition& columns, const AirLoads* air, const Eigen::VectorXd& first_guess);

/// Batches of cells with a constrained node: the only ones that contribute to reactions.
std::vector<Index> constrained_batches(const core::Mesh& mesh, const Constraints& constraints);

/// Residual load - K x - friction, N and m3/s per unknown; at constrained coordinates it contains the reaction.
Eigen::VectorXd residual(const Problem& problem, const Constraints& constraints, const Eigen::VectorXd& load,
                         const Iterate& iterate);

/// Evaluates K x into the iterate and returns its componentwise backward error max |r_i| / (|K| |x| + |load|)_i (W.
/// Oettli, W. Prager, 1964, Numer. Math. 6, 405-409; as criterion of iterative refinement: M. Arioli, J. Demmel, I.
/// Duff, 1989, SIAM J. Matrix Anal. Appl. 10, 165-190). |K| is the sum of the cells' absolute values.
double backward_error(const Problem& problem, const CellMatrices& cells, const Constraints& constraints,
                      const Eigen::VectorXd& load, Iterate& iterate);

}  // namespace parison::flow
