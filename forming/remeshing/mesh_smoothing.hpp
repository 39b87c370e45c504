#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.hpp"

namespace parison::forming {

/// Laplacian smoothing of a displacement: spreads the displacement of the surface nodes since `from` into the mesh;
/// each inner node takes the mean of the cells around it.
void smooth_displacement(const core::Mesh& from, core::Mesh& mesh);

}  // namespace parison::forming
