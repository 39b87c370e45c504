// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

constexpr double turn = 360;            // deg
constexpr double same_angle = 1e-6;     // deg
constexpr const char* cycle = "cycle";  // the name of its time in formulas

/// deg.
double read_angle(const CaseNode& node) {
  const double angle = core::quantity(node, dimension::none) * 180 / M_PI;
  if (angle < -same_angle || angle > turn + same_angle)
    core::refuse(node,
                 fmt::format("{:g} deg was found, allowed are angles from 0 to 360 deg such as \"40 deg\"", angle));
  return angle;
}

void refuse_taken_name(const CaseNode& event, const std::vector<core::NamedDimension>& dimensions) {
  core::check_formula_name(event);
  const auto taken = [&](const core::NamedDimension& one) { return one.name == event.name; };
  if (event.name == cycle || std::any_of(dimensions.begin(), dimensions.end(), taken))
    core::refuse(
        event, fmt::format("\"{}\" is a name that formulas of the case have already, allowed is another", event.name));
}

/// The events and the cycle as times.
std::vector<core::NamedDimension> named_times(const Timing& timing) {
  std::vector<core::NamedDimension> named{{cycle, "", {timing.cycle, dimension::time}}};
  for (const Timing::Event& event : timing.events)
    named.push_back({event.name, "", {event.angle / turn * timing.cycle, dimension::time}});
  return named;
}

const Timing::Event& read_event(const CaseNode& node, const Scene& scene) {
  if (!scene.timing) core::refuse(node, "an event was found, allowed only in a case with a table [timing]");
  std::vector<std::string> names;
  for (const Timing::Event& event : scene.timing->events) names.push_back(event.name);
  return scene.timing->events[static_cast<std::size_t>(core::choice(node, names))];
}

/// Where the stages before leave the machine, deg; none where no event has said it.
std::optional<double> angle_after(const Scene& scene) {
  if (scene.stages.empty() || !scene.stages.back().timed) return std::nullopt;
  return scene.stages.back().timed->from + scene.stages.back().duration / scene.timing->cycle * turn;
}

/// The angle at which the stage begins: that of its event, which is where the stage before has ended.
std::optional<double> read_start(const CaseNode* from, const Scene& scene) {
  const auto at = angle_after(scene);
  if (!from) return at;
  const Timing::Event& event = read_event(*from, scene);
  if (!at && !scene.stages.empty())
    core::refuse(*from,
                 "a start was found, allowed is one in the first stage; the others begin where the one before ends");
  if (at && std::abs(std::remainder(*at - event.angle, turn)) > same_angle)
    core::refuse(*from, fmt::format("\"{}\" is at {:g} deg, but the stage before ends at {:g} deg; allowed is an event "
                                    "there, or none",
                                    event.name, event.angle, std::fmod(*at, turn)));
  return at ? at : event.angle;
}

/// deg from one angle forward to another, above 0 and up to a turn.
double forward(double from, double to) {
  const double ahead = std::fmod(std::fmod(to - from, turn) + turn, turn);
  return ahead > same_angle ? ahead : turn;
}

}  // namespace

std::optional<Timing> read_timing(core::CaseFile& file, const std::vector<core::NamedDimension>& dimensions) {
  const auto& items = file.root.items;
  const auto node =
      std::find_if(items.begin(), items.end(), [](const CaseNode& item) { return item.name == "timing"; });
  if (node == items.end()) return std::nullopt;
  const CaseTable table(*node, {"cuts", "sections", "event"});
  Timing timing;
  timing.cuts = core::positive(table.get("cuts"), dimension::frequency);
  timing.sections = table.find("sections") ? core::count(*table.find("sections")) : 1;
  timing.cycle = timing.sections / timing.cuts;
  for (const CaseNode& event : core::entries(table.get("event"))) {
    refuse_taken_name(event, dimensions);
    timing.events.push_back({event.name, read_angle(event)});
  }
  std::stable_sort(timing.events.begin(), timing.events.end(),
                   [](const Timing::Event& a, const Timing::Event& b) { return a.angle < b.angle; });
  auto named = dimensions;
  const auto times = named_times(timing);
  named.insert(named.end(), times.begin(), times.end());
  core::let_name(file, named);
  return timing;
}

void read_times(const CaseTable& table, const Scene& scene, Stage& stage) {
  const auto *from = table.find("from"), *until = table.find("until");
  const auto start = read_start(from, scene);
  if (until && table.find("duration"))
    core::refuse(*until, "a duration and an event were found, allowed is one of them");
  if (start) stage.timed = TimedStage{*start, until ? until->text : ""};
  if (!until) {
    stage.duration = core::positive(table.get("duration"), dimension::time);
    return;
  }
  const Timing::Event& event = read_event(*until, scene);
  if (!start)
    core::refuse(*until,
                 "nothing says where the machine is at the stage's start, allowed is from = \"EVENT\" in the first "
                 "stage");
  stage.duration = forward(*start, event.angle) / turn * scene.timing->cycle;
  double planned = 0;
  for (const Stage& earlier : scene.stages) planned += earlier.duration;
  stage.end_time = planned + stage.duration;
}

}  // namespace parison::forming
