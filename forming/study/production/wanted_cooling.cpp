// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/wanted_cooling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/case/case_error.hpp"
#include "core/case/units.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/state/tool_surface.hpp"
#include "forming/step/heat/surroundings.hpp"
#include "forming/study/production/machine_cycle.hpp"
#include "forming/study/production/tool_fields.hpp"

namespace parison::forming {
namespace {

/// The largest h of a tool stays between that of still air behind insulation and that of boiling water, W/m2/K.
constexpr double insulated = 1, hardest = 1e5;

/// Heat-only cycles settle to this share of what a wanted temperature is met to, the secant to a tenth of it. A tool
/// that takes hundreds of cycles is hundreds of times as far from where it settles as it changes in one.
constexpr double settles_to = 2e-4, secant_to = 0.1;

std::size_t index_of(const Scene& scene, const std::string& name) {
  const auto found =
      std::find_if(scene.tools.begin(), scene.tools.end(), [&](const Tool& tool) { return tool.name == name; });
  return static_cast<std::size_t>(found - scene.tools.begin());
}

/// One constant h that is above zero at each of its cooled boundaries, in all stages.
void require_cooling(const Scene& scene, const Tool& tool) {
  const auto refuse = [&](const std::string& found) {
    throw core::CaseError(
        fmt::format("--want {}: {} was found, allowed is a tool with a `cooled` boundary whose h is one value above "
                    "zero: that value is looked for",
                    tool.name, found));
  };
  bool any = false;
  for (const Boundary& boundary : tool.boundaries) {
    if (boundary.kind != BoundaryKind::cooled) continue;
    any = true;
    if (!boundary.cooling.h.is_constant()) refuse(fmt::format("\"{}\" with an h over time", boundary.name));
    if (boundary.cooling.h.max() <= 0) refuse(fmt::format("\"{}\" with an h of zero", boundary.name));
  }
  if (!any) refuse("a tool without a cooled boundary");
  for (const Stage& stage : scene.stages)
    for (const StageCooling& one : stage.cooling)
      if (&scene.tools[one.tool] == &tool && tool.boundaries[one.boundary].kind == BoundaryKind::cooled)
        refuse(fmt::format("cooling of its own in the stage \"{}\"", stage.name));
}

/// The mean temperature of what cools a tool, K.
double coolant(const Tool& tool) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Boundary& boundary : tool.boundaries)
    if (boundary.kind == BoundaryKind::cooled) lowest = std::min(lowest, boundary.cooling.air_temperature.min());
  return lowest;
}

void require_between(const Scene& scene, const Tool& tool, double wanted) {
  const double coldest = coolant(tool), hottest = scene.glass.initial_temperature;
  if (wanted <= coldest || wanted >= hottest)
    throw core::CaseError(fmt::format(
        "--want {}: {:.4g} degC was found, which no cooling gives: allowed are temperatures between that of what cools "
        "it, {:.4g} degC, and that of the glass, {:.4g} degC",
        tool.name, wanted - core::zero_celsius, coldest - core::zero_celsius, hottest - core::zero_celsius));
}

/// The least that a place of the contact surface of a tool loses in any stage without glass, W/m2.
double least_lost(const Scene& scene, State& state, std::size_t tool, double temperature) {
  double least = std::numeric_limits<double>::infinity();
  const core::Mesh& mesh = state.tools[tool].mesh;
  for (state.stage = 0; state.stage < static_cast<Index>(scene.stages.size()); ++state.stage) {
    const auto exchanges = surroundings(scene, state, body_of_tool(static_cast<Index>(tool)), mesh);
    for (std::size_t b = 0; b < exchanges.size(); ++b) {
      if (mesh.boundaries()[b].kind != BoundaryKind::contact) continue;
      double lost = 0;
      if (exchanges[b])
        lost = exchanges[b]->h.min() * (temperature - exchanges[b]->air_temperature.max()) +
               exchanges[b]->emissivity * thermal::stefan_boltzmann *
                   (std::pow(temperature, 4) - std::pow(exchanges[b]->ambient_temperature.max(), 4));
      least = std::min(least, lost);
    }
  }
  return least;
}

