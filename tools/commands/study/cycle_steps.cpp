// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>

#include "forming/scene/describe/unusual.hpp"
#include "forming/study/comparison/what_if/what_if.hpp"
#include "forming/study/production/cycle_files.hpp"
#include "tools/commands/study/cycle.hpp"
#include "tools/comparison/run_queue.hpp"
#include "tools/program/stop_request.hpp"

namespace parison::tools {
namespace {

/// How long production takes to the settled state, as far as it was followed.
std::string start_up_text(const forming::PeriodicState& state, const forming::PeriodicRequest& asked) {
  if (state.start_up.empty()) return "how long production takes to it is not known";
  const char* start = asked.changed_from.empty() ? "its start" : "the change";
  const std::size_t cycles = state.start_up.size() - 1;
  const double distance = state.start_up.back().distance;
  if (distance <= asked.tolerance) return fmt::format("production reaches it {} cycles after {}", cycles, start);
  return fmt::format("{} cycles after {} production is still {:.3g} K from it: start_up.csv ends there", cycles, start,
                     distance);
}

}  // namespace

void print_notes_on_cycle(const forming::Scene& scene, const forming::MachineCycle& machine, const std::string& whose) {
  for (const std::string& note : forming::unusual_values(scene))
    fmt::print("{}unusual, is it meant? {}\n", whose, note);
  for (const std::string& note : forming::notes_on_cycle(scene, machine)) fmt::print("{}{}\n", whose, note);
  std::fflush(stdout);
}

forming::PeriodicState find_settled(const forming::Scene& scene, const forming::MachineCycle& machine,
                                    const forming::PeriodicRequest& asked) {
  forming::PeriodicState state =
      forming::find_periodic_state(scene, machine, asked, stop_requested, [](const std::string& text) {
        fmt::print("  {}\n", text);
        std::fflush(stdout);
      });
  forming::write_periodic_state(scene, asked, state,
                                state.failure.empty() ? not_confirmed(state, asked) : state.failure);
  return state;
}

std::string search_lines(const forming::PeriodicState& state, const forming::PeriodicRequest& asked) {
  return fmt::format(
      "  {} forming run{} to the settled state, 2 more to confirm it; {}\n"
      "  all runs together give the tool surfaces of settled production to within {:.2g} K; those in {}/tools,\n"
      "  on which the settled container is made, differ from that by {:.2g} K\n",
      state.runs, state.runs == 1 ? "" : "s", start_up_text(state, asked), state.uncertainty, asked.directory,
      state.offset);
}

std::string cooling_lines(const forming::PeriodicState& state) {
  if (state.cooling.empty()) return {};
  std::string text = "  cooling that gives the wanted temperatures:\n";
  for (const forming::Cooling& one : state.cooling)
    text += fmt::format("    --set '{}={:.4g} W/m2/K'\n", one.key(), one.h);
  return text;
}

std::string not_confirmed(const forming::PeriodicState& state, const forming::PeriodicRequest& asked) {
  if (state.is_confirmed(asked.tolerance)) return {};
  return fmt::format(
      "--max-runs {}: the search ended after {} forming runs, before two plain cycles confirmed the tool surfaces to "
      "{:g} K: all runs together give them to within {:.2g} K, and those on which the settled container is made, whose "
      "results are there, differ from that by {:.2g} K. A finer accuracy "
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
