#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>

#include "core/mesh/mesh.hpp"

namespace parison::remesh {

/// Estimated error of a field's derivative: what recovery adds to it. O. C. Zienkiewicz, J. Z. Zhu, The superconvergent
/// patch recovery and a posteriori error estimates, parts 1 and 2, Int. J. Numer. Meth. Engng 33 (1992) 1331-1382.
struct DerivativeError {
  Eigen::VectorXd cell;   ///< root of the integral of its square over each cell
  double derivative = 0;  ///< the same of the recovered derivative itself, over the body
  double relative() const { return derivative > 0 ? cell.norm() / derivative : 0; }
};

/// Of the gradient of a nodal field.
DerivativeError gradient_error(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& nodal);

/// Of the rate of deformation, as a tensor, of nodal velocities, dim per node.
DerivativeError rate_error(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& velocity);

/// Edge lengths per cell with which a new mesh has the wanted relative error, the same in each of its cells, with the
/// fewest cells; infinite where there is no error. L.-Y. Li, P. Bettess, Notes on mesh optimal criteria in adaptive
/// finite element computations, Commun. Numer. Meth. Engng 11 (1995) 911-915.
Eigen::VectorXd equidistributing_sizes(const core::Mesh& mesh, const DerivativeError& error, double target);

}  // namespace parison::remesh
