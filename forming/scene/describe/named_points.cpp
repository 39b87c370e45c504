// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/describe/named_points.hpp"

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

}  // namespace parison::forming
