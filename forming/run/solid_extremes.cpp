// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/solid_extremes.hpp"

#include <algorithm>
#include <cmath>

namespace parison::forming {

namespace {

Point in_plane(const core::Vector3& at) {
  return {std::hypot(at[0], at[1]), at[2]};
}

/// Keeps the time, s, of a step that ended beyond a limit.
void add_time_beyond(double time, double dt, Extreme& extreme) {
  if (!extreme.was_beyond()) extreme.first_beyond = time;
  extreme.seconds_beyond += dt;
}

/// The node of the contact surface that is hottest; -1 without one.
Index hottest_contact_node(const SolidTool& tool) {
  Index hottest = -1;
  for (const core::QuadFace& face : tool.mesh.faces)
    if (tool.mesh.boundaries[static_cast<std::size_t>(face.boundary_id)].kind == core::BoundaryKind::contact)
      for (const Index node : face.nodes)
        if (hottest < 0 || tool.temperature[node] > tool.temperature[hottest]) hottest = node;
  return hottest;
}

}  // namespace

void follow_extremes(const Scene& scene, const State& clock, const SolidState& solid, Extremes& extremes) {
  const Flags& flags = scene.output.flags;
  for (std::size_t t = 0; t < solid.tools.size(); ++t) {
    const SolidTool& tool = solid.tools[t];
    const Index node = hottest_contact_node(tool);
    if (node < 0) continue;
    Extreme& extreme = extremes.tools[static_cast<std::size_t>(tool.tool)];
    const double temperature = tool.temperature[node];
    if (!(temperature <= extreme.temperature))
      extreme.temperature = temperature, extreme.time = clock.time,
      extreme.at = in_plane(tool.mesh.nodes[static_cast<std::size_t>(node)]) +
                   clock.tools[static_cast<std::size_t>(tool.tool)].offset * core::axis_direction();
    const bool touched = std::any_of(
        solid.glass.contact.begin(), solid.glass.contact.end(),
        [&](const flow::SolidContact& point) { return point.touches && point.tool == static_cast<Index>(t); });
    if (touched && temperature > flags.tool_surface_above) add_time_beyond(clock.time, solid.last_step, extreme);
  }
  Eigen::Index coldest = 0;
  const double temperature = solid.glass.temperature.minCoeff(&coldest);
  if (!(temperature >= extremes.glass.temperature))
    extremes.glass.temperature = temperature, extremes.glass.time = clock.time,
    extremes.glass.at = in_plane(solid.glass.mesh.nodes[static_cast<std::size_t>(coldest)]);
  if (flags.glass_below && temperature < *flags.glass_below)
    add_time_beyond(clock.time, solid.last_step, extremes.glass);
}

}  // namespace parison::forming
