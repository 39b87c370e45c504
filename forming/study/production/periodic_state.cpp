// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/periodic_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include "core/io/files.hpp"
#include "core/io/written_files.hpp"
#include "forming/report/summary.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/study/production/cycle_files.hpp"
#include "forming/study/production/heat_cycles.hpp"
#include "forming/study/production/machine_cycle.hpp"
#include "forming/study/production/settled_estimates.hpp"
#include "forming/study/production/tool_fields.hpp"

namespace parison::forming {
namespace {

/// Of Anderson's acceleration; the first iterations are plain ones, which come close to the state in most scenes.
constexpr int anderson_depth = 2, anderson_delay = 2;

/// Heat-only cycles settle until one changes them by this share of the tolerance; those of a tool that takes hundreds
/// are hundreds of times as far from where they settle.
constexpr double heat_only_share = 0.002;

/// The search and what it has so far.
struct Search {
  Scene& scene;  ///< its cooling is changed while it is looked for
  const PeriodicRequest& request;
  const StopRequest& stop;
  const Progress& progress;
  State initial;  ///< meshes and probes
  HeatCycles heat_cycles;
  SwabImprint swab;
  SettledEstimates estimates;
  PeriodicState& result;
  bool cooling_is_open;  ///< it is still looked for
};

/// A cycle of a scene, in a folder of that name unless it is empty; false where it failed.
bool cycle_of(Search& search, const Scene& scene, const std::string& folder, CycleRun& run) {
  const std::string directory = folder.empty() ? "" : search.request.directory + '/' + folder;
  run = run_cycle(scene, search.result.cycle, directory, search.stop);
  search.result.stopped = run.stopped;
  search.result.failure = run.failure;
  if (run.failure.empty() && search.swab.exists()) run.end += search.swab.mean();
  return run.failure.empty();
}

/// To two figures that are not below it.
double rounded_up(double value) {
  const double digit = std::pow(10, std::floor(std::log10(value)) - 1);
  return digit * std::ceil(value / digit * (1 - 1e-12));
}

std::string cooling_text(const std::vector<Cooling>& cooling) {
  std::vector<std::string> parts;
  for (const Cooling& one : cooling)
    parts.push_back(fmt::format("{}.{} h = {:.4g} W/m2/K", one.tool, one.boundary, one.h));
  return fmt::format("cooling for the wanted temperatures: {}", fmt::join(parts, ", "));
}

std::string largest_text(const Scene& scene, const std::vector<double>& values) {
  const auto largest = std::max_element(values.begin(), values.end());
  return fmt::format("{:.3g} K ({})", *largest, scene.tools[static_cast<std::size_t>(largest - values.begin())].name);
}

/// While cooling is looked for: that which the heat of this run asks for, and the state to which tools settle with it.
bool adjust_cooling(Search& search, const CycleRun& run, Eigen::VectorXd& settled) {
  constexpr double finest = 1;  // K
  const CoolingSearch wanted{search.initial, search.request.wanted, std::max(finest, search.request.tolerance)};
  FoundCooling found = find_cooling(wanted, search.heat_cycles, run, settled, search.scene);
  search.result.failure = found.failure;
  search.cooling_is_open = found.changed;
  settled = std::move(found.settled);
  search.result.cooling = cooling_of(search.scene, search.request.wanted);
  return found.failure.empty();
}

/// Takes what a cycle says of the periodic state, and keeps what heat-only cycles settle to with its heat. False where
/// they do not settle.
bool learn(Search& search, const CycleRun& run) {
  auto settled = search.heat_cycles.learn(run)
                     ? search.heat_cycles.settled(run.end, heat_only_share * search.request.tolerance)
                     : std::nullopt;
  if (!settled) {
    search.result.failure = "the tools alone do not settle with the heat of this run";
    return false;
  }
  if (search.cooling_is_open && !adjust_cooling(search, run, *settled)) return false;
  search.estimates.add(run.start, run.end, *settled);
  return true;
}

/// The state that heat-only cycles with the heat of a forming run from `temperatures` settle to.
std::optional<Eigen::VectorXd> settle(Search& search, const Eigen::VectorXd& temperatures) {
  CycleRun run;
  const bool is_first = search.estimates.runs().empty();
  const char* first_folder = search.request.changed_from.empty() ? "first_gob" : "first_after_change";
  const Scene scene = is_first ? search.scene : with_tools_at(search.scene, search.initial, temperatures);
  if (!cycle_of(search, scene, is_first ? first_folder : "", run) || !learn(search, run)) return std::nullopt;
  const SettledEstimate& last = search.estimates.runs().back();
  search.progress(fmt::format("forming run {}: tool surfaces change by {} in the cycle, {} to go",
                              search.estimates.runs().size(), largest_text(search.scene, last.change),
                              largest_text(search.scene, last.distance)));
  if (search.cooling_is_open) search.progress("  " + cooling_text(search.result.cooling));
  if (is_first) search.result.first = std::move(run);
  return last.settled;
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// A folder that other cases can take the temperatures of the tools from, and a table of each tool.
void write_tools(const Search& search, const Eigen::VectorXd& temperatures, const std::string& folder) {
  Checkpoint checkpoint{{search.initial, {}}, {}};
  set_tool_temperatures(temperatures, checkpoint.outcome.state);
  const std::string directory = search.request.directory + '/' + folder;
  std::filesystem::create_directories(directory);
  write_checkpoint(directory, search.scene, checkpoint);
  const State& state = checkpoint.outcome.state;
  for (std::size_t t = 0; t < state.tools.size(); ++t)
    core::replace_file(fmt::format("{}/{}.csv", directory, search.scene.tools[t].name),
                       temperature_table_text(state.tools[t].mesh, state.tools[t].temperature));
}

/// The case with its tools as in the folder that write_tools has made.
Scene case_with_tools(const Search& search, const std::string& tools) {
  return with_tools_of(search.scene, search.request.directory + '/' + tools);
}

/// Two plain cycles from the temperatures in the folder `tools`, the first as a case of its own with result files.
void plain_cycles(Search& search) {
  auto& result = search.result;
  Eigen::VectorXd temperatures;
  result.confirmed.clear();
  for (int k = 0; k < 2; ++k) {
    CycleRun run;
    const Scene scene =
        k == 0 ? case_with_tools(search, "tools") : with_tools_at(search.scene, search.initial, temperatures);
    if (!cycle_of(search, scene, k == 0 ? "settled" : "", run) || !learn(search, run)) return;
    const SettledEstimate& last = search.estimates.runs().back();
    result.confirmed.push_back(largest(last.change));
    search.progress(fmt::format("plain cycle {}: tool surfaces change by {}, {} to go", k + 1,
                                largest_text(search.scene, last.change), largest_text(search.scene, last.distance)));
    temperatures = run.end;
    if (k == 0) result.settled = std::move(run);
  }
}

/// Forming runs until the cooling of tools with wanted temperatures is known; the tools to begin the search with.
Eigen::VectorXd approach_cooling(Search& search) {
  Eigen::VectorXd start = tool_temperatures(search.initial);
  while (search.cooling_is_open && static_cast<int>(search.estimates.runs().size()) < search.request.max_runs) {
    const auto next = settle(search, start);
    if (!next) break;
    start = *next;
  }
  if (search.cooling_is_open && search.result.failure.empty())
    search.result.failure = fmt::format(
        "--max-runs {}: as many forming runs as are allowed did not find the cooling for the wanted temperatures; a "
        "larger --max-runs goes on longer, into a new --output",
        search.request.max_runs);
  return start;
}

/// Forming runs towards the periodic state until it is known well enough or no more are allowed.
void approach(Search& search) {
  const double tolerance = search.request.tolerance;
  const int most = search.request.max_runs;
  auto& estimates = search.estimates;
  const auto runs = [&] { return static_cast<int>(estimates.runs().size()); };
  if (runs() == 0) {
    const Eigen::VectorXd start = approach_cooling(search);
    if (!search.result.failure.empty() || runs() >= most || (runs() > 0 && estimates.uncertainty() <= tolerance))
      return;
    const FixedPointOptions options{
        tolerance, anderson_depth, anderson_delay, most - runs(),
        [&](const Eigen::VectorXd&) { return estimates.only_scatter() ? 0 : estimates.uncertainty(); }};
    find_fixed_point(
        start, [&](const Eigen::VectorXd& x) { return settle(search, x); }, options);
  }
  while (search.result.failure.empty() && runs() < most && estimates.uncertainty() > tolerance)
    settle(search, estimates.mean());
}

/// What all runs so far say of the state in the folder `tools`.
void judge(Search& search, const Eigen::VectorXd& state) {
  auto& result = search.result;
  result.uncertainty = search.estimates.uncertainty();
  result.offset = surface_change(search.initial, search.estimates.mean() - state);
  result.runs = static_cast<int>(search.estimates.runs().size() - result.confirmed.size());
}

/// Further runs where the two plain cycles bear the state out and single runs scatter too much to know it well enough.
void measure_again(Search& search, const Eigen::VectorXd& state) {
  auto& result = search.result;
  const double tolerance = search.request.tolerance;
  const auto may_go_on = [&] {
    return static_cast<int>(search.estimates.runs().size()) < search.request.max_runs && result.failure.empty() &&
           largest(result.confirmed) <= tolerance && result.offset <= tolerance && result.uncertainty > tolerance;
  };
  if (may_go_on()) search.progress("single runs scatter by more than the tolerance: more of them are made");
  while (may_go_on())
    if (settle(search, search.estimates.mean())) judge(search, state);
}

/// What was reached when no more forming runs are allowed, and what to do.
std::string limit_text(const Search& search) {
  constexpr double near = 5;  // times the tolerance: what is worth to be taken as it is
  const double reached = search.estimates.uncertainty(), tolerance = search.request.tolerance;
  const auto runs = search.estimates.runs().size();
  std::string text = fmt::format(
      "--max-runs {}: the search ended after {} forming run{}, as many as are allowed; the tool surfaces are known to "
      "within {:.3g} K of those to which production settles, where {:g} K is asked for; the last run had {} to go. A "
      "larger --max-runs goes on longer",
      search.request.max_runs, runs, runs == 1 ? "" : "s", reached, tolerance,
      largest_text(search.scene, search.estimates.runs().back().distance));
  if (reached <= near * tolerance)
    text += fmt::format(", --tolerance \"{:g} K\" takes what was reached", rounded_up(reached));
  return text + "; each into a new --output";
}

/// Looks for the periodic state until plain cycles confirm it or no more forming runs are allowed.
Eigen::VectorXd search_for_state(Search& search) {
  auto& result = search.result;
  const double tolerance = search.request.tolerance;
  Eigen::VectorXd state;
  while (result.failure.empty()) {
    approach(search);
    if (!result.failure.empty()) break;
    if (!search.estimates.only_scatter() && search.estimates.uncertainty() > tolerance) {
      result.runs = static_cast<int>(search.estimates.runs().size());
      result.failure = limit_text(search);
      break;
    }
    state = search.estimates.mean();
    write_tools(search, state, "tools");
    plain_cycles(search);
    if (!result.failure.empty()) break;
    result.found = true;
    judge(search, state);
    measure_again(search, state);
    const auto runs = static_cast<int>(search.estimates.runs().size());
    if (result.is_confirmed(tolerance) || runs >= search.request.max_runs) break;
    search.progress("the plain cycles do not confirm the state: the search goes on");
    core::remove_own(search.request.directory + "/settled");
  }
  for (const SettledEstimate& run : search.estimates.runs()) result.search.push_back({run.change, run.distance});
  return state;
}

/// The surfaces of the tools at the start of a cycle.
StartUpCycle start_of_cycle(const Search& search, const Eigen::VectorXd& temperatures, const Eigen::VectorXd& settled) {
  State state = tools_of(search.initial);
  set_tool_temperatures(temperatures, state);
  StartUpCycle cycle{{}, surface_change(state, temperatures - settled)};
  for (const ToolState& tool : state.tools)
    cycle.mean.push_back(ToolSurface(tool.mesh, search.scene.geometry)
                             .temperatures(tool, std::numeric_limits<double>::infinity())
                             .surface_mean);
  return cycle;
}

/// Heat-only cycles from the start of the case until they are as close to the settled state as was asked for.
void start_up(Search& search, const Eigen::VectorXd& settled) {
  constexpr int most = 1000;
  if (!search.heat_cycles.hold(settled)) return;
  auto& cycles = search.result.start_up;
  std::optional<Eigen::VectorXd> now = search.result.first.start;
  while (now && static_cast<int>(cycles.size()) < most) {
    cycles.push_back(start_of_cycle(search, *now, settled));
    if (cycles.back().distance <= search.request.tolerance) return;
    now = search.heat_cycles.next(*now);
  }
}

/// What swabs do from one to the next, by heat-only cycles, and the container made just after one.
void follow_swabs(Search& search, const Eigen::VectorXd& settled) {
  auto& result = search.result;
  const auto cycles = since_swab(
      search.swab, settled, [&](const Eigen::VectorXd& x) { return search.heat_cycles.next(x); },
      search.request.tolerance);
  if (cycles.empty()) {
    result.failure = "the tools alone cannot be followed after a swab";
    return;
  }
  for (const Eigen::VectorXd& temperatures : cycles)
    result.since_swab.push_back(start_of_cycle(search, temperatures, settled));
  write_tools(search, cycles.front(), "tools_just_swabbed");
  CycleRun run;
  if (!cycle_of(search, case_with_tools(search, "tools_just_swabbed"), "just_swabbed", run)) return;
  result.just_swabbed = std::move(run);
  search.progress(fmt::format("just after a swab: tool surfaces differ by {} from the mean",
                              largest_text(search.scene, surface_changes(search.initial, cycles.front() - settled))));
}

}  // namespace

bool PeriodicState::is_confirmed(double tolerance) const {
  return confirmed.size() == 2 && largest(confirmed) <= tolerance && offset <= tolerance && uncertainty <= tolerance;
}

PeriodicState find_periodic_state(const Scene& given, const MachineCycle& cycle, const PeriodicRequest& request,
                                  const StopRequest& stop, const Progress& progress) {
  Scene scene = scene_in_cycle(given, cycle);
  if (!request.changed_from.empty()) scene = with_tools_of(scene, request.changed_from);
  const State initial = initial_state(scene);
  PeriodicState result;
  result.cycle = cycle;
  Search search{scene,
                request,
                stop,
                progress,
                initial,
                HeatCycles(scene, cycle, initial),
                swab_imprint(scene, initial),
                SettledEstimates(initial, request.tolerance),
                result,
                !request.wanted.empty()};
  result.failure = search.swab.failure;
  if (!result.failure.empty()) return result;
  result.swab_heat = search.swab.heat;
  const Eigen::VectorXd settled = search_for_state(search);
  if (!result.failure.empty()) return result;
  start_up(search, settled);
  if (search.swab.exists()) follow_swabs(search, settled);
  return result;
}

}  // namespace parison::forming
