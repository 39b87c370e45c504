#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/cells/element_matrix.hpp"
#include "forming/flow/surface.hpp"

namespace parison::flow {

// A tool of given velocity that grips (Friction::Law::grip) holds tied glass by its form, as the threads of a ring hold
// a finish: it drags the glass along, and what is pulled off comes off slowly. So glass that shrinks as it cools leaves
// the tool. The drag is the same whether the glass presses or not: the force then grows with every motion against it,
// and one state is in balance. With glass that sticks where it presses and is free where it does not, cold glass
// between two tools closes and opens by turns, with forces of its viscosity. What else is tied, to a tool driven by its
// force, does not come off.

/// Traction over velocity with which such a tool holds glass, Pa.s/m, assumed: the weight of a container, some 100 Pa
/// on its finish, creeps by micrometres in ten seconds; cold glass that shrinks off at 0.1 mm/s meets 0.1 MPa.
inline constexpr double grip_drag = 1e9;

/// Gap up to which it does, as a share of the size of the glass: of a gob of 66 mm 1 mm, about the depth of the threads
/// of a finish.
inline constexpr double depth_of_form = 1.5e-2;

/// Whether a tied candidate may open, held by the form of its tool.
bool held_by_form(const Problem& problem, const ContactCandidate& candidate);

/// Leaves the vertices of glass that a tool grips out of a right-hand side of div v: it cannot expand.
void leave_out_gripped(const Problem& problem, Eigen::VectorXd& load);

/// Resistance of each node to motion against the tool that holds it by its form, N.s/m; empty where none is held.
/// Beside a corner in which the glass may be wedged along the tool it gives way as there (wedged_corner.hpp).
Eigen::VectorXd grip_resistance(const Problem& problem, const std::vector<SurfaceEdge>& surface);

/// Adds these resistances to the matrices of the cells.
void add_grips(const core::Mesh& mesh, const Eigen::VectorXd& resistance, CellMatrices& cells);

/// Resistance times the velocity of the tools, N, two per node.
Eigen::VectorXd grip_load(const Problem& problem, const Eigen::VectorXd& resistance);

}  // namespace parison::flow
