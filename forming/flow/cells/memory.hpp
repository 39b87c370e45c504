#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "forming/flow/cells/element_matrix.hpp"

namespace parison::flow {

/// Adds to the cells' matrices what makes the viscous forces those of the deviator of D alone: -2/3 eta div v div u.
void leave_out_dilatation(const Problem& problem, const CellGeometry& geometry, const std::vector<double>& viscosity,
                          CellMatrices& cells);

/// Right-hand side of the stress and the pressure that glass with a memory has at the start of a step, and of its
/// thermal expansion: N, two per node, then m3/s, one per vertex.
Eigen::VectorXd memory_load(const Problem& problem, const CellGeometry& geometry);

/// Strain of a quadrature point: its deviator, and the rotation in the section from r to z, rad.
struct PointStrain {
  SectionTensor deviator;
  double rotation;
};
/// Strains by a displacement, two per node, m, at each quadrature point, cells x cell_points.
std::vector<PointStrain> strains(const core::Mesh& mesh, const CellGeometry& geometry,
                                 const Eigen::VectorXd& displacement);

}  // namespace parison::flow
