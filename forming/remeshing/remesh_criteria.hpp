#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "remesh/surface/resample.hpp"

namespace parison::forming {

/// What a new glass mesh of the state has to fulfil, by the accuracy of the scene: edge lengths, tool corners, the
/// projection out of the tools.
remesh::Criteria remesh_criteria(const Scene& scene, const State& state);

/// Whether the glass needs a new mesh: its worst cell is below numerics.quality_floor, its surface has reached the axis
/// or folded onto itself, after a first remeshing an edge of its surface has stretched to 1.5 times
/// numerics.surface_size, or the viscosity below the surface has come to vary so that a new mesh would have edges half
/// as long. Not where it has been given one since the last step: a run that was stopped before it could
/// try that step goes on with it.
bool needs_remesh(const Scene& scene, const State& state);

}  // namespace parison::forming
