#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "forming/flow/problem.hpp"

namespace parison::flow {

/// Unknowns of a cell: the velocity of its 6 nodes, then the pressure at its 3 vertices.
inline constexpr int cell_velocities = 6 * core::dim;
inline constexpr int cell_unknowns = cell_velocities + 3;

/// Symmetric saddle-point matrices of all cells, row-major, with the load of gravity.
struct CellMatrices {
  std::vector<double> matrix;  ///< cells x cell_unknowns x cell_unknowns
  std::vector<double> load;    ///< cells x cell_unknowns

  const double* of(Index cell) const { return matrix.data() + std::size_t(cell) * cell_unknowns * cell_unknowns; }
};

/// Viscosity at each quadrature point (cells x triangle_rule(4)), Pa.s; `velocity` feeds the Carreau factor and may be empty.
std::vector<double> viscosity_field(const Problem& problem, const Eigen::VectorXd& velocity);

/// Taylor-Hood P2-P1 cells. The pressure block -1/bulk, local, keeps a full cavity regular; it is far below any volume drift that counts.
CellMatrices cell_matrices(const Problem& problem, const std::vector<double>& viscosity);

/// Load of surface tension and gas pressure on the boundary edges that are `exposed` (not pressed against a tool), N, two per node.
Eigen::VectorXd surface_load(const Problem& problem, const std::vector<bool>& exposed);

/// Contact area that belongs to each pressed node, m2: int N_i dA over the edges that are pressed at all three nodes, or over
/// all its edges where none is.
Eigen::VectorXd contact_areas(const core::Mesh& mesh, core::Geometry geometry, const std::vector<bool>& pressed);

/// 2 eta D:D dV at each quadrature point, W, and the high rate of deformation, 1/s.
void evaluate_dissipation(const Problem& problem, const std::vector<double>& viscosity, Solution& solution);

}  // namespace parison::flow
