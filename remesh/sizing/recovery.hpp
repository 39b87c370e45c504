#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>

#include "core/mesh/mesh.hpp"

namespace parison::remesh {

/// Estimated error of a field's derivative: its difference from the derivative recovered over patches of cells
/// (O. C. Zienkiewicz, J. Z. Zhu, Int. J. Numer. Meth. Engng 33 (1992) 1331-1364 and 1365-1382).
struct DerivativeError {
  Eigen::VectorXd cell;   ///< L2 norm of the error over each cell
  double derivative = 0;  ///< L2 norm of the recovered derivative over the body
  double relative() const { return derivative > 0 ? cell.norm() / derivative : 0; }
};

/// Error of the rate of deformation tensor of nodal velocities, core::dim values for each node.
DerivativeError rate_error(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& velocity);

}  // namespace parison::remesh
