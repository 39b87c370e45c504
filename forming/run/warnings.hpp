#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "forming/report/summary.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Sentences for the user of a run; empty where there is nothing to say.
using Warnings = std::vector<std::string>;

/// Of tools that were to come to rest in the present stage, which ended by its duration before they did.
Warnings moving_tool_warnings(const Scene& scene, const State& state);

/// How far the tool that a force drives in the present stage has stayed from where the glass fills the cavity, why, and
/// what to do; empty where the cavity is full. Nothing where no tool closes one, or where its force only holds what a
/// larger one has pressed before.
std::optional<std::string> unfilled_cavity(const Scene& scene, const State& state);

/// Of folds and torn pieces of the glass: what the container would show.
Warnings remeshing_warnings(const State& state);

/// Of interfaces that exchanged no heat in the whole run; bodies that start at the same temperature are skipped.
Warnings unused_interface_warnings(const Scene& scene, const State& state);

/// Bodies whose temperatures at the start are steeper than the meshes of the state, which has just begun.
Warnings start_field_warnings(const Scene& scene, const State& state);

/// Adds them to the warnings of a run.
void add_warnings(const Warnings& warnings, RunFacts& facts);

}  // namespace parison::forming
