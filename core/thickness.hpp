#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/mesh.hpp"

namespace parison::core {

/// Wall thickness at each node, m: at the surface the distance through the body along the inward normal, inside the value of
/// the nearest surface node. A ray that meets a symmetry piece goes on as its mirror image: twice the way to there.
Eigen::VectorXd wall_thickness(const Mesh& mesh, const std::vector<bool>& symmetry_pieces);

}  // namespace parison::core
