#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/solution.hpp"
#include "forming/state/state.hpp"
#include "forming/step/step_start.hpp"

namespace parison::forming {

inline constexpr double gas_constant_of_air = 287.05;  ///< J/(kg K)

/// Finds the sealed cavities at the start of a step and the air in each.
void seal_air(StepStart& start);

/// Stores the air that the step leaves in each cavity, and adds the forces of tools on it to those on the glass.
void store_air(const StepStart& start, const flow::Solution& solution, State& state);

}  // namespace parison::forming
