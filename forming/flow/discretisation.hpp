#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/cells/cell_product.hpp"
#include "forming/flow/surface.hpp"

namespace parison::flow {

/// The discretised Stokes equations K x = f of one mesh, before any contact: Taylor-Hood triangles (C. Taylor, P. Hood,
/// 1973, Computers & Fluids 1, 73-100) with quadratic velocities and continuous linear pressures. Unknowns x: two
/// velocities per node, m/s, then one pressure per vertex, Pa.
struct Discretisation {
  CellGeometry geometry;
  std::vector<SurfaceEdge> surface;
  std::vector<double> viscosity;  ///< Pa.s, cells x cell_points
  CellMatrices cells;             ///< K with that viscosity
  CellMatrices
      shear_thinning_jacobian;      ///< d(K x)/dx or K, as the last linearisation chose; empty without shear thinning
  Eigen::VectorXd grip_resistance;  ///< of each node to motion against the tool that holds it, N.s/m; empty without
  Eigen::VectorXd dilatation_load;  ///< right-hand side of div v = 1/s, one entry per unknown
  Eigen::VectorXd load;             ///< gravity, body force, grips and the prescribed div v, one per unknown, N, m3/s
  Eigen::VectorXd expansion_load;   ///< of the change of density, likewise; empty without one

  /// The matrices of the linearised equations.
  const CellMatrices& jacobian() const {
    return shear_thinning_jacobian.batches.empty() ? cells : shear_thinning_jacobian;
  }
};

/// Discretises a problem with the viscosity of glass at rest.
Discretisation discretise(const Problem& problem);

/// Evaluates the viscosity and the cell matrices at a velocity (two per node, m/s; empty: at rest).
void update_viscosity(const Problem& problem, const Eigen::VectorXd& velocity, Discretisation& discretisation);

}  // namespace parison::flow
