// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/machine_cycle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/case/case_error.hpp"
#include "core/case/case_file.hpp"
#include "core/case/units.hpp"
#include "core/math/numbers.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/heat/surroundings.hpp"
#include "forming/step/idle/swabbed_tool.hpp"
#include "forming/study/production/tool_fields.hpp"

namespace parison::forming {

namespace {

/// Cycles from one swab to the next; 0 for a tool without.
int period(const SwabImprint& imprint, Eigen::Index node) {
  return imprint.share[node] > 0 ? static_cast<int>(std::lround(1 / imprint.share[node])) : 0;
}

int longest_period(const SwabImprint& imprint) {
  int longest = 0;
  for (Eigen::Index node = 0; node < imprint.share.size(); ++node) longest = std::max(longest, period(imprint, node));
  return longest;
}

}  // namespace

SwabImprint swab_imprint(const Scene& scene, const State& initial) {
  const Eigen::Index nodes = tool_temperatures(initial).size();
  SwabImprint imprint{Eigen::VectorXd::Zero(nodes), Eigen::VectorXd::Zero(nodes),
                      std::vector<double>(scene.tools.size(), 0), ""};
  Eigen::Index first = 0;
  for (std::size_t t = 0; t < scene.tools.size(); ++t) {
    const Eigen::Index size = initial.tools[t].temperature.size();
    if (scene.tools[t].swab && size > 0) {
      const SwabbedTool swabbed = swabbed_tool(scene, initial, static_cast<Index>(t));
      if (!swabbed.failure.empty()) imprint.failure = "the swab of " + scene.tools[t].name + ": " + swabbed.failure;
      imprint.heat[t] = swabbed.heat;
      imprint.change.segment(first, size) = swabbed.temperature.array() - scene.tools[t].initial_temperature;
      imprint.share.segment(first, size).setConstant(1.0 / scene.tools[t].swab->every);
    }
    first += size;
  }
  return imprint;
}

std::vector<Eigen::VectorXd> since_swab(const SwabImprint& imprint, const Eigen::VectorXd& settled,
                                        const CycleMap& next, double tolerance) {
  constexpr int most = 2000;
  const auto fixed = next(settled);
  if (!fixed) return {};
  // One swab alone, k cycles after it; its trace in the mean of production is what all that came before have left.
  std::vector<Eigen::VectorXd> traces{imprint.change};
  while (traces.back().lpNorm<Eigen::Infinity>() > 0.02 * tolerance && static_cast<int>(traces.size()) < most) {
    const auto later = next(settled + traces.back());
    if (!later) return {};
    traces.push_back(*later - *fixed);
  }
  const auto count = static_cast<int>(traces.size());
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(settled.size());
  for (const Eigen::VectorXd& trace : traces) mean += trace.cwiseProduct(imprint.share);
  std::vector<Eigen::VectorXd> found;
  for (int k = 0; k < longest_period(imprint); ++k) {
    Eigen::VectorXd temperatures = settled - mean;
    for (Eigen::Index node = 0; node < settled.size(); ++node)
      if (const int every = period(imprint, node); every > 0)
        for (int m = k % every; m < count; m += every) temperatures[node] += traces[m][node];
    found.push_back(std::move(temperatures));
  }
  return found;
}

namespace {

bool uses(const Stage& stage, std::size_t tool) {
  return std::any_of(stage.tools.begin(), stage.tools.end(),
                     [&](const StageTool& one) { return static_cast<std::size_t>(one.tool) == tool; });
}

ToolUse use_of(const Scene& scene, std::size_t tool) {
  ToolUse use{0, 0};
  double time = 0;
  bool begun = false;
  for (const Stage& stage : scene.stages) {
    if (uses(stage, tool)) {
      if (!begun) use.begin = time;
      begun = true;
      use.end = time + stage.duration;
    }
    time += stage.duration;
  }
  return use;
}

/// From the gob to the end of the last stage.
double forming_time(const Scene& scene) {
  double time = 0;
  for (const Stage& stage : scene.stages) time += stage.duration;
  return time;
}

double time_of(const Scene& scene, const std::optional<double>& seconds) {
  if (seconds) return *seconds;
  if (scene.timing) return scene.timing->cycle;
  throw core::CaseError(
      fmt::format("{}: nothing says how long a machine cycle takes, allowed is a table [timing] or --cycle-time \"12 "
                  "s\"",
                  scene.file));
}

/// Whether the tool gives heat to anything but glass in any stage, through the boundaries that count.
bool is_cooled(const Scene& scene, State& state, Index tool, bool contact_counts) {
  const core::Mesh& mesh = state.tools[tool].mesh;
  const auto& boundaries = mesh.boundaries();
  for (const auto& boundary : boundaries)
    if (boundary.kind == BoundaryKind::temperature) return true;
  for (state.stage = 0; state.stage < static_cast<Index>(scene.stages.size()); ++state.stage) {
    const auto exchanges = surroundings(scene, state, body_of_tool(tool), mesh);
    for (std::size_t b = 0; b < exchanges.size(); ++b)
      if ((contact_counts || boundaries[b].kind != BoundaryKind::contact) && exchanges[b] &&
          (exchanges[b]->h.max() > 0 || exchanges[b]->emissivity > 0))
        return true;
  }
  return false;
}

/// The lowest temperature that what cools a tool has in any stage, K: of its boundaries that no glass touches, or of
/// all where those give nothing off. Infinity where nothing cools it.
double coldest_cooling(const Scene& scene, State& state, Index tool) {
  double coldest = std::numeric_limits<double>::infinity(), at_contact = coldest;
  const core::Mesh& mesh = state.tools[tool].mesh;
  const auto& boundaries = scene.tools[tool].boundaries;
  for (const Boundary& boundary : boundaries)
    if (boundary.kind == BoundaryKind::temperature) coldest = std::min(coldest, boundary.temperature.min());
  for (state.stage = 0; state.stage < static_cast<Index>(scene.stages.size()); ++state.stage) {
    const auto exchanges = surroundings(scene, state, body_of_tool(tool), mesh);
    for (std::size_t b = 0; b < boundaries.size(); ++b) {
      double& lowest = boundaries[b].kind == BoundaryKind::contact ? at_contact : coldest;
      if (exchanges[b] && exchanges[b]->h.max() > 0) lowest = std::min(lowest, exchanges[b]->air_temperature.min());
      if (exchanges[b] && exchanges[b]->emissivity > 0)
        lowest = std::min(lowest, exchanges[b]->ambient_temperature.min());
    }
  }
  return std::isfinite(coldest) ? coldest : at_contact;
}

/// No machine makes containers so slowly, or has so many on their way at once.
void refuse_impossible(const Scene& scene, const MachineCycle& cycle) {
  constexpr double most_at_once = 100, hour = 3600, most_waiting = 10;
  const double forming = forming_time(scene), least = forming / most_at_once,
               longest = std::max(hour, most_waiting * forming);
  if (cycle.seconds >= least && cycle.seconds <= longest) return;
  throw core::CaseError(fmt::format(
      "{}: a machine cycle of {:.4g} s was found, where a container takes {:.4g} s from its gob to the end of its last "
      "stage; allowed are {:.4g} s to {:.4g} s from one container to the next",
      cycle.key, cycle.seconds, forming, least, longest));
}

void refuse_short(const Scene& scene, const MachineCycle& cycle) {
  for (std::size_t t = 0; t < scene.tools.size(); ++t) {
    const auto& [begin, end] = cycle.uses[t];
    if (end - begin > cycle.seconds_of(t) * (1 + core::round_off))
      throw core::CaseError(
          fmt::format("{}: a machine cycle of {:.4g} s was found, but each container uses the tool \"{}\" for {:.4g} "
                      "s; allowed is a longer cycle, or sets of the tool that take turns: --sets {}={:.0f}",
                      scene.file, cycle.seconds, scene.tools[t].name, end - begin, scene.tools[t].name,
                      std::ceil((end - begin) / cycle.seconds * (1 - core::round_off))));
  }
}

/// What is as hot as the glass takes no heat from a tool that glass heats.
void refuse_hot_cooling(const Scene& scene, const MachineCycle& cycle) {
  State state = initial_state(scene);
  const double glass = state.glass.temperature.maxCoeff();
  for (std::size_t t = 0; t < scene.tools.size(); ++t) {
    if (cycle.uses[t].end == 0) continue;
    const double coldest = coldest_cooling(scene, state, static_cast<Index>(t));
    if (coldest >= glass)
      throw core::CaseError(
          fmt::format("{}: what cools the tool \"{}\" has {:.4g} degC and more, but the glass starts at {:.4g} degC: "
                      "allowed are tools that something colder than the glass cools",
                      scene.file, scene.tools[t].name, coldest - core::zero_celsius, glass - core::zero_celsius));
  }
}

void refuse_uncooled(const Scene& scene, const MachineCycle& cycle) {
  State state = initial_state(scene);
  for (std::size_t t = 0; t < scene.tools.size(); ++t)
    if (cycle.uses[t].end > 0 && !is_cooled(scene, state, static_cast<Index>(t), true))
      throw core::CaseError(
          fmt::format("{}: the tool \"{}\" has no cooling and loses no heat to air, so that its temperature rises from "
                      "cycle to cycle; allowed are tools with a cooled boundary, a given temperature or air around",
                      scene.file, scene.tools[t].name));
}

}  // namespace

void require_tool(const Scene& scene, const std::string& option, const std::string& name) {
  std::vector<std::string> names;
  for (const Tool& tool : scene.tools) names.push_back(tool.name);
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw core::CaseError(fmt::format("{}: \"{}\" was found{}, allowed are the tools {}", option, name,
                                      core::did_you_mean(name, names), fmt::join(names, ", ")));
}

MachineCycle machine_cycle(const Scene& scene, const std::optional<double>& seconds,
                           const std::map<std::string, int>& sets) {
  if (!scene.has_heat() || scene.tools.empty())
    throw core::CaseError(
        fmt::format("{}: a cycle of production was asked for, allowed only for a case whose glass and tools carry heat",
                    scene.file));
  for (const auto& one : sets) require_tool(scene, "--sets", one.first);
  MachineCycle cycle{time_of(scene, seconds), {}, {}, seconds ? "--cycle-time" : scene.file + ": timing.cuts"};
  for (std::size_t t = 0; t < scene.tools.size(); ++t) {
    cycle.uses.push_back(use_of(scene, t));
    const auto known = sets.find(scene.tools[t].name);
    cycle.sets.push_back(known == sets.end() ? 1 : known->second);
  }
  refuse_impossible(scene, cycle);
  refuse_short(scene, cycle);
  refuse_uncooled(scene, cycle);
  refuse_hot_cooling(scene, cycle);
  return cycle;
}

std::vector<std::string> notes_on_cycle(const Scene& scene, const MachineCycle& cycle) {
  constexpr double usual_at_once = 10, longest_usual = 120, usual_waiting = 3;
  State state = initial_state(scene);
  std::vector<std::string> notes;
  const double forming = forming_time(scene);
  if (cycle.seconds < forming / usual_at_once || cycle.seconds > std::max(longest_usual, usual_waiting * forming))
    notes.push_back(
        fmt::format("unusual, is it meant? {}: a machine cycle of {:.4g} s, where a container takes {:.4g} s from its "
                    "gob to the end of its last stage",
                    cycle.key, cycle.seconds, forming));
  for (std::size_t t = 0; t < scene.tools.size(); ++t)
    if (cycle.uses[t].end > 0 && !is_cooled(scene, state, static_cast<Index>(t), false))
      notes.push_back(
          fmt::format("the tool \"{}\" is cooled by nothing but air at its contact surface, and may settle "
                      "far hotter than glass allows; is a boundary `cooled` on the machine?",
                      scene.tools[t].name));
  const double glass = state.glass.temperature.maxCoeff();
  for (const Tool& tool : scene.tools)
    for (const Boundary& boundary : tool.boundaries)
      if (boundary.kind == BoundaryKind::cooled && boundary.cooling.air_temperature.min() >= glass)
        notes.push_back(fmt::format(
            "unusual, is it meant? the boundary \"{}\" of the tool \"{}\" is `cooled` by what is hotter than the glass",
            boundary.name, tool.name));
  return notes;
}

Scene scene_in_cycle(const Scene& scene, const MachineCycle& cycle) {
  std::vector<std::string> overrides = scene.overrides;
  for (std::size_t t = 0; t < scene.tools.size(); ++t)
    if (cycle.overlaps(t) && !scene.tools[t].waits)
      overrides.push_back(fmt::format("tool.{}.temperature_at=first use", scene.tools[t].name));
  return overrides.size() == scene.overrides.size() ? scene : read_scene(scene.file, scene.accuracy_name, overrides);
}

}  // namespace parison::forming
