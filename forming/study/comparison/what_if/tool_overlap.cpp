// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/comparison/what_if/tool_overlap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "forming/scene/read/tolerances.hpp"
#include "forming/study/comparison/what_if/overlap_on_the_way.hpp"

namespace parison::forming {
namespace {

/// Of the outline of `inner` inside `outer`.
Overlap deepest_inside(const PlacedTool& placed, const PlacedTool& around, double touching) {
  const Tool &inner = placed.tool, &outer = around.tool;
  const core::Point shift = (placed.offset - around.offset) * core::axis_direction();
  const double step = core::size(inner.profile) / 500;
  Overlap deepest;
  for (const core::Point& x : core::polyline(inner.profile, step, touching / 2)) {
    if (!core::contains(outer.profile, x + shift)) continue;
    const double depth = core::distance(outer.profile, x + shift);
    if (depth > deepest.depth) deepest = {depth, x + placed.offset * core::axis_direction()};
  }
  return deepest;
}

}  // namespace

double touching_of(const Tool& a, const Tool& b) {
  return tolerance::initial_overlap * std::max(core::size(a.profile), core::size(b.profile));
}

Overlap overlap_of(const PlacedTool& first, const PlacedTool& second, double touching) {
  const Overlap one = deepest_inside(first, second, touching), other = deepest_inside(second, first, touching);
  const Overlap& deepest = one.depth > other.depth ? one : other;
  return deepest.depth > touching ? deepest : Overlap{};
}

bool is_new_overlap(double changed, double base, double clearance) {
  constexpr double notably = 1.5;
  return changed > (base > 0 ? notably * base + clearance : 0);
}

std::string overlap_in_base(double base) {
  return base > 0 ? fmt::format("those of the base do by {:.3g} mm", 1e3 * base) : "those of the base do not";
}

namespace {

/// Where both start.
Overlap overlap_of(const Scene& scene, Index a, Index b) {
  const Tool &first = scene.tools[a], &second = scene.tools[b];
  return parison::forming::overlap_of({first, first.position}, {second, second.position}, touching_of(first, second));
}

/// Whether both tools work together in a stage.
bool are_together(const Scene& scene, Index a, Index b) {
  return std::any_of(scene.stages.begin(), scene.stages.end(), [&](const Stage& stage) {
    const auto works = [&](Index tool) {
      return std::any_of(stage.tools.begin(), stage.tools.end(),
                         [&](const StageTool& one) { return one.tool == tool; });
    };
    return works(a) && works(b);
  });
}

/// Tools that overlap where they stand, as new_tool_overlap.
std::string rest_overlap(const Scene& base, const Scene& changed) {
  std::set<Index> moved;
  std::set<std::pair<Index, Index>> seen;
  for (const Stage& stage : changed.stages) {
    for (const StageTool& tool : stage.tools)
      if (!std::holds_alternative<std::monostate>(tool.motion)) moved.insert(tool.tool);
    for (const StageTool& one : stage.tools)
      for (const StageTool& other : stage.tools) {
        const Index a = one.tool, b = other.tool;
        if (a >= b || moved.count(a) + moved.count(b) > 0 || !seen.insert({a, b}).second) continue;
        const double touching = touching_of(changed.tools[a], changed.tools[b]);
        const Overlap found = overlap_of(changed, a, b);
        const double before = are_together(base, a, b) ? overlap_of(base, a, b).depth : 0;
        if (is_new_overlap(found.depth, before, touching))
          return fmt::format(
              "tools \"{}\" and \"{}\" overlap by {:.3g} mm, near ({:g}, {:g}) mm, in stage {}, where {}; allowed is "
              "contact to within {:.2g} mm{}",
              changed.tools[a].name, changed.tools[b].name, 1e3 * found.depth, 1e3 * found.at[0], 1e3 * found.at[1],
              stage.name, overlap_in_base(before), 1e3 * touching,
              before > 0 ? ", or about the overlap of the base" : "");
      }
  }
  return {};
}

}  // namespace

std::string new_tool_overlap(const Scene& base, const Scene& changed) {
  const std::string found = rest_overlap(base, changed);
  return found.empty() ? new_overlap_on_the_way(base, changed) : found;
}

}  // namespace parison::forming
