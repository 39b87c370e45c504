// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "core/mesh/tolerances.hpp"
#include "forming/scene/describe/unusual.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

/// Whether the inner part of a segment of a tool lies along the outline of the glass; both are moved along the axis, m.
bool lies_at_glass(const Body& glass, const core::Segment& face, double shift) {
  const double near = core::tolerance::junction * core::size(glass.profile);
  constexpr int places = 16;
  int together = 0;
  for (int i = 1; i < places; ++i) {
    const core::Point x = core::point_at(face, double(i) / places) + shift * core::axis_direction();
    const bool close = core::distance(glass.profile, x) < near;
    together = close ? together + 1 : 0;
    if (together == 2) return true;  // more than a corner
  }
  return false;
}

/// Whether a boundary neither touches glass nor is a plane of symmetry.
bool has_no_contact(const Boundary& boundary) {
  return boundary.kind != BoundaryKind::contact && boundary.kind != BoundaryKind::symmetry;
}

/// A part of a tool's boundary that a cavity has for its wall.
struct Wall {
  double length = 0;  ///< m
  core::Point at = core::Point::Zero();
};

Wall wall_of(const std::vector<Slice>& cavity, const Tool& tool, Index boundary, double offset, double clear) {
  constexpr int places = 50;
  Wall wall;
  for (const core::Segment& segment : tool.profile.segments) {
    if (segment.boundary_id != boundary) continue;
    for (int i = 0; i < places; ++i) {
      const double t = (i + 0.5) / places;
      const core::Point x = core::point_at(segment, t) + offset * core::axis_direction();
      const core::Point free = x + clear * core::normal_at(segment, t);
      const bool bounds = std::any_of(cavity.begin(), cavity.end(), [&](const Slice& slice) {
        return free[1] > slice.from && free[1] < slice.to && free[0] > slice.inner && free[0] < slice.outer;
      });
      if (bounds && wall.length == 0) wall.at = x;
      if (bounds) wall.length += core::length(segment) / places;
    }
  }
  return wall;
}

}  // namespace

std::vector<std::string> cavity_without_contact(const Scene& scene, const ContainerPlan& plan) {
  std::vector<std::string> notes;
  if (!plan.press) return notes;
  const Stage& stage = scene.stages[static_cast<std::size_t>(plan.press->stage)];
  const double size = core::size(scene.glass.profile), allowed = 7.5e-3 * size;  // 0.5 mm of a gob of 66 mm
  for (const StageTool& entry : stage.tools) {
    const Tool& tool = scene.tools[static_cast<std::size_t>(entry.tool)];
    const auto offset = plan.press->offsets[static_cast<std::size_t>(entry.tool)];
    for (std::size_t b = 0; offset && b < tool.boundaries.size(); ++b) {
      if (!has_no_contact(tool.boundaries[b])) continue;
      const Wall wall = wall_of(plan.press->glass, tool, Index(b), *offset, tolerance::sealed * size);
      if (wall.length > allowed)
        notes.push_back(fmt::format(
            "once full, the cavity of stage \"{}\" has {:.3g} mm of boundary \"{}\" of \"{}\" for its "
            "wall, from ({:.4g}, {:.4g}) mm, which has no contact: glass enters the tool there; either the tools close "
            "before it, or the boundary needs condition = \"contact\"",
            stage.name, 1e3 * wall.length, tool.boundaries[b].name, tool.name, 1e3 * wall.at[0], 1e3 * wall.at[1]));
    }
  }
  return notes;
}

std::vector<std::string> faces_without_contact(const Scene& scene) {
  std::vector<std::string> notes;
  if (!scene.has_flow()) return notes;
  for (const StageTool& entry : scene.stages.front().tools) {
    const Tool& tool = scene.tools[entry.tool];
    for (std::size_t b = 0; b < tool.boundaries.size(); ++b) {
      const Boundary& face = tool.boundaries[b];
      if (!has_no_contact(face)) continue;
      const auto& segments = tool.profile.segments;
      const bool told = std::any_of(segments.begin(), segments.end(), [&](const core::Segment& segment) {
        return segment.boundary_id == Index(b) &&
               lies_at_glass(scene.glass, segment, tool.position - scene.glass.position);
      });
      if (told)
        notes.push_back(fmt::format(
            "the glass lies at boundary \"{}\" of \"{}\", which has no contact: glass enters a tool there; where it is "
            "to touch, the boundary needs condition = \"contact\"",
            face.name, tool.name));
    }
  }
  return notes;
}

}  // namespace parison::forming
