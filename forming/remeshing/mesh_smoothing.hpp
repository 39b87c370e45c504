#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.hpp"

namespace parison::forming {

/// Carries the shift of the surface nodes since `from` into the mesh, where it fades: inner nodes follow the mean of
/// the cells around them.
void smooth_displacement(const core::Mesh& from, core::Mesh& mesh);

}  // namespace parison::forming
