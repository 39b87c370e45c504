// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/contact/contact_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "contact/unilateral/tool_constraints.hpp"
#include "contact/unilateral/tool_gap.hpp"
#include "contact/unilateral/tool_junction.hpp"
#include "core/mesh/element.hpp"
#include "core/mesh/profile.hpp"
#include "core/mesh/tolerances.hpp"
#include "forming/state/initial_state.hpp"
#include "remesh/surface/outline.hpp"

namespace parison::forming {

using core::dim;

namespace {

/// Penetrated nodes are moved to the surface over 20 ms; moving them within one step would overpressurise a full
/// cavity.
constexpr double recovery_time = 20e-3;

struct ToolConstraint {
  Index tool;
  contact::GapConstraint constraint;
};

/// The active tools at the offsets given (m, one for each tool of the scene), and the junctions where they meet.
struct PlacedTools {
  struct Tool {
    Index index;
    const core::Profile* profile;
    Point shift;
    contact::ToolConstraints constraints;
    contact::ToolGap gap;
  };
  std::vector<Tool> tools;
  std::vector<contact::ToolJoint> joints;
  std::vector<contact::ToolTJunction> t_junctions;
  double near;  ///< nodes farther away, m, become contact candidates only if they can move that far within the step
  double coincident;  ///< gap below which a node is in contact from the start of the step, m
  double resting;     ///< depth, m, that a node keeps

  const Tool& of(Index index) const {
    return *std::find_if(tools.begin(), tools.end(), [&](const Tool& tool) { return tool.index == index; });
  }

  /// The constraints of one tool that a point touches at the tool's position in `state`.
  std::vector<contact::GapConstraint> touched(const State& state, Index tool, const Point& x) const {
    auto found = of(tool).constraints(x - state.tools[tool].offset * core::axis_direction(), near);
    const double closest = found.empty() ? 0 : found.front().gap;
    found.erase(std::remove_if(found.begin(), found.end(), [&](const auto& c) { return c.gap > closest + resting; }),
                found.end());
    return found;
  }

  PlacedTools(const Scene& scene, const std::vector<Index>& active_tools, const std::vector<double>& offset)
      : near(core::tolerance::contact_proximity * core::size(scene.glass.profile)),
        coincident(core::tolerance::coincident * core::size(scene.glass.profile)),
        resting(core::tolerance::penetration * core::size(scene.glass.profile)) {
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
};

/// The constraints of a node with the smallest gaps, at most core::dim. The glass sees the union of the active tools,
/// so constraints of different tools with nearly the same normal count once.
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

/// Penetration depth of a point in a tool at its position in `state`, m; 0 outside.
double depth_inside(const PlacedTools& tools, const State& state, Index tool, const Point& x) {
  return std::max(0.0, -tools.of(tool).gap(x - state.tools[tool].offset * core::axis_direction()));
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

/// The projection of a point onto the surface of the tools that contain it; points outside all tools are returned as
/// they are.
Point projected_out(const PlacedTools& tools, const Point& x) {
  Point out = x;
  for (const auto& [tool, constraint] : node_constraints(tools, x, tools.near))
    if (constraint.gap < 0) out -= constraint.gap * constraint.normal;
  return out;
}

}  // namespace

std::vector<Index> surface_nodes(const core::Mesh& mesh) {
  std::vector<bool> seen(mesh.nodes.size(), false);
  std::vector<Index> nodes;
  for (const auto& edge : mesh.boundary_edges())
    for (const Index node : {edge.nodes[0], edge.nodes[2], edge.nodes[1]})
      if (!seen[node]) {
        seen[node] = true;
        nodes.push_back(node);
      }
  return nodes;
}

std::vector<flow::ToolMotion> tool_motions(const Scene& scene, const State& state, double dt) {
  std::vector<flow::ToolMotion> motions(scene.tools.size());
  for (std::size_t i = 0; i < motions.size(); ++i) motions[i].friction = scene.tools[i].friction;
  for (const auto& tool : scene.stages[state.stage].tools) {
    auto& motion = motions[tool.tool];
    if (const auto* position = std::get_if<PositionMotion>(&tool.motion))
      motion.velocity = (position->offset(state.stage_time + dt) - state.tools[tool.tool].offset) / dt;
    if (const auto* force = std::get_if<ForceMotion>(&tool.motion)) {
      motion.force = force->force.mean(state.stage_time, state.stage_time + dt);
      motion.speed_limit = force->speed_limit.mean(state.stage_time, state.stage_time + dt);
    }
  }
  return motions;
}

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
      const double depth = gap >= 0 ? 0.0 : extended ? -gap : depth_inside(placed, state, tool, glass.nodes[node]);
      const double kept = depth - std::max(0.0, depth - placed.resting) * std::min(1.0, dt / recovery_time);
      const double rate = tied ? 0.0 : (-gap - kept) / dt;
      const double fraction = touched ? 1 : fraction_in_contact(gap, dt * approach, placed.coincident);
      candidates.push_back({node, tool, constraint.normal, rate, tied, fraction, relative, (depth - kept) / dt});
    }
  }
  return candidates;
}