/// In a long cycle the surface of a tool loses more to the air than all of the glass could give it. While the glass
/// is there the surface may be as hot as that and lose nothing.
void require_heat(const Scene& scene, const MachineCycle& cycle, const WantedTool& wanted) {
  const std::size_t tool = index_of(scene, wanted.name);
  State state = initial_state(scene);
  const double glass = state.glass.temperature.maxCoeff(), seconds = cycle.seconds_of(tool),
               used = cycle.uses[tool].end - cycle.uses[tool].begin, free = seconds - used;
  if (free <= 0) return;
  const double temperature = std::max(0.0, (wanted.temperature * seconds - glass * used) / free);
  const double area =
      ToolSurface(state.tools[tool].mesh, scene.geometry).temperatures(state.tools[tool], 0).surface_area_above;
  const double lost = area * free * least_lost(scene, state, tool, temperature);
  const thermal::Enthalpy enthalpy(scene.glass.thermal->heat_capacity);
  const double given = state.glass.mass * (enthalpy(glass).h - enthalpy(coolant(scene.tools[tool])).h);
  if (lost <= given) return;
  throw core::CaseError(fmt::format(
      "--want {}: {:.4g} degC was found, which no cooling gives: in the {:.4g} s of its cycle without glass, at {:.0f} "
      "degC or more, its surface loses {:.3g} kJ to the air and the glass of a container has {:.3g} kJ; allowed are a "
      "lower temperature or a shorter cycle",
      wanted.name, wanted.temperature - core::zero_celsius, free, temperature - core::zero_celsius, lost * 1e-3,
      given * 1e-3));
}

double largest_h(const Tool& tool) {
  double largest = 0;
  for (const Boundary& boundary : tool.boundaries)
    if (boundary.kind == BoundaryKind::cooled) largest = std::max(largest, boundary.cooling.h.max());
  return largest;
}

/// The largest h of a tool becomes this, the others keep their share of it.
void set_largest_h(Scene& scene, std::size_t tool, double h) {
  const double factor = h / largest_h(scene.tools[tool]);
  for (const Boundary& boundary : scene.tools[tool].boundaries)
    if (boundary.kind == BoundaryKind::cooled)
      set_cooling(scene, {scene.tools[tool].name, boundary.name, factor * boundary.cooling.h.max()});
}

double to_four_figures(double value) {
  const double digit = std::pow(10, std::floor(std::log10(value)) - 3);
  return digit * std::round(value / digit);
}

/// What one tool settles to, by the reciprocal of its largest h.
struct Goal {
  std::size_t tool;
  double wanted;           ///< K
  double above_gob, met;   ///< of the run: mean of the surface over that at the gob; glass over that, K
  double resistance;       ///< 1/h now, m2K/W
  double temperature = 0;  ///< with it, K
  double slope = 0;        ///< of it by 1/h, from the last two that differ enough; 0 at first
  double before_resistance = 0, before = 0;

  double off() const { return temperature - wanted; }
  bool is_at_end() const {
    return (off() < 0 && resistance * insulated >= 1) || (off() > 0 && resistance * hardest <= 1);
  }
  /// The next 1/h; the first guess takes all of the resistance for that of the cooling.
  double next(double cold) const {
    const double step =
        slope > 0 ? -off() / slope : resistance * ((wanted - cold) / std::max(temperature - cold, 1.0) - 1);
    constexpr double most = 10;  // times as much or as little in one step
    const double limited = std::clamp(resistance + step, resistance / most, resistance * most);
    return std::clamp(limited, 1 / hardest, 1 / insulated);
  }
};

double surface_mean(const CoolingSearch& search, const Scene& scene, const Eigen::VectorXd& temperatures,
                    std::size_t tool) {
  State state = tools_of(search.initial);
  set_tool_temperatures(temperatures, state);
  return ToolSurface(state.tools[tool].mesh, scene.geometry)
      .temperatures(state.tools[tool], std::numeric_limits<double>::infinity())
      .surface_mean;
}

void measure(const CoolingSearch& search, const Scene& scene, const Eigen::VectorXd& settled, Goal& goal) {
  constexpr double enough = 0.01;  // of 1/h: a smaller change moves the tool by less than it is settled to
  const double at_gob = surface_mean(search, scene, settled, goal.tool);
  goal.temperature = at_gob + goal.above_gob * (goal.met - at_gob);
  const double change = goal.resistance - goal.before_resistance;
  if (goal.before_resistance > 0 && std::abs(change) >= enough * goal.resistance)
    goal.slope = (goal.temperature - goal.before) / change;
}

std::vector<Goal> goals_of(const CoolingSearch& search, const Scene& scene, const CycleRun& run) {
  std::vector<Goal> goals;
  for (const WantedTool& wanted : search.wanted) {
    const std::size_t tool = index_of(scene, wanted.name);
    const double at_gob = surface_mean(search, scene, run.start, tool);
    const double above = (range_of(run.samples, tool).mean - at_gob) / std::max(run.met[tool] - at_gob, 1.0);
    goals.push_back({tool, wanted.temperature, above, run.met[tool], 1 / largest_h(scene.tools[tool])});
  }
  return goals;
}

