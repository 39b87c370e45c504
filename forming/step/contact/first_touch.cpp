// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/contact/first_touch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "contact/unilateral/tool_gap.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/contact/placed_tools.hpp"
#include "forming/step/flow/predictor.hpp"

namespace parison::forming {

namespace {

/// Share of numerics.surface_size: glass that is nearer touches already.
constexpr double touching_share = 1e-3;

/// Nothing moves farther than this share of the thickness of the glass from one look for a touch to the next, and no
/// more looks than these are made.
constexpr double share_of_wall = 0.25, most_looks = 1e4;

/// How far a tool moves along the axis in a time, m: driven by position as prescribed; driven by force at its speed
/// limit while nothing resists it, as fast as it does now where it touches glass.
double tool_advance(const State& state, const StageTool& tool, bool touches, double ahead) {
  const double now = state.stage_time;
  if (const auto* position = std::get_if<PositionMotion>(&tool.motion))
    return position->offset(now + ahead) - state.tools[tool.tool].offset;
  const auto* driven = std::get_if<ForceMotion>(&tool.motion);
  if (!driven) return 0;
  if (touches) return ahead * state.tools[tool.tool].velocity;
  const double force = driven->force.mean(now, now + ahead);
  return force == 0 ? 0 : std::copysign(ahead * driven->speed_limit.mean(now, now + ahead), force);
}

/// Nodes that touch a tool. Before a stage's first step, when no contact is known yet, by their gaps.
std::vector<bool> nodes_at(const Scene& scene, const State& state, Index tool) {
  const GlassState& glass = state.glass;
  std::vector<bool> touch(glass.mesh.nodes.size(), false);
  const double near = touching_share * scene.accuracy.surface_size;
  if (state.last_step == 0) {
    const Eigen::VectorXd gaps = tool_gaps(scene, state, tool, 2 * near);
    for (std::size_t n = 0; n < touch.size(); ++n) touch[n] = gaps[Index(n)] <= near;
  }
  const ActiveContacts& contacts = glass.active_contacts;
  for (std::size_t i = 0; i < contacts.node.size(); ++i)
    if (contacts.tool[i] == tool) touch[contacts.node[i]] = true;
  for (std::size_t n = 0; n < glass.contact_tool.size(); ++n)
    if (glass.contact_tool[n] == tool) touch[n] = true;
  return touch;
}

bool is_touched(const Scene& scene, const State& state, Index tool) {
  const std::vector<bool> touch = nodes_at(scene, state, tool);
  return std::find(touch.begin(), touch.end(), true) != touch.end();
}

/// By how much the tools that touch the glass will move faster than in the last step, m/s, where they all change alike
/// and so carry it with them; 0 where they do not.
double speed_jump(const Scene& scene, const State& state, double ahead) {
  std::optional<double> jump;
  for (const StageTool& tool : scene.stages[state.stage].tools) {
    if (!is_touched(scene, state, tool.tool)) continue;
    const double change = tool_advance(state, tool, true, ahead) / ahead - state.tools[tool.tool].velocity;
    if (jump && std::abs(change - *jump) > 1e-6 * std::max(std::abs(change), std::abs(*jump))) return 0;
    jump = change;
  }
  return jump.value_or(0);
}

/// The glass surface that may touch, beside one tool, over a time, s.
class Approach {
 public:
  Approach(const Scene& scene, const State& state, const StageTool& tool, const Eigen::VectorXd& velocity, double ahead)
      : state_(state),
        tool_(tool),
        velocity_(velocity),
        nodes_(contact_nodes(state.glass.mesh)),
        held_(nodes_at(scene, state, tool.tool)),
        touches_(is_touched(scene, state, tool.tool)),
        near_(touching_share * scene.accuracy.surface_size),
        way_(way(ahead)),
        gap_(scene.tools[tool.tool].profile, contact_boundaries(scene.tools[tool.tool]), 2 * way_ + near_) {}

  bool touches() const { return touches_; }
  /// Whether the tool is at the glass, though no contact with it is known.
  bool arrived() const {
    return !touches_ && std::any_of(nodes_.begin(), nodes_.end(), [&](Index node) { return gap_of(node, 0) <= near_; });
  }

