#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.hpp"
#include "remesh/solid/wall_mesh.hpp"

namespace parison::remesh {

/// Values at the nodes of a wall of a nodal field of the section it was turned from. Through each column they come as
/// near as they can to the field (least squares), within the range that it has there: values at the nodes alone would
/// miss a skin that lies between two of them.
Eigen::VectorXd column_values(const core::Mesh& section, const Eigen::VectorXd& field, const WallMesh& wall);

}  // namespace parison::remesh
