#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Advances the temperatures of the tools by dt, s, from the state's time where no glass touches them: each exchanges
/// heat with its cooling and the air as the state's stage has it, which goes into ToolState::heat_through. Tools
/// that wait for their first use stay as they are. Returns why this failed; empty where it did not.
std::string idle_tools(const Scene& scene, State& state, double dt);

}  // namespace parison::forming
