#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>

#include "core/mesh/mesh.hpp"

namespace parison::forming {

/// A field of the surface, one number for each node, zero inside, on a new mesh: at each new surface node that of the
/// nearest point of the old surface, interpolated as the interface with the tools does, but no new value leaves the
/// range of those of the old edge.
Eigen::VectorXd carry_along_surface(const core::Mesh& old, const Eigen::VectorXd& field, const core::Mesh& mesh);

}  // namespace parison::forming
