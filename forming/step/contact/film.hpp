#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Why glass between tools is too thin for the run to go on, a sentence; empty where it is not.
std::string film_failure(const Scene& scene, const State& state);

/// Cells of films thinner than the case allows, where it wants them frozen; empty where there are none.
std::vector<bool> frozen_cells(const Scene& scene, const State& state);

}  // namespace parison::forming
