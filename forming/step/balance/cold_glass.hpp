#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// The glass at 20 degC: it shrinks from the temperatures of the state as an incompressible elastic body without loads
/// would, so that parts of different temperatures pull at each other. A body of one temperature shrinks exactly by the
/// density of both. Nothing where density does not depend on temperature, in a stage that cools, or where that has no
/// solution.
std::optional<core::Mesh> cold_glass(const Scene& scene, const State& state);

}  // namespace parison::forming
