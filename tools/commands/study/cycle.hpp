#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "forming/study/comparison/what_if/what_if.hpp"
#include "forming/study/production/periodic_state.hpp"
#include "forming/study/production/wanted_cooling.hpp"

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

/// What `parison cycle` is asked for.
struct CycleRequest {
  std::string case_path, accuracy = "standard", output, cycle_time, tolerance = "0.5 K";
  std::vector<std::string> overrides;
  std::vector<std::string> sets;    ///< "ring=2": tools of which sets take turns
  std::vector<std::string> wanted;  ///< "blank=450 degC": what the surfaces of tools are to settle to
  int max_runs = 12;
  bool error_bars = false;  ///< of the differences between the first gob's container and the settled one
  int jobs = 1;             ///< runs of the error bars at once
  std::vector<forming::WhatIfVariant> variants = {};  ///< changes, each with production of its own
};

/// Looks for the tool temperatures of settled production and prints what the container becomes there; with variants,
/// what each of them changes there. Returns the exit code.
int cycle(const CycleRequest& request);

/// What `parison cycle` is asked for, in numbers.
struct CyclePlan {
  std::optional<double> seconds;  ///< from one container to the next; none: that of the case
  double tolerance;               ///< K
  std::map<std::string, int> sets;
  std::vector<forming::WantedTool> wanted = {};
};

/// Settles production of the case and of each variant, compares the containers and prints which differences are real.
/// All variants are read before anything runs. Returns the exit code.
int cycle_variants(const CycleRequest& request, const CyclePlan& plan);

}  // namespace parison::tools
