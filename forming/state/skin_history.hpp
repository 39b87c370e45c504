#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/scene/scene.hpp"
#include "thermal/skin_history.hpp"

namespace parison::forming {

/// Adds an interval; one that goes on as the last one was is part of it.
void add_interval(thermal::SkinHistory& history, const thermal::SkinInterval& interval);

/// Adds the contact with a tool in a stage: `closed` under the largest of its pressures and forces, a `lowest`
/// conductance, W/m2/K, without them, and between where they change over time.
void add_pressed_intervals(const Stage& stage, const thermal::SkinLoad& closed, double lowest,
                           thermal::SkinHistory& history);

/// What a boundary of a body's outline exchanges heat with in the first stages, of such durations, s: air, radiation,
/// cooling or a given temperature, in intervals between the bends of their curves.
thermal::SkinHistory surroundings_history(const Scene& scene, Index body, std::size_t boundary,
                                          const std::vector<double>& durations);

}  // namespace parison::forming