std::vector<bool> touching_nodes(const core::Mesh& glass) {
  std::vector<bool> flags(glass.nodes.size(), false);
  for (const Index node : contact_nodes(glass)) flags[node] = true;
  return flags;
}

std::vector<Index> contact_nodes(const core::Mesh& glass) {
  std::vector<char> seen(glass.nodes.size(), 0);
  std::vector<Index> nodes;
  nodes.reserve(3 * glass.boundary_edges().size());
  for (const auto& edge : glass.boundary_edges())
    if (glass.kind_of(edge) == BoundaryKind::contact)
      for (const Index node : edge.nodes)
        if (!std::exchange(seen[node], 1)) nodes.push_back(node);
  return nodes;
}

Eigen::VectorXd tool_gaps(const Scene& scene, const State& state, const std::vector<Index>& nodes, Index tool,
                          double reach) {
  const Body& body = scene.tools[tool];
  const core::Mesh& glass = state.glass.mesh;
  const Point displacement = state.tools[tool].offset * core::axis_direction();
  Eigen::VectorXd gaps = Eigen::VectorXd::Constant(glass.node_count(), std::numeric_limits<double>::infinity());
  contact::ToolGap gap(body.profile, contact_boundaries(body), reach);
  for (const Index node : nodes) gaps[node] = gap(glass.nodes[node] - displacement);
  return gaps;
}

Eigen::VectorXd tool_gaps(const Scene& scene, const State& state, Index tool, double reach) {
  return tool_gaps(scene, state, contact_nodes(state.glass.mesh), tool, reach);
}

double keep_beside_axis(core::Geometry geometry, core::Mesh& mesh) {
  if (geometry == core::Geometry::planar) return 0;
  double furthest = 0;
  for (Point& x : mesh.nodes)
    if (x[0] < 0) {
      furthest = std::max(furthest, -x[0]);
      x[0] = 0;
    }
  for (const auto& edge : mesh.boundary_edges()) {
    const auto& [first, last, middle] = edge.nodes;
    const double a = mesh.nodes[first][0], b = mesh.nodes[last][0];
    double& r = mesh.nodes[middle][0];
    r = std::max(r,
                 0.25 * (a + b) - 0.5 * std::sqrt(a * b));  // the least with which no point between is beyond the axis
  }
  return furthest;
}

std::function<Point(const Point&)> projector_out_of_tools(const Scene& scene, const State& state) {
  const auto tools = std::make_shared<const PlacedTools>(placed_tools(scene, state));
  return [tools](const Point& x) {
    const auto holds = [&](const PlacedTools::Tool& tool) { return core::contains(*tool.profile, x - tool.shift); };
    return std::any_of(tools->tools.begin(), tools->tools.end(), holds) ? projected_out(*tools, x) : x;
  };
}

void project_out_of_tools(const Scene& scene, const State& state, core::Mesh& mesh) {
  const PlacedTools tools = placed_tools(scene, state);
  const auto out = [&](const Point& x) { return projected_out(tools, x); };
  std::vector<Point> line(mesh.nodes.size(), Point::Zero());  // tangent of the symmetry line on which a node lies
  for (const auto& edge : mesh.boundary_edges())
    if (mesh.kind_of(edge) == BoundaryKind::symmetry)
      for (const Index node : edge.nodes)
        line[node] = (mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]]).normalized();
  const auto may_touch = touching_nodes(mesh);
  for (const Index node : surface_nodes(mesh)) {
    Point& x = mesh.nodes[node];
    if (line[node].isZero())
      x = out(x);
    else if (may_touch[node])
      x = remesh::project_along(out, x, line[node]);
  }
}

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

double max_penetration(const Scene& scene, const State& state, double known) {
  const core::Mesh& glass = state.glass.mesh;
  const auto surface = surface_nodes(glass);
  for (const Index tool : active_tools(scene, state)) {
    const contact::ToolGap gap(scene.tools[tool].profile, contact_boundaries(scene.tools[tool]));
    const Point offset = state.tools[tool].offset * core::axis_direction();
    std::size_t closest = 0;
    for (const Index node : surface) known = gap.deepest(glass.nodes[node] - offset, known, closest);
  }
  return known;
}

double max_edge_penetration(const Scene& scene, const State& state, double known) {
  constexpr int points = 8;
  const core::Mesh& mesh = state.glass.mesh;
  for (const Index tool : active_tools(scene, state)) {
    const contact::ToolGap gap(scene.tools[tool].profile, contact_boundaries(scene.tools[tool]));
    const Point offset = state.tools[tool].offset * core::axis_direction();
    std::size_t closest = 0;
    for (const auto& edge : mesh.boundary_edges()) {
      if (mesh.kind_of(edge) != BoundaryKind::contact) continue;
      const bool near = std::any_of(edge.nodes.begin(), edge.nodes.end(),
                                    [&](Index node) { return state.glass.contact_tool[node] == tool; });
      for (int k = 0; near && k <= points; ++k) {
        const auto n = core::edge_shape(double(k) / points);
        Point x = -offset;
        for (int i = 0; i < 3; ++i) x += n[i] * mesh.nodes[edge.nodes[i]];
        known = gap.deepest(x, known, closest);
      }
    }
  }
  return known;
}

}  // namespace parison::forming
