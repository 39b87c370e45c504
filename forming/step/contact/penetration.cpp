// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/contact/penetration.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/unilateral/tool_gap.hpp"
#include "core/mesh/element.hpp"
#include "core/mesh/profile.hpp"
#include "core/mesh/tolerances.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/contact/placed_tools.hpp"

namespace parison::forming {

std::vector<Penetration> penetrations(const Scene& scene, const State& state, double ahead) {
  std::vector<Penetration> found;
  const core::Mesh& glass = state.glass.mesh;
  const auto surface = surface_nodes(glass);
  for (const Index tool : active_tools(scene, state)) {
    const auto& profile = scene.tools[tool].profile;
    const contact::ToolGap gap(profile, contact_boundaries(scene.tools[tool]));
    const ToolState& body = state.tools[tool];
    const Point moved = (body.offset + ahead * body.velocity) * core::axis_direction();
    for (const Index node : surface) {
      Point local = glass.nodes[node] - moved;
      if (ahead > 0 && scene.has_flow()) local += ahead * flow::node_velocity(state.glass.velocity, node);
      const double depth = core::contains(profile, local) ? -gap(local) : 0;
      if (depth > 0 && std::isfinite(depth)) found.push_back({node, tool, depth});
    }
  }
  return found;
}

std::vector<double> places_on(const std::array<Point, 3>& edge, const core::Profile& outline) {
  constexpr double beside = 0.25;  // of the edge
  std::vector<double> places(edge_eighths.begin(), edge_eighths.end());
  const Point along = edge[1] - edge[0];
  const double square = along.squaredNorm();
  for (const core::Segment& segment : outline.segments) {
    const Point arm = segment.end - edge[0];
    const double s = arm.dot(along) / square;
    if (s > 0 && s < 1 && (arm - s * along).squaredNorm() < beside * beside * square) places.push_back(s);
  }
  return places;
}

namespace {

/// By boundary: whether it is a face of the tool, through which it can be entered.
std::vector<bool> faces(const Body& body) {
  std::vector<bool> is_face;
  for (const Boundary& boundary : body.boundaries) is_face.push_back(boundary.kind != BoundaryKind::symmetry);
  return is_face;
}

/// The depth of glass at x in a tool that is moved by `offset`, if it is more than that of `deepest`.
void deepen(const contact::ToolGap& gap, Index tool, const Point& x, const Point& offset, std::size_t& closest,
            Depth& deepest) {
  const double depth = gap.deepest(x - offset, deepest.depth, closest);
  if (depth > deepest.depth) deepest = {depth, tool, x};
}

}  // namespace

Depth deepest_node(const Scene& scene, const State& state, double known) {
  const core::Mesh& glass = state.glass.mesh;
  const auto surface = surface_nodes(glass);
  Depth deepest{known};
  for (const Index tool : active_tools(scene, state)) {
    const contact::ToolGap gap(scene.tools[tool].profile, faces(scene.tools[tool]));
    const Point offset = state.tools[tool].offset * core::axis_direction();
    std::size_t closest = 0;
    for (const Index node : surface) deepen(gap, tool, glass.nodes[node], offset, closest, deepest);
  }
  return deepest;
}

namespace {

/// The deepest place of an edge behind the boundaries that `measured` gives of a tool.
template <typename Measured>
Depth deepest_edge(const Scene& scene, const State& state, double known, const Measured& measured) {
  const core::Mesh& mesh = state.glass.mesh;
  Depth deepest{known};
  for (const Index tool : active_tools(scene, state)) {
    const contact::ToolGap gap(scene.tools[tool].profile, measured(scene.tools[tool]));
    const Point offset = state.tools[tool].offset * core::axis_direction();
    std::size_t closest = 0;
    for (const auto& edge : mesh.boundary_edges()) {
      if (mesh.kind_of(edge) != BoundaryKind::contact) continue;
      const bool near = std::any_of(edge.nodes.begin(), edge.nodes.end(),
                                    [&](Index node) { return state.glass.contact_tool[node] == tool; });
      if (!near) continue;
      std::array<Point, 3> local;
      for (int i = 0; i < 3; ++i) local[i] = mesh.nodes[edge.nodes[i]] - offset;
      for (const double s : places_on(local, scene.tools[tool].profile)) {
        const auto n = core::edge_shape(s);
        const Point x = n[0] * local[0] + n[1] * local[1] + n[2] * local[2];
        deepen(gap, tool, x + offset, offset, closest, deepest);
      }
    }
  }
  return deepest;
}

}  // namespace

Depth deepest_edge(const Scene& scene, const State& state, double known) {
  return deepest_edge(scene, state, known, faces);
}

double edge_depth_gained(const Scene& scene, const State& before, const State& after) {
  // An edge may stay as deep as a node at the tool, or as its ends, which a step may leave a little deeper.
  const double size = core::size(scene.glass.profile), step = core::tolerance::penetration * size;
  const double at_tool = core::tolerance::at_tool * size, left = at_tool + step;
  const auto behind = [](const Tool& tool) { return contact_boundaries(tool); };
  const double depth = deepest_edge(scene, after, left, behind).depth;
  return depth > left && depth > deepest_edge(scene, before, at_tool, behind).depth + step ? depth : 0;
}

std::string end_of_contact(const Scene& scene, const State& state, Index cell) {
  const double near = core::tolerance::junction * core::size(scene.glass.profile);
  const core::Mesh& glass = state.glass.mesh;
  for (const Index tool : active_tools(scene, state)) {
    const Tool& body = scene.tools[tool];
    const Point offset = state.tools[tool].offset * core::axis_direction();
    for (const Index node : glass.cells()[cell]) {
      const Boundary *touching = nullptr, *free = nullptr;
      for (const core::Segment& segment : body.profile.segments) {
        const Point local = glass.nodes[node] - offset;
        if (std::min((segment.start - local).norm(), (segment.end - local).norm()) > near) continue;
        const Boundary& boundary = body.boundaries[segment.boundary_id];
        if (boundary.kind != BoundaryKind::symmetry)
          (boundary.kind == BoundaryKind::contact ? touching : free) = &boundary;
      }
      if (touching && free)
        return fmt::format(", where contact boundary {} of {} ends at its boundary {}, which has no contact",
                           touching->name, body.name, free->name);
    }
  }
  return "";
}

}  // namespace parison::forming
