#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/study/production/periodic_state.hpp"

namespace parison::tools {

/// Prints what is unusual in a case whose settled production is looked for, each line behind `whose`.
void print_notes_on_cycle(const forming::Scene& scene, const forming::MachineCycle& machine, const std::string& whose);

/// Looks for the settled state of production, prints how it goes and writes its files.
forming::PeriodicState find_settled(const forming::Scene& scene, const forming::MachineCycle& machine,
                                    const forming::PeriodicRequest& asked);

/// How many runs the search took, how long production takes to the state found, and how well that is known, as lines.
std::string search_lines(const forming::PeriodicState& state, const forming::PeriodicRequest& asked);

/// The cooling that gives the wanted temperatures, as options of a run; empty where none were wanted.
std::string cooling_lines(const forming::PeriodicState& state);

/// Why the two plain cycles do not confirm a state that was found; empty where they do.
std::string not_confirmed(const forming::PeriodicState& state, const forming::PeriodicRequest& asked);

/// The coarser runs of containers in their folders, with the first of which the others are compared; false where they
/// were stopped.
bool make_coarser_runs(const std::string& case_path, const std::vector<std::string>& containers, int jobs);

}  // namespace parison::tools
