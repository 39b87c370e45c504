// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/study/cycle_steps.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "forming/scene/describe/unusual.hpp"
#include "forming/study/comparison/what_if/what_if.hpp"
#include "forming/study/production/cycle_files.hpp"
#include "tools/comparison/run_queue.hpp"
#include "tools/program/stop_request.hpp"

namespace parison::tools {

void print_notes_on_cycle(const forming::Scene& scene, const forming::MachineCycle& machine, const std::string& whose) {
  for (const std::string& note : forming::unusual_values(scene))
    fmt::print("{}unusual, is it meant? {}\n", whose, note);
  for (const std::string& note : forming::notes_on_cooling(scene, machine)) fmt::print("{}{}\n", whose, note);
  std::fflush(stdout);
}

forming::PeriodicState find_settled(const forming::Scene& scene, const forming::MachineCycle& machine,
                                    const forming::PeriodicRequest& asked) {
  forming::PeriodicState state =
      forming::find_periodic_state(scene, machine, asked, stop_requested, [](const std::string& text) {
        fmt::print("  {}\n", text);
        std::fflush(stdout);
      });
  forming::write_periodic_state(scene, asked, state);
  return state;
}

std::string not_confirmed(const forming::PeriodicState& state, const forming::PeriodicRequest& asked) {
  if (state.is_confirmed(asked.tolerance)) return {};
  return fmt::format(
      "--max-runs {}: the search ended after {} forming runs, before two plain cycles confirmed the tool surfaces to "
      "{:g} K: they are known to {:.2g} K, and {:.2g} K from the state found, whose results are there. A finer "
      "accuracy "
      "scatters less, a larger --max-runs goes on longer, a wider --tolerance takes what was reached, each in a new "
      "--output",
      asked.max_runs, state.search.size(), asked.tolerance, state.uncertainty, state.offset);
}

bool make_coarser_runs(const std::string& case_path, const std::vector<std::string>& containers, int jobs) {
  std::vector<QueuedRun> runs;
  for (auto& plan : forming::plan_partner_runs(case_path, containers)) runs.push_back({std::move(plan)});
  fmt::print("\n{} coarser runs for the error bars\n", runs.size());
  std::fflush(stdout);
  return run_all(runs, case_path, jobs);
}

}  // namespace parison::tools
