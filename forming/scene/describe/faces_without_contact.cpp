// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "core/mesh/tolerances.hpp"
#include "forming/scene/describe/unusual.hpp"

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

}  // namespace

std::vector<std::string> faces_without_contact(const Scene& scene) {
  std::vector<std::string> notes;
  if (!scene.has_flow()) return notes;
  for (const StageTool& entry : scene.stages.front().tools) {
    const Tool& tool = scene.tools[entry.tool];
    for (std::size_t b = 0; b < tool.boundaries.size(); ++b) {
      const Boundary& face = tool.boundaries[b];
      if (face.kind == BoundaryKind::contact || face.kind == BoundaryKind::symmetry) continue;
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
