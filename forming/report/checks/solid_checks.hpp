#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/checks/check.hpp"
#include "forming/report/summary.hpp"
#include "forming/solid/solid_state.hpp"

namespace parison::forming {

/// The numbers of glass in space that are watched; `clock` has the stage and the places of tools. The capacity and the
/// height are those of a run that has completed.
void add_solid_checks(const Scene& scene, const State& clock, const SolidState& solid, const RunFacts& facts,
                      Checks& checks);

}  // namespace parison::forming
