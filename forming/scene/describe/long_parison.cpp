// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "forming/scene/describe/unusual.hpp"

namespace parison::forming {
namespace {

/// Places of the outside of the parison: of the contact boundaries that close its cavity, the plunger's left out.
std::vector<core::Point> outside_of(const Scene& scene, const ParisonPlan& parison) {
  const Stage& stage = scene.stages[static_cast<std::size_t>(parison.stage)];
  const double off = 1e-4 * core::size(scene.glass.profile);
  const auto is_covered = [&](const core::Point& x, Index by) {  // by another tool of the stage
    return std::any_of(stage.tools.begin(), stage.tools.end(), [&](const StageTool& one) {
      const Tool& tool = scene.tools[static_cast<std::size_t>(one.tool)];
      return one.tool != by && one.tool != parison.plunger &&
             core::contains(tool.profile, x - tool.position * core::axis_direction());
    });
  };
  constexpr std::size_t most_work = 20'000'000, per_segment = 50;
  std::size_t segments = 0, seen = 0;
  for (const StageTool& entry : stage.tools)
    segments += scene.tools[static_cast<std::size_t>(entry.tool)].profile.segments.size();
  const std::size_t stride = 1 + per_segment * segments * segments / most_work;
  std::vector<core::Point> surface;
  for (const StageTool& entry : stage.tools) {
    const Tool& tool = scene.tools[static_cast<std::size_t>(entry.tool)];
    if (entry.tool == parison.plunger || has_moved_before(scene, parison.stage + 1, entry.tool)) continue;
    for (const core::Segment& segment : tool.profile.segments) {
      if (tool.boundaries[segment.boundary_id].kind != BoundaryKind::contact) continue;
      for (std::size_t i = 0; i <= per_segment; ++i) {
        if (seen++ % stride != 0) continue;
        const double t = double(i) / per_segment;
        const core::Point x = core::point_at(segment, t) + tool.position * core::axis_direction();
        const core::Point free = x + off * core::normal_at(segment, t);
        const core::Point inward = free - core::Point(off, 0);  // at the outer end of a face that lies on another tool
        if (free[1] > parison.low && free[1] < parison.high && !is_covered(free, entry.tool) &&
            !is_covered(inward, entry.tool))
          surface.push_back(x);
      }
    }
  }
  return surface;
}

/// How deep some of these places lie in a tool, the deepest of them; 0 where none does.
struct Depth {
  double depth = 0;  ///< m
  core::Point at = core::Point::Zero();
};
Depth depth_in(const Tool& tool, const std::vector<core::Point>& places) {
  Depth found;
  for (const core::Point& x : places) {
    const core::Point own = x - tool.position * core::axis_direction();
    if (!core::contains(tool.profile, own)) continue;
    if (const double here = core::distance(tool.profile, own); here > found.depth) found = {here, x};
  }
  return found;
}

/// An overlap from which on it is told: 0.5 mm of a gob of 66 mm.
double told_from(const Scene& scene) {
  return 7.5e-3 * core::size(scene.glass.profile);
}

/// Whether pressure or a moving tool forms the glass in a stage.
bool forms(const Stage& stage) {
  return stage.blows() ||
         std::any_of(stage.tools.begin(), stage.tools.end(), [](const StageTool& tool) { return tool.moves(); });
}

}  // namespace

std::vector<std::string> gob_in_later_tools(const Scene& scene) {
  std::vector<std::string> notes;
  if (!scene.has_flow() || scene.geometry != core::Geometry::axisymmetric) return notes;
  const core::Profile& gob = scene.glass.profile;
  const auto places = core::polyline(gob, core::size(gob) / 100, HUGE_VAL);
  for (std::size_t s = 1; s < scene.stages.size() && !forms(scene.stages[s - 1]); ++s)
    for (const StageTool& entry : scene.stages[s].tools) {
      const Tool& tool = scene.tools[static_cast<std::size_t>(entry.tool)];
      if (first_use(scene, entry.tool) != static_cast<Index>(s)) continue;
      if (const auto [depth, at] = depth_in(tool, places); depth > told_from(scene))
        notes.push_back(fmt::format(
            "\"{}\", which comes in stage \"{}\", reaches {:.3g} mm into the glass as it lies at the start, at "
            "({:.4g}, {:.4g}) mm, and nothing but its weight forms the glass before; a wider gob is shorter, and one "
            "without a diameter takes the shape of its tool",
            tool.name, scene.stages[s].name, 1e3 * depth, 1e3 * at[0], 1e3 * at[1]));
    }
  return notes;
}

namespace {

/// The tools that come after the parison was formed.
std::vector<Index> later_moulds(const Scene& scene, const ParisonPlan& parison) {
  std::vector<Index> moulds;
  const Stage& formed = scene.stages[static_cast<std::size_t>(parison.stage)];
  for (Index t = 0; t < static_cast<Index>(scene.tools.size()); ++t) {
    const Index first = first_use(scene, t);
    if (first >= static_cast<Index>(scene.stages.size()) || first <= parison.stage || formed.uses(t)) continue;
    if (!scene.stages[static_cast<std::size_t>(first)].cools) moulds.push_back(t);  // else it carries the container
  }
  return moulds;
}

}  // namespace

std::vector<ParisonClearance> parison_clearance(const Scene& scene, const ContainerPlan& plan) {
  std::vector<ParisonClearance> found;
  if (!plan.parison) return found;
  const std::vector<Index> moulds = later_moulds(scene, *plan.parison);
  if (moulds.empty()) return found;
  for (const core::Point& x : outside_of(scene, *plan.parison)) {
    double least = HUGE_VAL;
    for (const Index t : moulds) {
      const Tool& mould = scene.tools[static_cast<std::size_t>(t)];
      const core::Point own = x - mould.position * core::axis_direction();
      const double distance = core::distance(mould.profile, own);
      least = std::min(least, core::contains(mould.profile, own) ? -distance : distance);
    }
    found.push_back({x, least});
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.at[1] < b.at[1]; });
  return found;
}

std::vector<std::string> parison_too_large(const Scene& scene, const ContainerPlan& plan) {
  std::vector<std::string> notes;
  if (!plan.parison) return notes;
  const std::vector<core::Point> surface = outside_of(scene, *plan.parison);
  const Stage& formed = scene.stages[static_cast<std::size_t>(plan.parison->stage)];
  for (const Index t : later_moulds(scene, *plan.parison)) {
    const Tool& mould = scene.tools[static_cast<std::size_t>(t)];
    const Index first = first_use(scene, t);
    if (const auto [depth, at] = depth_in(mould, surface); depth > told_from(scene))
      notes.push_back(fmt::format(
          "the parison as stage \"{}\" {} it is too large for \"{}\" of stage \"{}\": it would reach {:.3g} mm "
          "into "
          "that tool near ({:.4g}, {:.4g}) mm even without hanging; a shorter or slimmer blank, or a larger mould, has "
          "room for it",
          formed.name, plan.parison->plunger ? "presses" : "blows", mould.name,
          scene.stages[static_cast<std::size_t>(first)].name, 1e3 * depth, 1e3 * at[0], 1e3 * at[1]));
  }
  return notes;
}

}  // namespace parison::forming
