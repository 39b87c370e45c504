// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/room_in_tool.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "forming/scene/container/crossings.hpp"
#include "forming/step/contact/contact_geometry.hpp"

namespace parison::forming {
namespace {

/// The way along a line from a place on it to the boundary of a tool that it meets first; infinite where it meets none,
/// or one without contact, as in the bore of a plunger.
double first_contact(const std::vector<Crossing>& crossings, double from, double direction) {
  double nearest = std::numeric_limits<double>::infinity();
  bool meets_contact = false;
  for (const Crossing& crossing : crossings)
    if (const double way = direction * (crossing.at - from); way >= 0 && way < nearest) {
      nearest = way;
      meets_contact = crossing.contact;
    }
  return meets_contact ? nearest : std::numeric_limits<double>::infinity();
}

template <typename Add>
std::vector<Crossing> crossings_of(const Tool& tool, const Add& add) {
  std::vector<Crossing> crossings;
  for (const core::Segment& segment : tool.profile.segments)
    add(segment, tool.boundaries[segment.boundary_id].kind == BoundaryKind::contact, crossings);
  return crossings;
}

}  // namespace

ExcessSize excess_size(const Scene& scene, const State& state, Index tool) {
  ExcessSize excess;
  if (scene.geometry != core::Geometry::axisymmetric) return excess;
  const Tool& around = scene.tools[tool];
  const double offset = state.tools[tool].offset, beside_axis = 1e-3 * core::size(around.profile);
  const core::Mesh& mesh = state.glass.mesh;
  struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void include(double z) { low = std::min(low, z), high = std::max(high, z); }
  } all, on_axis;
  for (const Point& x : mesh.nodes) {
    all.include(x[1] - offset);
    if (x[0] < beside_axis) on_axis.include(x[1] - offset);
  }
  const double middle = 0.5 * (all.low + all.high);
  const auto is_in_tool = [&](double z) { return core::contains(around.profile, Point(beside_axis, z)); };
  const auto along = crossings_of(around, [&](const auto& segment, bool contact, auto& found) {
    add_crossings_along(segment, beside_axis, contact, found);
  });
  for (const double direction : {1.0, -1.0}) {
    const double end = direction > 0 ? on_axis.high - middle : middle - on_axis.low;
    const double length = end - first_contact(along, middle, direction);
    if (length > excess.length && !is_in_tool(middle)) excess = {length, true, 0};
  }
  for (const Index node : surface_nodes(mesh)) {
    const Point x = mesh.nodes[node] - offset * core::axis_direction();
    const auto across = crossings_of(
        around, [&](const auto& segment, bool contact, auto& found) { add_crossings(segment, x[1], contact, found); });
    // A tool that fills the axis, as a plunger or a push-up does, has no room around it at that height.
    if (const double more = x[0] - first_contact(across, 0, 1); more > excess.length && !is_in_tool(x[1]))
      excess = {more, false, mesh.nodes[node][1]};
  }
  return excess;
}

std::string describe(const ExcessSize& excess, const std::string& tool) {
  return excess.along_axis
             ? fmt::format("{:.3g} mm longer than {}", 1e3 * excess.length, tool)
             : fmt::format("{:.3g} mm wider than {} at z = {:.4g} mm", 1e3 * excess.length, tool, 1e3 * excess.z);
}

std::string outgrown_tool(const Scene& scene, const State& state) {
  if (state.stage + 1 >= static_cast<Index>(scene.stages.size())) return "";
  const Stage &now = scene.stages[state.stage], &next = scene.stages[state.stage + 1];
  for (const StageTool& place : next.tools) {
    if (now.uses(place.tool)) continue;
    const ExcessSize excess = excess_size(scene, state, place.tool);
    if (excess.length > outgrown_from * core::size(scene.glass.profile))
      return fmt::format(
          "the glass hangs {}, which comes in stage {}: less time or colder glass before, or a larger tool, let it fit",
          describe(excess, scene.tools[place.tool].name), next.name);
  }
  return "";
}

}  // namespace parison::forming
