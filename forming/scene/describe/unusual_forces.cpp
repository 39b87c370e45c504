// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "forming/scene/container/free_space.hpp"
#include "forming/scene/describe/unusual.hpp"

namespace parison::forming {
namespace {

constexpr double bar = 1e5;

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
  constexpr double least = 3 * bar, most = 300 * bar;
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
      tool.name, force_text(force), stage.name, pressure / bar);
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
        if (entry.tool != static_cast<Index>(i) || std::holds_alternative<std::monostate>(entry.motion)) continue;
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
