// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/flow/predictor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "forming/flow/problem.hpp"
#include "forming/step/balance/volume_conservation.hpp"

namespace parison::forming {

using core::dim;

namespace {

/// The motion is smooth where the last acceleration predicts the next change of velocity to within this relative error.
constexpr double smooth = 0.5;

/// A temperature's rate of change r that falls from one step to the next, whose middles are `interval` apart, s, falls
/// on as r/(1 + s t), like that behind a touch with the root of time: this s, 1/s; 0 where it does not fall or turns.
double temperature_slowing(double before, double after, double interval) {
  return before * after > 0 && std::abs(after) < std::abs(before) ? (1 - after / before) / interval : 0;
}

/// Rate at which the logarithm of a speed falls, 1/s; 0 where the speed does not fall or turns. After a jolt, as where
/// a new mesh has left a gap that closes at once, it falls by much in one step and not in the next: a rate far above
/// the `last` one counts when it lasts.
double slowing(double before, double after, double interval, double last) {
  if (before * after <= 0 || std::abs(after) >= std::abs(before)) return 0;
  return std::min(std::log(before / after), 2 * last * interval + 0.5) / interval;
}

}  // namespace

void keep_on_symmetry(const core::Mesh& mesh, Eigen::VectorXd& velocity) {
  for (const auto& edge : mesh.boundary_edges()) {
    if (mesh.kind_of(edge) != BoundaryKind::symmetry) continue;
    const Point along = (mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]]).normalized();
    for (const Index node : edge.nodes) {
      auto own = velocity.segment<dim>(dim * node);
      own = along.dot(own) * along;
    }
  }
}

Eigen::VectorXd predicted_temperature(const Scene& scene, const State& state, double dt) {
  const Eigen::VectorXd& now = state.glass.temperature;
  if (state.glass.temperature_rate.size() == 0) return now;
  const auto rate = state.glass.temperature_rate.array();  // in the middle of the last step
  const auto slowing = state.glass.temperature_slowing.array();
  const Eigen::ArrayXd grown = dt * slowing / (1 + 0.5 * state.last_step * slowing);
  const Eigen::ArrayXd change = (grown > 1e-8).select(rate * grown.log1p() / slowing, dt * rate);
  // Nothing cools below the coldest of all.
  return (now.array() + change).cwiseMax(now.array().cwiseMin(temperature_range(scene).min_temperature)).matrix();
}

Eigen::VectorXd predicted_velocity(const State& state, double ahead) {
  Eigen::VectorXd velocity = state.glass.velocity;
  if (state.moves_smoothly) velocity += (0.5 * state.last_step + ahead) * state.glass.acceleration;
  const auto& active = state.glass.active_contacts;
  for (std::size_t i = 0; i < active.node.size(); ++i) {
    const double tool_speed = state.tools[active.tool[i]].velocity;
    auto own = velocity.segment<dim>(dim * active.node[i]);
    const double inward = active.normal[i].dot(own - tool_speed * core::axis_direction());
    own -= std::min(0.0, inward) * active.normal[i];
  }
  keep_on_symmetry(state.glass.mesh, velocity);
  return velocity;
}

core::Mesh midpoint_mesh(const Scene& scene, const State& state, const MidpointPredictor& predictor, double dt) {
  core::Mesh mesh = state.glass.mesh;
  Eigen::VectorXd mean = predictor.velocity;  // over the first half of the step
  if (state.moves_smoothly) mean -= 0.25 * dt * state.glass.acceleration;
  mean = volume_conserving(scene, state, std::move(mean), 0.5 * dt, predictor.temperature);
  for (Index n = 0; n < mesh.node_count(); ++n) mesh.nodes[n] += 0.5 * dt * flow::node_velocity(mean, n);
  return mesh;
}

void update_rates(const State& before, double dt, State& after) {
  if (after.glass.temperature.size() > 0) {
    after.glass.temperature_rate = (after.glass.temperature - before.glass.temperature) / dt;
    after.glass.temperature_slowing.setZero(after.glass.temperature_rate.size());
    if (before.last_step > 0)
      for (Eigen::Index n = 0; n < after.glass.temperature_slowing.size(); ++n)
        after.glass.temperature_slowing[n] = temperature_slowing(
            before.glass.temperature_rate[n], after.glass.temperature_rate[n], 0.5 * (before.last_step + dt));
  }
  after.glass.previous_contact_tool = before.glass.contact_tool;
  after.glass.acceleration.setZero(after.glass.velocity.size());
  after.moves_smoothly = false;
  for (ToolState& tool : after.tools) tool.slowing = 0;
  if (before.last_step == 0) return;
  const double interval = 0.5 * (before.last_step + dt);
  for (std::size_t i = 0; i < after.tools.size(); ++i)
    after.tools[i].slowing =
        slowing(before.tools[i].velocity, after.tools[i].velocity, interval, before.tools[i].slowing);
  for (Index n = 0; n < static_cast<Index>(after.glass.contact_tool.size()); ++n) {
    const Index tool = after.glass.contact_tool[n];
    if (before.glass.contact_tool[n] == tool && before.glass.previous_contact_tool[n] == tool)
      after.glass.acceleration.segment<dim>(dim * n) =
          (after.glass.velocity - before.glass.velocity).segment<dim>(dim * n) / interval;
  }
  const double change = interval * after.glass.acceleration.norm();
  const double missed = interval * (after.glass.acceleration - before.glass.acceleration).norm();
  after.moves_smoothly = missed < smooth * change;
}

}  // namespace parison::forming
