// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/contact/placed_tools.hpp"

namespace parison::forming {

namespace {

/// Penetrated nodes are moved to the surface over 20 ms; moving them within one step would overpressurise a full
/// cavity.
constexpr double recovery_time = 20e-3;

/// Fraction of a step during which a node is in contact, from its gap at the step's start and its displacement along
/// the tool's normal (negative towards the tool), both m.
double fraction_in_contact(double gap, double motion, double coincident) {
  if (gap <= coincident) return 1;
  return motion < 0 ? std::max(0.0, 1 + gap / motion) : 0;
}

/// The unit normal of the straight path of a node that touches a tool at both ends of it, on the side of the tool's
/// normals there; none where the node rests or the normal is not between these. On a smooth outline their mean is
/// perpendicular to the path up to third order and does not depend on how long the path is; a corner is passed on a
/// path of its own.
std::optional<Point> path_normal(const Point& path, const Point& at_start, const Point& at_end) {
  const double between = at_start.dot(at_end);
  if (between >= contact::smooth_cosine) return (at_start + at_end).normalized();
  if (path.isZero(0)) return std::nullopt;
  Point normal = Point(-path[1], path[0]).normalized();
  if (normal.dot(at_end) < 0) normal = -normal;
  if (!(normal.dot(at_end) >= between && normal.dot(at_start) >= between)) return std::nullopt;
  return normal;
}

/// The constraint of a node that touches the tool at the step's start as well, for its straight path relative to the
/// tool, m: with the normal of the path, so that the contact force does no work on a node that slides. With the normal
/// at the end the force would do work of first order in the step wherever the tool is curved.
contact::GapConstraint along_path(const contact::GapConstraint& at_end, const Point& path,
                                  const std::vector<contact::GapConstraint>& at_start) {
  const auto closeness = [&](const contact::GapConstraint& c) { return c.normal.dot(at_end.normal); };
  const auto start = std::max_element(at_start.begin(), at_start.end(),
                                      [&](const auto& a, const auto& b) { return closeness(a) < closeness(b); });
  if (start == at_start.end()) return at_end;
  const auto normal = path_normal(path, start->normal, at_end.normal);
  return normal ? contact::GapConstraint{at_end.gap / normal->dot(at_end.normal), *normal, at_end.segment} : at_end;
}

}  // namespace

std::vector<flow::ContactCandidate> contact_candidates(const Scene& scene, const State& state,
                                                       const Eigen::VectorXd& velocity, double dt) {
  const auto motions = tool_motions(scene, state, dt);
  std::vector<double> speed, offset;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    speed.push_back(motions[i].force ? state.tools[i].velocity : motions[i].velocity);
    offset.push_back(state.tools[i].offset + dt * speed.back());
  }
  const core::Mesh& glass = state.glass.mesh;
  const auto tools = active_tools(scene, state);
  const PlacedTools placed(scene, tools, offset);
  const Point axis = core::axis_direction();
  std::vector<flow::ContactCandidate> candidates;
  const auto may_touch = touching_nodes(glass);
  for (const Index node : surface_nodes(glass)) {
    if (!may_touch[node]) continue;
    const Point v = flow::node_velocity(velocity, node);
    double fastest = v.norm();
    for (const Index tool : tools)
      fastest = std::max({fastest, std::abs(speed[tool]), motions[tool].force ? motions[tool].speed_limit : 0.0});
    const Point reached = glass.nodes[node] + dt * v;
    for (const auto& [tool, at_end] : node_constraints(placed, reached, placed.near + 2 * dt * fastest)) {
      const Point relative = v - speed[tool] * axis;
      const bool touched = state.glass.contact_tool[node] == tool;
      const auto constraint =
          touched ? along_path(at_end, dt * relative, placed.touched(state, tool, glass.nodes[node])) : at_end;
      const double approach = constraint.normal.dot(relative);
      const double gap = constraint.gap - dt * approach;  // at the step's start
      // Glass that is drawn on a tool that grips is held from the run's first step, whichever way it is pulled.
      const bool drawn_on = state.totals.steps == 0 && std::abs(gap) <= placed.coincident;
      const bool tied = (touched || drawn_on) && scene.tools[tool].friction.law == flow::Friction::Law::grip;
      // Only a node that penetrates at the step's start may still penetrate at its end. The depth is measured anew
      // there, because next to a corner the linearised gap can be negative for a node that is outside; but a wall that
      // is extended past a joint has no tool behind it.
      const bool extended = at_end.segment < 0;
      const double depth = gap >= 0 ? 0.0 : extended ? -gap : placed.depth_inside(state, tool, glass.nodes[node]);
      const double kept = depth - std::max(0.0, depth - placed.resting) * std::min(1.0, dt / recovery_time);
      const double rate = tied ? 0.0 : (-gap - kept) / dt;
      const double fraction = touched ? 1 : fraction_in_contact(gap, dt * approach, placed.coincident);
      candidates.push_back({node, tool, constraint.normal, rate, tied, fraction, relative, (depth - kept) / dt});
    }
  }
  return candidates;
}

}  // namespace parison::forming
