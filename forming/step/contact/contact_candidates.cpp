// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "forming/flow/contact/grip.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/contact/edge_constraints.hpp"
#include "forming/step/contact/first_touch.hpp"
#include "forming/step/contact/placed_tools.hpp"

namespace parison::forming {

namespace {

/// Time over which a penetrated node is moved to the surface, s: 20 ms, since moving it within one step would
/// overpressurise a full cavity, and where the glass is stiff its viscosity over 1 MPa: a place that is 2 % of an edge
/// deep is pushed out with some 0.2 bar however stiff the glass is.
double recovery_time(const Scene& scene, const State& state, Index node) {
  constexpr double shortest = 20e-3, stress_per_strain = 1e6;
  const auto& temperature = state.glass.temperature;
  const double here = temperature.size() > 0 ? temperature[node] : scene.glass.initial_temperature;
  return std::max(shortest, scene.glass.flow->viscosity(here) / stress_per_strain);
}

/// Cosine of the turn of a tool, 45 degrees, over which the middle of an edge that lies over it is lifted; round a
/// sharper corner it would be lifted by a good part of the edge, and a new mesh has a node at the corner.
constexpr double gentle_turn = 0.7071;

/// Least cosine between the normal of a path round a corner and the normals of the tool there: 84 degrees.
constexpr double steep = 0.1;

/// Fraction of a step during which a node is in contact, from its gap at the step's start and its displacement along
/// the tool's normal (negative towards the tool), both m.
double fraction_in_contact(double gap, double motion, double coincident) {
  if (gap <= coincident) return 1;
  return motion < 0 ? std::max(0.0, 1 + gap / motion) : 0;
}

/// The unit normal of the straight path of a node that touches a tool at both ends of it, on the side of the tool's
/// normals there; none where the node rests or the normal is not between these. On a smooth outline their mean is
/// perpendicular to the path up to third order and does not depend on how long the path is; a corner is passed on a
/// path of its own. None either where the path does not come to the other face, `gap_at_end`, m, or stays on the face
/// touched at the start: the other is one ahead in a re-entrant corner, where both bound the node and a normal between
/// them, next to that of one, would wedge it. None where the path is nearly perpendicular to a face: along its normal
/// the gap would be many times as large, up to infinity.
std::optional<Point> path_normal(const Point& path, const Point& at_start, const Point& at_end, double gap_at_end) {
  const double between = at_start.dot(at_end);
  if (between >= contact::smooth_cosine) return (at_start + at_end).normalized();
  if (std::abs(gap_at_end) > path.norm()) return std::nullopt;
  Point normal = Point(-path[1], path[0]).normalized();
  if (normal.dot(at_end) < 0) normal = -normal;
  if (normal.dot(at_start) > same_direction) return std::nullopt;
  const double least = std::max(between, steep);
  if (!(normal.dot(at_end) >= least && normal.dot(at_start) >= least)) return std::nullopt;
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
  const auto normal = path_normal(path, start->normal, at_end.normal, at_end.gap);
  return normal ? contact::GapConstraint{at_end.gap / normal->dot(at_end.normal), *normal, at_end.segment} : at_end;
}

/// The active contacts of each node.
struct ContactsOfNodes {
  std::vector<Index> first;  ///< of each node, -1 where there is none
  std::vector<Index> next;   ///< of the same node after each contact, -1 after its last
  ContactsOfNodes(const ActiveContacts& contacts, Index node_count)
      : first(node_count, -1), next(contacts.node.size(), -1) {
    for (auto i = static_cast<Index>(next.size()) - 1; i >= 0; --i) {
      next[i] = first[contacts.node[i]];
      first[contacts.node[i]] = i;
    }
  }
};

/// A step that is predicted: the velocities (core::dim per node, m/s; the tools' along the axis), with the tools placed
/// where they end.
struct StepPath {
  const Scene& scene;
  const State& state;
  const PlacedTools& placed;
  const Eigen::VectorXd& velocity;
  const std::vector<double>& tool_speed;
  const std::vector<bool>& driven;  ///< by force
  double dt;
  ContactsOfNodes contacts;

