#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/flow/cells/element_matrix.hpp"

namespace parison::flow {

// Glass whose density changes: div v = e at each quadrature point, e = Problem::expansion_rate, and viscous stress
// 2 eta (D - e/3 I), so that glass which expands freely has none.

/// Right-hand side of both, one entry per unknown, N and m3/s. Glass that a tool grips cannot expand: its vertices are
/// left out.
Eigen::VectorXd expansion_load(const Problem& problem, const CellGeometry& geometry,
                               const std::vector<double>& viscosity);

/// Divergence at point q of a cell for velocities by node, 1/s.
double divergence(const core::Mesh& mesh, const CellGeometry& geometry, Index cell, int q,
                  const Eigen::VectorXd& velocity);

/// Makes the dissipation of `velocity`, by 2 eta D:D, that of glass which expands, and gives what is then missing to
/// the power of the stresses but for that of the pressure, W: div v is e in the mean over a vertex's cells alone.
/// `dilatation_rate` is the share of the dilatation mode in the flow, 1/s, half of which `velocity` lacks.
double leave_out_expansion(const Problem& problem, const CellGeometry& geometry, const std::vector<double>& viscosity,
                           const Eigen::VectorXd& velocity, double dilatation_rate, Dissipation& dissipation);

}  // namespace parison::flow
