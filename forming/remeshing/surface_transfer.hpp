#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>

#include "core/mesh/mesh.hpp"

namespace parison::forming {

/// A field of the surface, one number for each node, zero inside, on a new mesh: at each new surface node that of the
/// nearest point of the old surface, linear between its nodes, so that no new value leaves the range of the old ones.
Eigen::VectorXd carry_along_surface(const core::Mesh& old, const Eigen::VectorXd& field, const core::Mesh& mesh);

}  // namespace parison::forming
