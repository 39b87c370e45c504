// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/contact/contact_prediction.hpp"

#include <algorithm>

#include "core/mesh/tolerances.hpp"
#include "forming/step/contact/contact_geometry.hpp"

namespace parison::forming {

using core::dim;

namespace {

bool is_at_corner(const Scene& scene, const State& state, Index tool, Index node) {
  const Point local = state.glass.mesh.nodes[node] - state.tools[tool].offset * core::axis_direction();
  const auto& segments = scene.tools[tool].profile.segments;
  const double at_corner = core::tolerance::junction * core::size(scene.glass.profile);
  return std::any_of(segments.begin(), segments.end(),
                     [&](const core::Segment& segment) { return (segment.end - local).norm() < at_corner; });
}

}  // namespace

std::vector<bool> likely_contacts(const State& state, const ActiveContacts& active, const flow::Problem& problem,
                                  const Eigen::VectorXd& guess) {
  constexpr double near_direction = 0.94;
  std::vector<std::vector<std::size_t>> of_node(problem.mesh->nodes.size());
  for (std::size_t i = 0; i < active.node.size(); ++i) of_node[active.node[i]].push_back(i);
  std::vector<bool> likely;
  Index last_node = -1;
  for (const auto& candidate : problem.candidates) {
    const auto& known = of_node[candidate.node];
    bool was = std::any_of(known.begin(), known.end(), [&](std::size_t i) {
      return active.tool[i] == candidate.tool && active.normal[i].dot(candidate.normal) > near_direction;
    });
    if (active.node.empty())
      was = (state.glass.contact_tool[candidate.node] == candidate.tool && candidate.node != last_node) ||
            (state.last_step == 0 && candidate.rate >= 0);
    if (candidate.tied && candidate.rate < 0) was = false;  // has come off and is held by the form of the tool alone
    const double tool_speed = state.tools[candidate.tool].velocity;
    const Point relative = flow::node_velocity(guess, candidate.node) - tool_speed * core::axis_direction();
    likely.push_back(was || (state.last_step > 0 && candidate.normal.dot(relative) < candidate.rate));
    last_node = candidate.node;
  }
  return likely;
}

void keep_bounds(const std::vector<flow::ContactCandidate>& bounds, std::vector<flow::ContactCandidate>& candidates) {
  for (const auto& bound : bounds) {
    const auto of_node = [&](const auto& c) { return c.node == bound.node; };
    const auto first = std::find_if(candidates.begin(), candidates.end(), of_node);
    const auto last = std::find_if_not(first, candidates.end(), of_node);
    if (std::none_of(first, last, [&](const auto& c) { return c.normal.dot(bound.normal) > same_direction; }))
      candidates.insert(last, bound);
  }
}

std::vector<flow::ContactCandidate> corner_bounds(const Scene& scene, const State& state) {
  const auto& [nodes, tools, normals] = state.glass.active_contacts;
  std::vector<flow::ContactCandidate> bounds;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (nodes[i] != nodes[i - 1] || tools[i] != tools[i - 1] || !is_at_corner(scene, state, tools[i], nodes[i]))
      continue;
    for (const std::size_t k : {i - 1, i})
      bounds.push_back({nodes[k], tools[k], normals[k], 0.0, false, 1.0, Point::Zero()});
  }
  return bounds;
}

}  // namespace parison::forming
