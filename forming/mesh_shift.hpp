#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene.hpp"
#include "forming/state.hpp"

namespace parison::forming {

/// Carries the shift of the surface nodes since `from` into the mesh, where it fades: inner nodes follow the mean of the cells
/// around them.
void spread_shift(const core::Mesh& from, core::Mesh& mesh);

/// Moves the surface that no tool touches along its normals, by the same distance everywhere, until the mesh has the volume
/// `wanted`, m3. Where no surface is free the volume stays as it is, for the flow to take back.
void restore_volume(const Scene& scene, const State& state, double wanted, core::Mesh& mesh);

}  // namespace parison::forming
