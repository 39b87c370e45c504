// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/periodic_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>

#include "forming/report/summary.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/study/production/fixed_point.hpp"
#include "forming/study/production/heat_cycles.hpp"
#include "forming/study/production/swabbing.hpp"
#include "forming/study/production/tool_fields.hpp"

namespace parison::forming {
namespace {

constexpr int anderson_depth = 2;

/// Heat-only cycles settle to this share of the tolerance.
constexpr double heat_only_share = 0.02;

/// The search and what it has so far.
struct Search {
  const Scene& scene;
  const PeriodicRequest& request;
  const StopRequest& stop;
  const Progress& progress;
  State initial;  ///< meshes and probes
  HeatCycles heat_cycles;
  SwabImprint swab;
  PeriodicState& result;
  Eigen::VectorXd settled_last = {}, settled_before = {};  ///< by heat-only cycles, with the heat of the last runs
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

std::string largest_text(const Scene& scene, const std::vector<double>& values) {
  const auto largest = std::max_element(values.begin(), values.end());
  return fmt::format("{:.3g} K ({})", *largest, scene.tools[static_cast<std::size_t>(largest - values.begin())].name);
}

/// The state that heat-only cycles with the heat of a forming run from `temperatures` settle to.
std::optional<Eigen::VectorXd> settle(Search& search, const Eigen::VectorXd& temperatures) {
  auto& result = search.result;
  CycleRun run;
  const bool is_first = result.search.empty();
  const Scene scene = is_first ? search.scene : with_tools_at(search.scene, search.initial, temperatures);
  if (!cycle_of(search, scene, is_first ? "first_gob" : "", run)) return std::nullopt;
  auto next = search.heat_cycles.learn(run)
                  ? search.heat_cycles.settled(run.end, heat_only_share * search.request.tolerance)
                  : std::nullopt;
  if (!next) {
    result.failure = "the tools alone do not settle with the heat of this run";
    return next;
  }
  result.search.push_back(
      {surface_changes(search.initial, run.end - run.start), surface_changes(search.initial, *next - run.start)});
  search.progress(fmt::format("forming run {}: tool surfaces change by {} in the cycle, {} to go", result.search.size(),
                              largest_text(search.scene, result.search.back().change),
                              largest_text(search.scene, result.search.back().distance)));
  if (is_first) result.first = std::move(run);
  search.settled_before = std::exchange(search.settled_last, *next);
  return next;
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// Whether the distance is no longer what is left to go but what forming runs scatter by: it falls no more, although
/// the last two cycles have changed no surface by more than the tolerance.
bool only_scatters(const std::vector<SearchRun>& search, double tolerance) {
  if (search.size() < 3) return false;
  const SearchRun &before = search[search.size() - 2], &last = search.back();
  return largest(last.distance) > 0.5 * largest(before.distance) && largest(last.change) <= tolerance &&
         largest(before.change) <= tolerance;
}

/// How far the last state that heat-only cycles settled to may be from the periodic one, K: its distances to those
/// before fall as a geometric series, as far as the scatter of the forming runs lets them. No less than the cycle
/// itself changed a surface.
double unsettled(const std::vector<SearchRun>& search, double tolerance) {
  const double change = largest(search.back().change), distance = largest(search.back().distance);
  if (search.size() == 1) return std::max(change, distance);
  if (only_scatters(search, tolerance)) return change;
  const double ratio = distance / largest(search[search.size() - 2].distance);
  return std::max(change, ratio < 0.5 ? distance * ratio / (1 - ratio) : distance);
}

/// A folder that other cases can take the temperatures of the tools from.
void write_tools(const Search& search, const Eigen::VectorXd& temperatures, const std::string& folder) {
  Checkpoint checkpoint{{search.initial, {}}, {}};
  set_tool_temperatures(temperatures, checkpoint.outcome.state);
  const std::string directory = search.request.directory + '/' + folder;
  std::filesystem::create_directories(directory);
  write_checkpoint(directory, search.scene, checkpoint);
}

/// The case with its tools as in the folder that write_tools has made.
Scene case_with_tools(const Search& search, const std::string& tools) {
  const std::string folder = std::filesystem::absolute(search.request.directory + '/' + tools).string();
  std::vector<std::string> overrides = search.scene.overrides;
  for (const Tool& tool : search.scene.tools)
    overrides.push_back(fmt::format("tool.{}.temperature={{ from = \"{}\" }}", tool.name, folder));
  Scene scene = read_scene(search.scene.file, search.scene.accuracy_name, overrides);
  // Sizes of first meshes depend on this mean; the tools keep their meshes throughout the search.
  for (std::size_t t = 0; t < scene.tools.size(); ++t)
    scene.tools[t].initial_temperature = search.scene.tools[t].initial_temperature;
  return scene;
}

/// Two plain cycles, the first as a case of its own with result files.
void confirm(Search& search, const Eigen::VectorXd& settled) {
  auto& result = search.result;
  Eigen::VectorXd temperatures = settled;
  for (int k = 0; k < 2; ++k) {
    CycleRun run;
    const Scene scene =
        k == 0 ? case_with_tools(search, "tools") : with_tools_at(search.scene, search.initial, temperatures);
    if (!cycle_of(search, scene, k == 0 ? "settled" : "", run)) return;
    result.confirmed.push_back(surface_change(search.initial, run.end - run.start));
    search.progress(fmt::format("plain cycle {}: tool surfaces change by {}", k + 1,
                                largest_text(search.scene, surface_changes(search.initial, run.end - run.start))));
    temperatures = run.end;
    if (k == 0) result.settled = std::move(run);
  }
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
  return confirmed.size() == 2 && largest(confirmed) <= tolerance;
}

PeriodicState find_periodic_state(const Scene& given, const MachineCycle& cycle, const PeriodicRequest& request,
                                  const StopRequest& stop, const Progress& progress) {
  const Scene scene = scene_in_cycle(given, cycle);
  const State initial = initial_state(scene);
  PeriodicState result;
  result.cycle = cycle;
  Search search{
      scene, request, stop, progress, initial, HeatCycles(scene, cycle, initial), swab_imprint(scene, initial), result};
  result.failure = search.swab.failure;
  if (!result.failure.empty()) return result;
  result.swab_heat = search.swab.heat;
  const FixedPointOptions options{request.tolerance, anderson_depth, request.max_runs,
                                  [&](const Eigen::VectorXd&) { return unsettled(result.search, request.tolerance); }};
  const auto found = find_fixed_point(
      tool_temperatures(initial), [&](const Eigen::VectorXd& x) { return settle(search, x); }, options);
  if (!result.failure.empty()) return result;
  result.found = found.converged;
  if (!found.converged) {
    result.failure = fmt::format("after {} forming runs the tool surfaces are settled to {:.3g} K only",
                                 found.evaluations, found.change);
    return result;
  }
  Eigen::VectorXd settled = found.value;
  if (only_scatters(result.search, request.tolerance) && largest(result.search.back().distance) > request.tolerance) {
    result.scatter = largest(result.search.back().distance);
    settled = 0.5 * (found.value + search.settled_before);
  }
  write_tools(search, settled, "tools");
  start_up(search, settled);
  confirm(search, settled);
  if (result.failure.empty() && search.swab.exists()) follow_swabs(search, settled);
  return result;
}

}  // namespace parison::forming
