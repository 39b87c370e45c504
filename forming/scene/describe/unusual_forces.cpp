// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/numbers.hpp"
#include "forming/scene/container/free_space.hpp"
#include "forming/scene/describe/unusual.hpp"

namespace parison::forming {

namespace {

/// Least height along the axis of the parts of a cavity at a radius, m; infinite where it has none there.
double least_height(const std::vector<Slice>& by_line, double radius) {
  double least = std::numeric_limits<double>::infinity(), height = 0;
  std::size_t last = 0;
  for (const Slice& slice : by_line) {
    if (radius < slice.inner || radius > slice.outer) continue;
    if (height > 0 && slice.line > last + 1) {
      least = std::min(least, height);
      height = 0;
    }
    height += (slice.to - slice.from) / 2;
    last = slice.line;
  }
  return height > 0 ? std::min(least, height) : least;
}

struct ThinPart {
  double height, from, to;  ///< least height along the axis, radii, m
};

/// The widest part of a cavity across the axis that is lower than `limit`, m, on radii that far apart; of height 0
/// where there is none.
ThinPart thin_part(std::vector<Slice> cavity, double limit) {
  constexpr int most = 1000;
  std::sort(cavity.begin(), cavity.end(), [](const Slice& a, const Slice& b) { return a.line < b.line; });
  double outer = 0;
  for (const Slice& slice : cavity) outer = std::max(outer, slice.outer);
  const double apart = std::max(limit, outer / most);
  ThinPart widest{0, 0, 0}, part{0, 0, 0};
  for (double radius = apart / 2; radius < outer; radius += apart) {
    const double height = least_height(cavity, radius);
    if (height < limit) {
      if (part.height == 0) part = {height, radius - apart / 2, 0};
      part.height = std::min(part.height, height);
      part.to = radius + apart / 2;
      if (part.to - part.from > widest.to - widest.from) widest = part;
    } else {
      part.height = 0;
    }
  }
  return widest;
}

}  // namespace

std::vector<std::string> films_too_thin(const Scene& scene, const ContainerPlan& plan) {
  constexpr double counts = 5;  // widths of a film over its least thickness; less is the feather edge of a cavity
  const FilmLimit& limit = scene.glass.film;
  if (!plan.press || !plan.misfit.empty() || limit.then != FilmLimit::Then::stop) return {};
  const ThinPart thin = thin_part(plan.press->glass, limit.min_thickness);
  if (thin.height == 0 || thin.to - thin.from < counts * limit.min_thickness) return {};
  return {fmt::format(
      "where \"{}\" of stage \"{}\" {}, at {:.4g} mm, the glass is {:.2g} mm thick from radius {:.3g} to {:.3g} mm, "
      "thinner than film.min_thickness = {:.3g} mm of the glass: the run will end there. More glass leaves a thicker "
      "film; a smaller film.min_thickness or film.then = \"freeze\" lets the run go on",
      scene.tools[plan.press->tool].name, scene.stages[plan.press->stage].name,
      plan.press->is_driven ? "stops for this mass" : "ends its motion", 1e3 * plan.press->stop, 1e3 * thin.height,
      1e3 * thin.from, 1e3 * thin.to, 1e3 * limit.min_thickness)};
}

namespace {

/// The force of the largest size, with its sign, N.
double strongest(const core::TimeFunction& force) {
  return force.max() >= -force.min() ? force.max() : force.min();
}

std::string force_text(double force) {
  return std::abs(force) >= 1e3 ? fmt::format("{:.4g} kN", 1e-3 * force) : fmt::format("{:.4g} N", force);
}

/// Whether a tool at its start meets the glass only if it moves against the sense (1 or -1).
bool pulls_away(const Scene& scene, const Tool& tool, double sense) {
  const Solid glass{&scene.glass.profile, contact_boundaries(scene.glass), scene.glass.position};
  const Solid moved{&tool.profile, contact_boundaries(tool), tool.position};
  return !free_travel(moved, {glass}, sense) && free_travel(moved, {glass}, -sense);
}

/// Area that a tool shows along the axis with its contact boundaries, m2.
double face_of(const Tool& tool) {
  double radius = 0;
  for (const core::Segment& segment : tool.profile.segments)
    if (tool.boundaries[segment.boundary_id].kind == BoundaryKind::contact)
      radius = std::max({radius, segment.start[0], segment.end[0]});
  return M_PI * radius * radius;
}

std::string note_on(const Scene& scene, const Stage& stage, const Tool& tool, double force, bool is_first) {
  constexpr double least = 3 * core::bar, most = 300 * core::bar;
  if (is_first && pulls_away(scene, tool, force > 0 ? 1 : -1))
    return fmt::format(
        "stage \"{}\" drives \"{}\" with {} away from the glass; a force counts along the axis, a press towards "
        "smaller z is "
        "negative: was \"{}\" meant?",
        stage.name, tool.name, force_text(force), force_text(-force));
  const double pressure = std::abs(force) / face_of(tool);
  if (pressure >= least && pressure <= most) return "";
  return fmt::format(
      "the largest force on \"{}\" is {} (stage \"{}\"), {:.2g} bar over its face; usual are 0.5 to 10 kN, in the "
      "bundled cases 30 to 70 bar over the face",
      tool.name, force_text(force), stage.name, pressure / core::bar);
}

}  // namespace

std::vector<std::string> unusual_forces(const Scene& scene) {
  std::vector<std::string> notes;
  if (scene.geometry != core::Geometry::axisymmetric || !scene.has_flow()) return notes;
  for (std::size_t i = 0; i < scene.tools.size(); ++i) {
    const Stage* of = nullptr;
    double force = 0;
    bool is_first = true;  // nothing has moved the tool before
    for (const Stage& stage : scene.stages)
      for (const StageTool& entry : stage.tools) {
        if (entry.tool != static_cast<Index>(i) || !entry.moves()) continue;
        const auto* motion = std::get_if<ForceMotion>(&entry.motion);
        if (motion && std::abs(strongest(motion->force)) > std::abs(force)) {
          is_first = is_first && !of;
          of = &stage, force = strongest(motion->force);
        }
        if (!motion) is_first = false;
      }
    if (!of) continue;
    const std::string note = note_on(scene, *of, scene.tools[i], force, is_first);
    if (!note.empty()) notes.push_back(note);
  }
  return notes;
}

}  // namespace parison::forming
