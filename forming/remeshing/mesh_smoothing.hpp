#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Laplacian smoothing of a displacement: spreads the displacement of the surface nodes since `from` into the mesh;
/// each inner node takes the mean of the cells around it.
void smooth_displacement(const core::Mesh& from, core::Mesh& mesh);

/// Moves the surface along its normals until the mesh has the volume `target`, m3, to round-off: the part that no tool
/// touches, by the same distance everywhere, and does not enter a tool; the whole surface, contacts as well, where
/// nothing is free or the free part is so small that it would move far, for what is below a few micrometres there.
void restore_volume(const Scene& scene, const State& state, double target, core::Mesh& mesh);

}  // namespace parison::forming
