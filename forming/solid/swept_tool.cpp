// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/swept_tool.hpp"

#include <algorithm>
#include <cmath>

namespace parison::forming {

namespace {

/// Distance from a place of a body to its boundaries of some kinds, m; infinite where it has none.
template <typename Wanted>
double distance_to(const Body& body, const Point& at, const Wanted& wanted) {
  double nearest = HUGE_VAL;
  for (const core::Segment& segment : body.profile.segments)
    if (wanted(body.boundaries[segment.boundary_id].kind)) nearest = core::distance(segment, at, nearest);
  return nearest;
}

/// How much a place of a tool has of the shape of its sections: 1 at the glass, 0 at its cooled and open sides.
double share_of_shape(const Body& tool, const Point& at) {
  const double to_glass = distance_to(tool, at, [](BoundaryKind kind) { return kind == BoundaryKind::contact; });
  const double to_outside = distance_to(tool, at, [](BoundaryKind kind) {
    return kind == BoundaryKind::cooled || kind == BoundaryKind::air || kind == BoundaryKind::temperature;
  });
  return std::isfinite(to_outside) && to_glass + to_outside > 0 ? to_outside / (to_glass + to_outside) : 1;
}

core::SectionMap section_map(const Tool& tool) {
  if (tool.section.is_round()) return core::round_section;
  return [&tool](double r, double z, double angle) {
    const double share = share_of_shape(tool, {r, z});
    const double radius = r * (1 + share * (core::reach(tool.section, {r, z}, angle) - 1));
    return core::Vector3(radius * std::cos(angle), radius * std::sin(angle), z);
  };
}

}  // namespace

SolidTool swept_tool(const Scene& scene, const State& state, Index tool) {
  const Tool& body = scene.tools[tool];
  const ToolState& round = state.tools[tool];
  SolidTool result;
  result.tool = tool;
  result.surface = std::make_shared<contact::SectionSurface>(body.profile, contact_boundaries(body), body.section);
  // Quadratic in the angle: arcs of 15 degrees are round to 1e-5 of their radius; shapes with corners need more.
  const double arc = body.section.is_round() ? M_PI / 12 : M_PI / 32;
  const auto layers = std::max(Index{1}, static_cast<Index>(std::lround(scene.solid->sector / arc)));
  result.mesh = core::sweep(round.mesh, 0, scene.solid->sector, layers, section_map(body));
  result.temperature = core::from_section(result.mesh, round.temperature);
  result.mass = thermal::point_masses(result.mesh.nodes, core::cell_list(result.mesh, core::prism_table()),
                                      *body.thermal, result.temperature);
  return result;
}

}  // namespace parison::forming