  bool touches(Index tool, Index node) const { return state.glass.contact_tool[node] == tool; }
  /// The normal with which a node touches a tool, null where it does not. A node in a corner may touch two tools.
  const Point* normal_of_contact(Index tool, Index node) const {
    for (Index i = contacts.first[node]; i >= 0; i = contacts.next[i])
      if (state.glass.active_contacts.tool[i] == tool) return &state.glass.active_contacts.normal[i];
    return nullptr;
  }
  /// Whether both ends of an edge touch a tool that bulges gently between them.
  bool lies_over(Index tool, const core::BoundaryEdge& edge) const {
    const Point *first = normal_of_contact(tool, edge.nodes[0]), *last = normal_of_contact(tool, edge.nodes[1]);
    const auto& x = state.glass.mesh.nodes;
    return first && last && first->dot(*last) > gentle_turn &&
           (*last - *first).dot(x[edge.nodes[1]] - x[edge.nodes[0]]) > 0;
  }
  Point end_of(Index node) const { return state.glass.mesh.nodes[node] + dt * flow::node_velocity(velocity, node); }

  /// First, last and middle node of an edge at the step's end.
  std::array<Point, 3> end_of(const core::BoundaryEdge& edge) const {
    return {end_of(edge.nodes[0]), end_of(edge.nodes[1]), end_of(edge.nodes[2])};
  }
};

/// A constraint of a node at the end of a step.
struct Bound {
  Index tool;
  contact::GapConstraint at_end;
  double clearance = 0;    ///< gap that a middle node keeps so that its edge stays out of the tool, m
  double held = 0;         ///< the same with corners of the tool, which it keeps once it has it, m
  bool lies_over = false;  ///< the edge lies over a corner or a rounding of the tool, which both ends touch
  bool of_edge = false;    ///< the tool is met by another point of the node's edge
};

/// The edge of each middle node that may touch, null at all other nodes.
std::vector<const core::BoundaryEdge*> edges_of_middles(const core::Mesh& glass) {
  std::vector<const core::BoundaryEdge*> edge_of(glass.nodes.size(), nullptr);
  for (const auto& edge : glass.boundary_edges())
    if (glass.kind_of(edge) == BoundaryKind::contact) edge_of[edge.nodes[2]] = &edge;
  return edge_of;
}

/// A box that contains a quadratic edge of first, last and middle node: that of its control polygon.
contact::Box box_around(const std::array<Point, 3>& edge, const Point& shift) {
  const Point control = 2 * edge[2] - 0.5 * (edge[0] + edge[1]);
  return {edge[0].cwiseMin(edge[1]).cwiseMin(control) - shift, edge[0].cwiseMax(edge[1]).cwiseMax(control) - shift};
}

/// The constraints of a node, at most core::dim; a middle node has those of its `edge` (null at a vertex) as well.
std::vector<Bound> bounds_of_node(const StepPath& step, Index node, const core::BoundaryEdge* edge, double reach) {
  std::vector<Bound> bounds;
  for (const auto& [tool, constraint] : node_constraints(step.placed, step.end_of(node), reach))
    bounds.push_back({tool, constraint});
  if (!edge) return bounds;
  for (const auto& tool : step.placed.tools) {
    const std::array<Point, 3> beside = step.end_of(*edge);
    if (tool.constraints.is_beyond(box_around(beside, tool.shift), reach)) continue;
    const auto [constraint, corner] = edge_constraints(tool, beside);
    if (!constraint) continue;
    const auto same = std::find_if(bounds.begin(), bounds.end(), [&](const Bound& bound) {
      return bound.tool == tool.index && bound.at_end.normal.dot(constraint->normal) > contact::smooth_cosine;
    });
    if (same != bounds.end()) {
      same->clearance = std::max(0.0, same->at_end.gap - constraint->gap - step.placed.resting);
      same->lies_over = step.lies_over(tool.index, *edge);
      same->held = std::max(0.0, same->at_end.gap - corner->gap - step.placed.resting);
    } else if (bounds.size() < core::dim && constraint->gap <= reach) {
      bounds.push_back({tool.index, *constraint});
      bounds.back().of_edge = true;
      bounds.back().lies_over = step.lies_over(tool.index, *edge);
    }
  }
  return bounds;
}

/// Whether the face of a constraint, in which a node would be at the step's end, is one that it does not pass on its
/// way: it would come into the tool through another face, which is not a contact face. The plane of the face lies
/// farther behind the node at the step's start than the way is long, and the node is outside there.
bool comes_through_another_face(const StepPath& step, Index node, const Bound& bound) {
  if (bound.at_end.gap >= 0 || bound.at_end.segment < 0 || bound.of_edge) return false;
  const Point& x = step.state.glass.mesh.nodes[node];
  const Point way = step.end_of(node) - x - step.dt * step.tool_speed[bound.tool] * core::axis_direction();
  return bound.at_end.gap - bound.at_end.normal.dot(way) < -way.norm() - step.placed.resting &&
         step.placed.depth_inside(step.state, bound.tool, x) == 0;
}

flow::ContactCandidate candidate_of(const StepPath& step, Index node, const Bound& bound) {
  const auto& [scene, state, placed, velocity, tool_speed, driven, dt, contacts] = step;
  const Index tool = bound.tool;
  const Point& x = state.glass.mesh.nodes[node];
  const Point relative = flow::node_velocity(velocity, node) - tool_speed[tool] * core::axis_direction();
  const bool touched = step.touches(tool, node);
  const auto constraint = touched && !bound.of_edge
                              ? along_path(bound.at_end, dt * relative, placed.touched(state, tool, x))
                              : bound.at_end;
  const double approach = constraint.normal.dot(relative);
  const double gap = constraint.gap - dt * approach;  // at the step's start
  // The middle of an edge that begins to leave the tool leaves it by itself; one that was moved out of it stays out.
  const double held = std::min(bound.held, std::max(0.0, gap));
  const double clearance = touched ? std::max(bound.lies_over ? bound.clearance : 0.0, held) : bound.clearance;
  // Glass that is drawn on a tool that grips is held from the run's first step, whichever way it is pulled.
  const bool drawn_on = state.totals.steps == 0 && std::abs(gap) <= placed.coincident;
  const bool grips = scene.tools[tool].friction.law == flow::Friction::Law::grip;
  // A middle is not held where the end of its edge has left the tool so far that the edge between would enter it.
  const bool peels = bound.clearance > placed.resting && !bound.lies_over;
  const double closed = std::max(bound.clearance, clearance) + placed.at_tool;
  const double holds = driven[tool] ? closed : std::max(closed, depth_of_form(scene));
  const bool tied = (drawn_on || (touched && !peels && gap <= holds)) && grips;
  // Only a node that penetrates at the step's start may still penetrate at its end. The depth is measured anew there,
  // because next to a corner the linearised gap can be negative for a node that is outside; but a wall that is extended
  // past a joint has no tool behind it.
  const bool extended = bound.at_end.segment < 0 || bound.of_edge;
  const double inside = gap >= 0 ? 0.0 : extended ? -gap : placed.depth_inside(state, tool, x);
  const double depth = gap >= 0 ? std::max(0.0, clearance - gap) : inside + clearance;
  const double share = bound.of_edge && !bound.lies_over ? 0 : std::min(1.0, dt / recovery_time(scene, state, node));
  const double kept = depth - share * std::max(0.0, depth - placed.resting);
  const bool closes = !tied || gap > closed;
  const double rate = closes ? (clearance - gap - kept) / dt : 0.0;
  const double fraction = touched ? 1 : fraction_in_contact(gap - clearance, dt * approach, placed.coincident);
  return {node, tool, constraint.normal, rate, tied, fraction, relative, closes ? (depth - kept) / dt : 0.0};
}

}  // namespace

double depth_of_form(const Scene& scene) {
  return flow::depth_of_form * core::size(scene.glass.profile);
}

std::vector<flow::ContactCandidate> contact_candidates(const Scene& scene, const State& state,
                                                       const Eigen::VectorXd& velocity, double dt) {
  const auto motions = tool_motions(scene, state, dt);
  std::vector<double> speed, offset;
  std::vector<bool> driven;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    speed.push_back(motions[i].velocity);
    offset.push_back(state.tools[i].offset);
    driven.push_back(motions[i].force.has_value());
  }
  for (const StageTool& tool : scene.stages[state.stage].tools) {
    if (motions[tool.tool].force) speed[tool.tool] = predicted_speed(scene, state, tool, velocity, dt);
    offset[tool.tool] += dt * speed[tool.tool];
  }
  const core::Mesh& glass = state.glass.mesh;
  const auto tools = active_tools(scene, state);
  const PlacedTools placed(scene, tools, offset);
  const StepPath step{scene, state,  placed, velocity,
                      speed, driven, dt,     {state.glass.active_contacts, glass.node_count()}};
  std::vector<flow::ContactCandidate> candidates;
  const auto may_touch = touching_nodes(glass);
  const auto edge_of = edges_of_middles(glass);
  for (const Index node : surface_nodes(glass)) {
    if (!may_touch[node]) continue;
    double fastest = flow::node_velocity(velocity, node).norm();
    for (const Index tool : tools)
      fastest = std::max({fastest, std::abs(speed[tool]), motions[tool].force ? motions[tool].speed_limit : 0.0});
    const double reach = placed.near + 2 * dt * fastest;
    for (const Bound& bound : bounds_of_node(step, node, edge_of[node], reach))
      if (!comes_through_another_face(step, node, bound)) candidates.push_back(candidate_of(step, node, bound));
  }
  return candidates;
}

}  // namespace parison::forming
