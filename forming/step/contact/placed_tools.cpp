// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/contact/placed_tools.hpp"

#include "core/mesh/tolerances.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/contact_geometry.hpp"

namespace parison::forming {

using core::dim;

PlacedTools::PlacedTools(const Scene& scene, const std::vector<Index>& active_tools, const std::vector<double>& offset)
    : near(core::tolerance::contact_proximity * core::size(scene.glass.profile)),
      coincident(core::tolerance::coincident * core::size(scene.glass.profile)),
      resting(core::tolerance::penetration * core::size(scene.glass.profile)),
      at_tool(core::tolerance::at_tool * core::size(scene.glass.profile)) {
  std::vector<contact::PlacedTool> placed;
  for (const Index tool : active_tools) {
    const auto& profile = scene.tools[tool].profile;
    const auto boundaries = contact_boundaries(scene.tools[tool]);
    tools.push_back(
        {tool, &profile, offset[tool] * core::axis_direction(), {profile, boundaries}, {profile, boundaries}});
    placed.push_back({&profile, boundaries, offset[tool]});
  }
  joints = contact::tool_joints(placed);
  t_junctions = contact::tool_t_junctions(placed);
}

std::vector<contact::GapConstraint> PlacedTools::touched(const State& state, Index tool, const Point& x) const {
  auto found = of(tool).constraints(x - state.tools[tool].offset * core::axis_direction(), near);
  const double closest = found.empty() ? 0 : found.front().gap;
  found.erase(std::remove_if(found.begin(), found.end(), [&](const auto& c) { return c.gap > closest + resting; }),
              found.end());
  return found;
}

double PlacedTools::depth_inside(const State& state, Index tool, const Point& x) const {
  return std::max(0.0, -of(tool).gap(x - state.tools[tool].offset * core::axis_direction()));
}

std::vector<Index> active_tools(const Scene& scene, const State& state) {
  std::vector<Index> tools;
  for (const auto& tool : scene.stages[state.stage].tools) tools.push_back(tool.tool);
  return tools;
}

PlacedTools placed_tools(const Scene& scene, const State& state) {
  std::vector<double> offset;
  for (const ToolState& tool : state.tools) offset.push_back(tool.offset);
  return {scene, active_tools(scene, state), offset};
}

std::vector<ToolConstraint> node_constraints(const PlacedTools& tools, const Point& x, double reach) {
  std::vector<ToolConstraint> found;
  for (const auto& tool : tools.tools)
    for (const auto& constraint : tool.constraints(x - tool.shift, reach)) found.push_back({tool.index, constraint});
  for (const auto& joint : tools.joints)
    for (const auto& [tool, constraint] : contact::joint_constraints(joint, x, reach))
      found.push_back({tools.tools[tool].index, constraint});
  for (const auto& t_junction : tools.t_junctions)
    if (const auto beyond = contact::t_junction_constraint(t_junction, x, std::min(reach, tools.near)))
      found.push_back({tools.tools[beyond->tool].index, beyond->constraint});
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.constraint.gap < b.constraint.gap; });
  std::vector<ToolConstraint> kept;
  for (const auto& candidate : found) {
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const auto& have) {
      return have.constraint.normal.dot(candidate.constraint.normal) > same_direction;
    });
    if (!known && kept.size() < dim) kept.push_back(candidate);
  }
  return kept;
}

}  // namespace parison::forming
