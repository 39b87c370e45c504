// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/diagnostics/glass_in_tools.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/unilateral/tool_gap.hpp"
#include "core/mesh/profile.hpp"
#include "core/mesh/tolerances.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/contact/penetration.hpp"
#include "forming/step/contact/placed_tools.hpp"

namespace parison::forming {

namespace {

/// Depth from which a node counts as come into a tool, m: 1 % of the mean wall, or less where the glass is thick and
/// what no step leaves behind a contact face.
double entered_depth(const Scene& scene, const core::Mesh& glass) {
  constexpr double of_wall = 0.01, of_step = 2 * core::tolerance::rejected_penetration;
  return std::min(of_wall * core::mean_wall(glass), of_step * core::size(scene.glass.profile));
}

/// The segment of an outline that is closest to a point, symmetry left out, and its distance, m.
std::pair<const core::Segment*, double> closest_face(const Body& body, const Point& x) {
  std::pair<const core::Segment*, double> closest{nullptr, std::numeric_limits<double>::infinity()};
  for (const core::Segment& segment : body.profile.segments) {
    if (body.boundaries[segment.boundary_id].kind == BoundaryKind::symmetry) continue;
    const double distance = core::distance(segment, x, closest.second);
    if (distance < closest.second) closest = {&segment, distance};
  }
  return closest;
}

}  // namespace

std::optional<ToolFace> entered_face(const Scene& scene, const State& state) {
  constexpr double beside = 2;  // depths: a node that is no farther behind a contact face came in at their corner
  const core::Mesh& glass = state.glass.mesh;
  const double allowed = entered_depth(scene, glass);
  for (const Index tool : active_tools(scene, state)) {
    const Tool& body = scene.tools[tool];
    const contact::ToolGap gap(body.profile, contact_boundaries(body));
    const Point offset = state.tools[tool].offset * core::axis_direction();
    for (const Index node : surface_nodes(glass)) {
      const Point local = glass.nodes[node] - offset;
      if (!core::contains(body.profile, local)) continue;
      const auto [face, depth] = closest_face(body, local);
      const bool is_free = face && body.boundaries[face->boundary_id].kind != BoundaryKind::contact;
      if (is_free && depth > allowed && std::abs(gap(local)) > beside * depth) return ToolFace{tool, face->boundary_id};
    }
  }
  return {};
}

void follow_glass_in_tools(const Scene& scene, const State& state, GlassInTools& seen) {
  const double wall = core::mean_wall(state.glass.mesh);
  const auto include = [&](auto&& deepest, Penetrated& so_far) {
    const Depth found = deepest(scene, state, std::min(so_far.depth, so_far.share * wall));
    if (found.tool >= 0 && found.depth > so_far.depth)
      so_far.place = {found.tool, found.place[0], found.place[core::dim - 1], state.time};
    so_far.depth = std::max(so_far.depth, found.depth);
    so_far.share = std::max(so_far.share, found.depth / wall);
  };
  include(deepest_node, seen.node);
  include(deepest_edge, seen.edge);
  if (seen.node.depth <= entered_depth(scene, state.glass.mesh) || seen.entered_tool >= 0) return;
  if (const auto face = entered_face(scene, state)) {
    seen.entered_tool = face->tool;
    seen.entered_boundary = face->boundary;
  }
}

std::string place_of_penetration(const Scene& scene, const Penetrated& seen) {
  const PenetrationPlace& place = seen.place;
  if (place.tool < 0) return "";
  const auto hundredths = [](double metres) {
    return std::round(1e5 * metres) / 100 + 0.0;
  };  // mm, no zero with a sign
  return fmt::format("the deepest, {:.3g} mm, in {} at (r, z) = ({:.2f}, {:.2f}) mm after {:.4g} s", 1e3 * seen.depth,
                     scene.tools[place.tool].name, hundredths(place.r), hundredths(place.z), place.time);
}

std::string entered_face_sentence(const Scene& scene, const GlassInTools& seen) {
  if (seen.entered_tool < 0) return "";
  const Tool& tool = scene.tools[seen.entered_tool];
  return fmt::format(
      "glass has entered tool {0} through its boundary {1}, which has no contact: only boundaries with condition = "
      "\"contact\" keep glass out. Where glass may touch {1}, give it that condition in the case; smaller steps or "
      "edges "
      "do not help",
      tool.name, tool.boundaries[seen.entered_boundary].name);
}

}  // namespace parison::forming
