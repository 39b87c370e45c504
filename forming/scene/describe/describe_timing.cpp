// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/describe/describe_timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/tolerances.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/outline_place.hpp"

namespace parison::forming {

namespace {

/// Offsets at which a tool may stand when a stage begins: at its start, where the press ends, where given motions end.
std::vector<double> possible_offsets(const Scene& scene, Index tool) {
  std::vector<double> offsets{scene.tools[tool].position};
  const auto& plan = scene.container;
  if (plan && plan->press && plan->press->tool == tool) offsets.push_back(plan->press->stop);
  for (const Stage& stage : scene.stages)
    for (const StageTool& entry : stage.tools)
      if (const auto* motion = std::get_if<PositionMotion>(&entry.motion); motion && entry.tool == tool)
        offsets.push_back(motion->offset(stage.duration));
  return offsets;
}

/// Distance from a point to the contact boundaries of a body, m.
double distance_to(const Body& body, const core::Point& point) {
  const auto place = closest_contact(body, point);
  return place ? (place->point - point).norm() : HUGE_VAL;
}

/// The same to the nearest of glass and tools.
double distance_to_bodies(const Scene& scene, const core::Point& point) {
  double least = distance_to(scene.glass, point);
  for (std::size_t i = 0; i < scene.tools.size(); ++i)
    for (const double offset : possible_offsets(scene, static_cast<Index>(i)))
      least = std::min(least, distance_to(scene.tools[i], point - offset * core::axis_direction()));
  return least;
}

}  // namespace

std::string describe_named_points(const Scene& scene, const Stage& stage) {
  std::string text;
  const double allowed = core::tolerance::named_end * core::size(scene.glass.profile);
  for (const NamedBoundary& named : stage.named_boundaries) {
    if (named.touched) continue;
    text += fmt::format("  {:<20}names {}: from ({:.4g}, {:.4g}) to ({:.4g}, {:.4g}) mm\n", "", named.name,
                        1e3 * named.from[0], 1e3 * named.from[1], 1e3 * named.to[0], 1e3 * named.to[1]);
    for (const core::Point& point : {named.from, named.to})
      if (const double far = distance_to_bodies(scene, point); far > allowed)
        text += fmt::format(
            "  {:<20}  ({:.4g}, {:.4g}) mm lies {:.3g} mm from the glass as drawn and from every tool: the run ends "
            "here unless the glass has come to within {:.3g} mm; touched = \"TOOL\" needs no point\n",
            "", 1e3 * point[0], 1e3 * point[1], 1e3 * far, 1e3 * allowed);
  }
  return text;
}

namespace {

std::string stage_rows(const Scene& scene) {
  const double degrees = 360 / scene.timing->cycle;  // in a second
  std::string text = fmt::format("  {:<20}{:<18}{:<20}{}\n", "", "deg", "s", "ends at");
  double time = 0;
  for (const Stage& stage : scene.stages) {
    const double end = time + stage.duration;
    const std::string seconds = fmt::format("{:.4g} to {:.4g}", time, end);
    std::string angles = "-";
    if (stage.timed) {
      const double from = std::fmod(stage.timed->from, 360.0);
      angles = fmt::format("{:.4g} to {:.4g}", from, std::fmod(stage.timed->from + stage.duration * degrees, 360.0));
    }
    const bool at_event = stage.timed && !stage.timed->until_event.empty();
    text += fmt::format("  {:<20}{:<18}{:<20}{}\n", stage.name, angles, seconds,
                        at_event ? stage.timed->until_event : "its duration");
    time = end;
  }
  return text;
}

/// From the first stage in which a tool is active to the end of the last.
std::string tool_rows(const Scene& scene) {
  std::string text;
  for (Index tool = 0; tool < static_cast<Index>(scene.tools.size()); ++tool) {
    double time = 0, first = -1, last = 0;
    for (const Stage& stage : scene.stages) {
      const bool active = stage.uses(tool);
      if (active && first < 0) first = time;
      time += stage.duration;
      if (active) last = time;
    }
    if (first < 0) continue;
    const double share = (last - first) / scene.timing->cycle;
    text +=
        fmt::format("  {:<20}in use for {:.4g} deg, {:.0f} % of the cycle{}\n", scene.tools[tool].name, 360 * share,
                    100 * share, share > 1 ? ": longer than a cycle, so that a second one takes turns with it" : "");
  }
  return text;
}

}  // namespace

std::string describe_timing(const Scene& scene) {
  if (!scene.timing) return "";
  const Timing& timing = *scene.timing;
  return fmt::format("\ntiming                {:.4g} cuts a minute, {} section{}: a cycle of {:.4g} s, {:.4g} deg/s\n",
                     60 * timing.cuts, timing.sections, timing.sections == 1 ? "" : "s", timing.cycle,
                     360 / timing.cycle) +
         stage_rows(scene) + tool_rows(scene);
}

}  // namespace parison::forming
