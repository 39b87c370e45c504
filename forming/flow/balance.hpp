#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/cell_product.hpp"
#include "forming/flow/constraints.hpp"

namespace parison::flow {

/// Velocities, pressures and the velocities of the driven tools, with K x.
struct Iterate {
  Eigen::VectorXd x, force;
  Eigen::VectorXd driven;  ///< m/s, in the order of driven_tools
};

/// The batches of cells with a held node: all that pull at these.
std::vector<Index> held_batches(const core::Mesh& mesh, const Held& held);

/// Load minus K x minus friction, N and m3/s; at held coordinates it contains the reaction.
Eigen::VectorXd unbalanced(const Problem& problem, const Held& held, const Eigen::VectorXd& load, const Iterate& iterate);

/// Computes K x anew and returns the largest unbalanced force against the products that make it up (the componentwise backward
/// error of Oettli and Prager, by which solvers decide on refinement: M. Arioli, J. Demmel, I. Duff, 1989).
double imbalance(const Problem& problem, const CellMatrices& cells, const Held& held, const Eigen::VectorXd& load,
                 Iterate& iterate);

}  // namespace parison::flow