  /// Time, s, until a node touches the tool that belongs to no surface in contact with it; infinite where none does
  /// within `ahead`. What would move so far that it is not looked at to the end counts as arriving there.
  double first_touch(double ahead) const {
    const double wanted = std::ceil(1 + way_ / (share_of_wall * core::mean_wall(state_.glass.mesh)));
    const double looks = std::min(wanted, most_looks), apart = ahead / wanted;
    for (double look = 0; look < looks; ++look)
      if (const auto arriving = arriving_apart((look + 1) * apart); !arriving.empty())
        return moment(arriving, look * apart, (look + 1) * apart);
    return looks < wanted ? looks * apart : std::numeric_limits<double>::infinity();
  }

 private:
  double gap_of(Index node, double ahead) const {
    const double offset = state_.tools[tool_.tool].offset + tool_advance(state_, tool_, touches_, ahead);
    const Point x = state_.glass.mesh.nodes[node] + ahead * flow::node_velocity(velocity_, node);
    return gap_(x - offset * core::axis_direction());
  }

  double least_gap(const std::vector<Index>& nodes, double ahead) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Index node : nodes) least = std::min(least, gap_of(node, ahead));
    return least;
  }

  /// The farthest that glass and tool come nearer to each other, m.
  double way(double ahead) const {
    double fastest = 0;
    for (const Index node : nodes_) fastest = std::max(fastest, flow::node_velocity(velocity_, node).norm());
    return ahead * fastest + std::abs(tool_advance(state_, tool_, touches_, ahead));
  }

  /// Just before the first of some nodes enters the tool, s: a step that ends there has no contact with it yet.
  double moment(const std::vector<Index>& nodes, double before, double after) const {
    const double close_enough = 1e-12 * after;  // no decision by round-off is seen in the step
    while (after - before > close_enough) {
      const double middle = 0.5 * (before + after);
      (least_gap(nodes, middle) > 0 ? before : after) = middle;
    }
    return before;
  }

  /// The nodes that will be in the tool after a time, s, without those that are joined along the surface, by nodes that
  /// will be at it too, to one that touches it now.
  std::vector<Index> arriving_apart(double ahead) const {
    std::vector<double> gap(held_.size(), std::numeric_limits<double>::infinity());
    for (const Index node : nodes_)
      if (!held_[node]) gap[node] = gap_of(node, ahead);
    if (*std::min_element(gap.begin(), gap.end()) >= 0) return {};
    std::vector<bool> joined = held_;
    for (const Index node : nodes_)
      if (gap[node] <= near_ && gap_of(node, 0) <= near_) joined[node] = true;
    for (bool grows = true; grows;) {
      grows = false;
      for (const auto& edge : state_.glass.mesh.boundary_edges()) {
        const auto& [first, last, middle] = edge.nodes;
        if (!joined[first] && !joined[last] && !joined[middle]) continue;
        for (const Index node : edge.nodes)
          if (gap[node] <= near_ && !joined[node]) joined[node] = grows = true;
      }
    }
    std::vector<Index> apart;
    for (const Index node : nodes_)
      if (gap[node] < 0 && !joined[node]) apart.push_back(node);
    return apart;
  }

  const State& state_;
  const StageTool& tool_;
  const Eigen::VectorXd& velocity_;
  std::vector<Index> nodes_;
  std::vector<bool> held_;  ///< nodes in contact with the tool
  bool touches_;            ///< the tool touches glass
  double near_, way_;       ///< m
  contact::ToolGap gap_;
};

}  // namespace

Eigen::VectorXd carried_velocity(const Scene& scene, const State& state, double dt) {
  Eigen::VectorXd velocity = predicted_velocity(state, 0.5 * dt);
  const double jump = speed_jump(scene, state, dt);
  for (Index n = 0; jump != 0 && n < velocity.size() / core::dim; ++n)
    velocity.segment<core::dim>(core::dim * n) += jump * core::axis_direction();
  return velocity;
}

double time_to_first_touch(const Scene& scene, const State& state, double ahead) {
  double first = std::numeric_limits<double>::infinity();
  if (!scene.has_flow()) return first;
  const Eigen::VectorXd velocity = carried_velocity(scene, state, ahead);
  for (const StageTool& tool : scene.stages[state.stage].tools)
    first = std::min(first, Approach(scene, state, tool, velocity, ahead).first_touch(ahead));
  return first;
}

double predicted_speed(const Scene& scene, const State& state, const StageTool& tool, const Eigen::VectorXd& velocity,
                       double dt) {
  const double last = state.tools[tool.tool].velocity;
  if (last == 0) return 0;
  const Approach approach(scene, state, tool, velocity, dt);
  if (approach.touches()) return last;
  if (approach.arrived()) return 0;
  return last * std::min(1.0, approach.first_touch(dt) / dt);
}

}  // namespace parison::forming
