#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "thermal/problem.hpp"

namespace parison::forming {

/// What each boundary of a body's mesh exchanges heat with in the present stage, over the time of the run: its cooling,
/// that of the stage, the air or the air inside; none where it exchanges none. The boundaries of the outline come first
/// in the mesh, before those that a stage names.
std::vector<std::optional<thermal::SurfaceExchange>> surroundings(const Scene& scene, const State& state, Index body,
                                                                  const core::Mesh& mesh);

/// What the glass exchanges heat with in the air of the present stage, outside or inside, as an opaque grey surface.
thermal::SurfaceExchange air_at_glass(const Scene& scene, const State& state, bool inside);

/// What the light of a body meets at each boundary of its mesh where no tool stands, the surroundings of the air there,
/// and where the body is. With an enclosure every body in place has surroundings.
thermal::SurfaceLight surface_light(const Scene& scene, const State& state, Index body, const core::Mesh& mesh);

}  // namespace parison::forming
