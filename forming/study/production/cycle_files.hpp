#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/study/production/periodic_state.hpp"

namespace parison::forming {

/// Writes cycle.json, cycle.csv (the settled cycle over time) and start_up.csv (cycle by cycle) into the folder.
/// `reason`: why the state is not the settled one; empty where it is.
void write_periodic_state(const Scene& scene, const PeriodicRequest& request, const PeriodicState& state,
                          const std::string& reason);

/// Tools of settled production as a table for the terminal: use, temperatures, heat and cooling.
std::string periodic_table(const Scene& scene, const PeriodicState& state);

}  // namespace parison::forming
