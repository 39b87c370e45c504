// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/describe/support.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/tolerances.hpp"
#include "forming/scene/container/free_space.hpp"

namespace parison::forming {
namespace {

/// Whether a part of `points` is nearer to the contact boundaries of a body, moved by `shift` along the axis, than
/// `near`, m.
bool comes_near(const std::vector<core::Point>& points, const Body& body, double shift, double near) {
  return std::any_of(points.begin(), points.end(), [&](const core::Point& x) {
    return std::any_of(body.profile.segments.begin(), body.profile.segments.end(), [&](const core::Segment& segment) {
      return body.boundaries[segment.boundary_id].kind == BoundaryKind::contact &&
             core::distance(segment, x - shift * core::axis_direction(), 2 * near) < near;
    });
  });
}

/// Some 500 places of the contact boundaries of a body, moved by `shift` along the axis, ends of segments included.
std::vector<core::Point> places_of(const Body& body, double shift) {
  double whole = 0;
  for (const core::Segment& segment : body.profile.segments) whole += core::length(segment);
  std::vector<core::Point> places;
  for (const core::Segment& segment : body.profile.segments) {
    if (body.boundaries[segment.boundary_id].kind != BoundaryKind::contact) continue;
    const int count = 1 + static_cast<int>(500 * core::length(segment) / whole);
    for (int i = 0; i <= count; ++i)
      places.push_back(core::point_at(segment, double(i) / count) + shift * core::axis_direction());
  }
  return places;
}

/// The tools of the first stage that the glass touches at the start.
std::vector<Index> touched_tools(const Scene& scene) {
  constexpr std::size_t most_work = 50'000'000;
  const double near = core::tolerance::junction * core::size(scene.glass.profile);
  const auto of_glass = places_of(scene.glass, scene.glass.position);
  std::vector<Index> touched;
  for (const StageTool& entry : scene.stages.front().tools) {
    const Tool& tool = scene.tools[entry.tool];
    const auto of_tool = places_of(tool, tool.position);
    const std::size_t work =
        of_glass.size() * tool.profile.segments.size() + of_tool.size() * scene.glass.profile.segments.size();
    if (work > most_work || comes_near(of_glass, tool, tool.position, near) ||
        comes_near(of_tool, scene.glass, scene.glass.position, near))
      touched.push_back(entry.tool);
  }
  return touched;
}

/// Whether the weight of the glass acts in the first stage and tools alone can carry it.
bool needs_support(const Scene& scene) {
  const Stage& first = scene.stages.front();
  return scene.has_flow() && scene.geometry == core::Geometry::axisymmetric && first.gravity != 0 &&
         !first.tools.empty() && !constrained_along_axis(scene.glass);
}

}  // namespace

bool constrained_along_axis(const Glass& glass) {
  constexpr double across = 1e-3;  // smallest cosine of the angle between normal and axis
  return std::any_of(glass.profile.segments.begin(), glass.profile.segments.end(), [&](const core::Segment& segment) {
    const BoundaryKind kind = glass.boundaries[segment.boundary_id].kind;
    return kind == BoundaryKind::fixed ||
           (kind == BoundaryKind::symmetry &&
            std::abs(core::normal_at(segment, 0.5).dot(core::axis_direction())) > across);
  });
}

std::string describe_support(const Scene& scene) {
  if (!needs_support(scene)) return "";
  std::string names;
  for (const Index tool : touched_tools(scene)) names += (names.empty() ? "" : ", ") + scene.tools[tool].name;
  return fmt::format("  {:<20}{}\n", "carried at start by", names.empty() ? "nothing" : names);
}

std::string falling_note(const Scene& scene) {
  if (!needs_support(scene) || !touched_tools(scene).empty()) return "";
  const Stage& first = scene.stages.front();
  std::vector<Solid> solids;
  for (const StageTool& entry : first.tools) {
    const Tool& tool = scene.tools[entry.tool];
    solids.push_back({&tool.profile, contact_boundaries(tool), tool.position});
  }
  const Solid glass{&scene.glass.profile, contact_boundaries(scene.glass), scene.glass.position};
  Stop stop{HUGE_VAL};
  for (const FreeShifts& range : free_shifts(glass, solids))
    if (range.low.shift <= 0 && range.high.shift >= 0) stop = first.gravity < 0 ? range.low : range.high;
  std::string note =
      fmt::format("nothing carries the glass at the start of stage \"{}\": it touches no tool and ", first.name);
  if (std::isfinite(stop.shift))
    note += fmt::format("falls by {:.3g} mm until it meets \"{}\" at ({:.4g}, {:.4g}) mm", 1e3 * std::abs(stop.shift),
                        scene.tools[first.tools[stop.met].tool].name, 1e3 * stop.at[0], 1e3 * stop.at[1]);
  else
    note += "has none below it";
  return note + "; gob = { mass, diameter, in = \"blank\" } lays it on the tools";
}

}  // namespace parison::forming
