// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/comparison/what_if/tool_overlap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/read/tolerances.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

namespace {

/// Places between two corners of a motion, since a tool may pass a narrow place between them.
constexpr int between_corners = 8;
/// Places of a plunger on its way to its stop.
constexpr int of_stroke = 32;

/// The offset of a tool over the time since the start of a stage, and the times that count.
struct Course {
  core::Table offset;
  std::vector<double> times;
  bool is_motion;
};

/// Of each tool of a stage; nothing where a force or an event decides.
using StageCourses = std::map<Index, std::optional<Course>>;

const Tool& tool_of(const Scene& scene, Index tool) {
  return scene.tools[static_cast<std::size_t>(tool)];
}

std::vector<double> times_of(const core::Table& offset, double duration) {
  constexpr double share = 1e-3;  // of the stroke, which corners of a measured curve may miss
  std::vector<double> corners{0};
  for (const double time : core::corners(offset, share))
    if (time > 0 && time < duration) corners.push_back(time);
  corners.push_back(duration);
  std::vector<double> times;
  for (std::size_t i = 1; i < corners.size(); ++i)
    for (int k = 0; k < between_corners; ++k)
      times.push_back(corners[i - 1] + (corners[i] - corners[i - 1]) * k / between_corners);
  times.push_back(duration);
  return times;
}

std::optional<Course> course_of(const Stage& stage, const Motion& motion, const std::optional<double>& now) {
  if (std::holds_alternative<std::monostate>(motion))
    return now ? std::optional(Course{core::constant(*now), {0}, false}) : std::nullopt;
  const auto* given = std::get_if<PositionMotion>(&motion);
  if (!given || stage.may_end_early()) return std::nullopt;
  return Course{given->offset, times_of(given->offset, stage.duration), true};
}

std::vector<StageCourses> courses_of(const Scene& scene) {
  std::vector<std::optional<double>> now;
  for (const Tool& tool : scene.tools) now.emplace_back(tool.position);
  std::vector<StageCourses> courses;
  for (const Stage& stage : scene.stages) {
    StageCourses& of_stage = courses.emplace_back();
    for (const StageTool& used : stage.tools) {
      auto& at = now[static_cast<std::size_t>(used.tool)];
      const auto course = course_of(stage, used.motion, at);
      of_stage[used.tool] = course;
      at = course ? std::optional(course->offset(stage.duration)) : std::nullopt;
    }
  }
  return courses;
}

/// An overlap on the way, and when; and how deep the tools lie in each other in the base, m.
struct Meeting {
  Overlap overlap;
  double time = 0;
  double in_base = 0;
};

/// The deepest overlap of two tools that go their ways at the same time.
Meeting deepest(const PlacedTool& a, const Course& of_a, const PlacedTool& b, const Course& of_b, double touching) {
  Meeting found;
  for (const Course* course : {&of_a, &of_b})
    for (const double time : course->times) {
      const Overlap now = overlap_of({a.tool, of_a.offset(time)}, {b.tool, of_b.offset(time)}, touching);
      if (now.depth > found.overlap.depth) found = {now, time, 0};
    }
  return found;
}

/// How deep a plunger that a force drives lies in another tool on its way to its stop; infinite where that is unknown.
double overlap_on_stroke(const Scene& scene, Index a, Index b) {
  const auto& plan = scene.container;
  if (!plan || !plan->press || (plan->press->tool != a && plan->press->tool != b))
    return std::numeric_limits<double>::infinity();
  const Tool& plunger = tool_of(scene, plan->press->tool);
  const Tool& other = tool_of(scene, plan->press->tool == a ? b : a);
  double deepest = 0;
  for (int i = 0; i <= of_stroke; ++i) {
    const double offset = plunger.position + (plan->press->stop - plunger.position) * i / of_stroke;
    deepest =
        std::max(deepest, overlap_of({plunger, offset}, {other, other.position}, touching_of(plunger, other)).depth);
  }
  return deepest;
}

/// How deep two tools lie in each other in any stage of a case, m, as far as that can be told before a run; infinite
/// where it cannot.
double most_overlap(const Scene& scene, const std::vector<StageCourses>& courses, Index a, Index b) {
  const Tool &first = tool_of(scene, a), &second = tool_of(scene, b);
  const double touching = touching_of(first, second);
  bool is_driven = false;
  double most = 0;
  for (const StageCourses& stage : courses) {
    const auto one = stage.find(a), other = stage.find(b);
    if (one == stage.end() || other == stage.end()) continue;
    if (!one->second || !other->second)
      is_driven = true;
    else
      most = std::max(most, deepest({first, 0}, *one->second, {second, 0}, *other->second, touching).overlap.depth);
  }
  return is_driven ? std::max(most, overlap_on_stroke(scene, a, b)) : most;
}

std::string sentence(const Scene& scene, const Stage& stage, const std::pair<Index, Course>& moved, Index other,
                     const Meeting& met, double clearance) {
  const std::string& name = tool_of(scene, moved.first).name;
  return fmt::format(
      "tools \"{}\" and \"{}\" overlap by {:.3g} mm, near ({:.4g}, {:.4g}) mm, in stage {}, where the motion of "
      "\"{}\" has it at {:.4g} mm after {:.3g} s; {}; allowed is a motion that keeps them apart, to within {:.2g} mm{}",
      name, tool_of(scene, other).name, 1e3 * met.overlap.depth, 1e3 * met.overlap.at[0], 1e3 * met.overlap.at[1],
      stage.name, name, 1e3 * moved.second.offset(met.time), met.time, overlap_in_base(met.in_base), 1e3 * clearance,
      met.in_base > 0 ? ", or no deeper than in the base" : "");
}

/// Tools of a changed case that overlap on the way that a given motion takes one of them, by more than a clearance, as
/// a sentence; empty where there are none. Where tools of the base overlap too, on a given way, where they stand or on
/// the way of a plunger that a force drives to its stop, they are meant to slide in each other. Stages that an event
/// may end before the motion does are left out: nobody knows how far it goes.
std::string new_overlap_on_the_way(const Scene& base, const Scene& changed) {
  const auto before = courses_of(base), now = courses_of(changed);
  const double sealed = tolerance::sealed * core::size(changed.glass.profile);
  for (std::size_t s = 0; s < now.size(); ++s)
    for (const auto& [a, of_a] : now[s])
      for (const auto& [b, of_b] : now[s]) {
        if (a == b || !of_a || !of_b || !of_a->is_motion || (of_b->is_motion && b < a)) continue;
        const Tool &moved = tool_of(changed, a), &other = tool_of(changed, b);
        const double clearance = std::max(sealed, touching_of(moved, other));
        Meeting met = deepest({moved, 0}, *of_a, {other, 0}, *of_b, clearance);
        if (!(met.overlap.depth > 0)) continue;
        met.in_base = most_overlap(base, before, a, b);
        if (is_new_overlap(met.overlap.depth, met.in_base, clearance))
          return sentence(changed, changed.stages[s], {a, *of_a}, b, met, clearance);
      }
  return {};
}

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
  return std::any_of(scene.stages.begin(), scene.stages.end(),
                     [&](const Stage& stage) { return stage.uses(a) && stage.uses(b); });
}

/// Tools that overlap where they stand, as new_tool_overlap.
std::string rest_overlap(const Scene& base, const Scene& changed) {
  std::set<Index> moved;
  std::set<std::pair<Index, Index>> seen;
  for (const Stage& stage : changed.stages) {
    for (const StageTool& tool : stage.tools)
      if (tool.moves()) moved.insert(tool.tool);
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