std::string out_of_reach(const Scene& scene, const Goal& goal) {
  const bool too_hot = goal.off() < 0;
  return fmt::format("--want {}: {:.4g} degC cannot be reached by any cooling: {} it settles at {:.0f} degC",
                     scene.tools[goal.tool].name, goal.wanted - core::zero_celsius,
                     too_hot ? fmt::format("as good as insulated, with h = {:g} W/m2/K,", insulated)
                             : fmt::format("even with h = {:g} W/m2/K", hardest),
                     goal.temperature - core::zero_celsius);
}

/// Takes the next h of each tool that is further off than this, if any.
bool change_cooling(std::vector<Goal>& goals, double tolerance, Scene& scene) {
  bool changed = false;
  for (Goal& goal : goals) {
    if (std::abs(goal.off()) <= tolerance || goal.is_at_end()) continue;
    const double next = goal.next(coolant(scene.tools[goal.tool]));
    goal.before_resistance = goal.resistance;
    goal.before = goal.temperature;
    goal.resistance = 1 / to_four_figures(1 / next);
    if (goal.resistance == goal.before_resistance) continue;
    set_largest_h(scene, goal.tool, 1 / goal.resistance);
    changed = true;
  }
  return changed;
}

}  // namespace

std::string Cooling::key() const {
  return fmt::format("tool.{}.boundary.{}.condition.cooled.h", tool, boundary);
}

void check_wanted(const Scene& scene, const MachineCycle& cycle, const std::vector<WantedTool>& wanted) {
  std::set<std::string> names;
  for (const WantedTool& one : wanted) {
    require_tool(scene, "--want", one.name);
    if (!names.insert(one.name).second)
      throw core::CaseError(
          fmt::format("--want {}: it was found twice, allowed is one temperature of a tool", one.name));
    const std::size_t tool = index_of(scene, one.name);
    if (cycle.uses[tool].end == 0)
      throw core::CaseError(fmt::format("--want {}: no stage uses it, allowed are tools that glass warms", one.name));
    require_cooling(scene, scene.tools[tool]);
    require_between(scene, scene.tools[tool], one.temperature);
    require_heat(scene, cycle, one);
  }
}

std::vector<Cooling> cooling_of(const Scene& scene, const std::vector<WantedTool>& wanted) {
  std::vector<Cooling> all;
  for (const WantedTool& one : wanted)
    for (const Boundary& boundary : scene.tools[index_of(scene, one.name)].boundaries)
      if (boundary.kind == BoundaryKind::cooled) all.push_back({one.name, boundary.name, boundary.cooling.h.max()});
  return all;
}

void set_cooling(Scene& scene, const Cooling& cooling) {
  const std::string key = cooling.key() + '=';
  auto& overrides = scene.overrides;
  overrides.erase(std::remove_if(overrides.begin(), overrides.end(),
                                 [&](const std::string& assignment) { return assignment.rfind(key, 0) == 0; }),
                  overrides.end());
  overrides.push_back(fmt::format("{}{:.10g} W/m2/K", key, cooling.h));
  for (Boundary& boundary : scene.tools[index_of(scene, cooling.tool)].boundaries)
    if (boundary.name == cooling.boundary) boundary.cooling.h = cooling.h;
}

FoundCooling find_cooling(const CoolingSearch& search, const HeatCycles& cycles, const CycleRun& run,
                          const Eigen::VectorXd& settled, Scene& scene) {
  constexpr int most = 30;
  FoundCooling found{false, {}, settled};
  std::vector<Goal> goals = goals_of(search, scene, run);
  const auto all_met = [&](double tolerance) {
    return std::all_of(goals.begin(), goals.end(), [&](const Goal& goal) { return std::abs(goal.off()) <= tolerance; });
  };
  for (Goal& goal : goals) measure(search, scene, settled, goal);
  if (all_met(search.tolerance)) return found;
  for (int k = 0; k < most && change_cooling(goals, secant_to * search.tolerance, scene); ++k) {
    auto next = cycles.settled(found.settled, settles_to * search.tolerance);
    if (!next) {
      found.failure = "the tools alone do not settle with the cooling that is tried for their wanted temperatures";
      return found;
    }
    found.settled = std::move(*next);
    for (Goal& goal : goals) measure(search, scene, found.settled, goal);
  }
  found.changed = true;
  for (const Goal& goal : goals)
    if (goal.is_at_end() && std::abs(goal.off()) > search.tolerance) found.failure = out_of_reach(scene, goal);
  return found;
}

}  // namespace parison::forming
