// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "../../pot_scene.hpp"
#include "../../scene_text.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/balance/volume_conservation.hpp"
#include "forming/step/contact/penetration.hpp"
#include "forming/step/step.hpp"

namespace parison::forming {
namespace {

/// A gob that stands in a pot, its volume off by `error`, relative.
class VolumeConservation : public ::testing::Test {
 protected:
  State gob(double error) const {
    State state = initial_state(scene);
    for (auto& node : state.glass.mesh.nodes) node[0] *= std::sqrt(1 + error);
    return state;
  }
  const Scene scene = scene_of(pot);
};

TEST_F(VolumeConservation, a_drift_is_reduced_over_five_milliseconds) {
  const State state = gob(1e-3);
  EXPECT_NEAR(volume_drift(scene, state), 1e-3, 1e-12);
  const auto remaining = [&](double dt) { return target_volume(scene, state, dt) / state.glass.initial_volume - 1; };
  EXPECT_NEAR(remaining(1e-3), 0.8e-3, 1e-12);
  EXPECT_NEAR(remaining(5e-3), 0, 1e-12);
  EXPECT_NEAR(remaining(1), 0, 1e-12);
  const core::Mesh& mesh = state.glass.mesh;
  EXPECT_NEAR(prescribed_dilatation_rate(scene, state, mesh, nullptr, 1e-3), -1e-3 / 5e-3, 1e-9);
  EXPECT_NEAR(prescribed_dilatation_rate(scene, state, mesh, nullptr, 0.1), -1e-3 / 0.1, 1e-9);
}

TEST_F(VolumeConservation, the_error_of_straight_motion_is_offset) {
  // A rotation-free flow without divergence, r/2 and -z: straight motion changes the volume in second order.
  State state = gob(0);
  const core::Mesh& mesh = state.glass.mesh;
  Eigen::VectorXd velocity(core::dim * mesh.node_count());
  for (Index n = 0; n < mesh.node_count(); ++n)
    velocity.segment<core::dim>(core::dim * n) = Point(0.5 * mesh.nodes[n][0], -mesh.nodes[n][1]);
  const double dt = 0.1, growth = (1 + dt / 2) * (1 + dt / 2) * (1 - dt) - 1;
  EXPECT_NEAR(prescribed_dilatation_rate(scene, state, mesh, &velocity, dt), -growth / dt, 1e-9);
  EXPECT_GT(std::abs(growth), 1e-3);
  EXPECT_NEAR(missed_volume(scene, state, velocity, dt), std::abs(growth), 1e-9);
  EXPECT_NEAR(missed_volume(scene, gob(1e-3), 0 * velocity, 1e-3), 0.2e-3, 1e-12);  // less than a step makes good
}

TEST_F(VolumeConservation, the_dilatation_mode_leads_motion_to_the_initial_volume) {
  State state = gob(1e-3);
  const core::Mesh& mesh = state.glass.mesh;
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(core::dim * mesh.node_count());
  state.glass.dilatation_mode = rest;
  EXPECT_EQ(volume_conserving(scene, state, rest, 0.1), rest);  // an unknown mode changes nothing
  for (Index n = 0; n < mesh.node_count(); ++n)
    state.glass.dilatation_mode.segment<core::dim>(core::dim * n) = mesh.nodes[n] / 3;
  const Eigen::VectorXd velocity = volume_conserving(scene, state, rest, 0.1);
  State moved = state;
  for (Index n = 0; n < mesh.node_count(); ++n) moved.glass.mesh.nodes[n] += 0.1 * flow::node_velocity(velocity, n);
  EXPECT_LT(std::abs(volume_drift(scene, moved)), 1e-9);
}

TEST_F(VolumeConservation, a_micrometre_of_the_free_surface_makes_a_little_volume_good) {
  const State state = gob(0);
  core::Mesh mesh = state.glass.mesh;
  const double volume = core::volume(mesh, scene.geometry);
  ASSERT_TRUE(shift_free_surface(scene, state, (1 + 1e-5) * volume, mesh));
  EXPECT_NEAR(core::volume(mesh, scene.geometry) / volume, 1 + 1e-5, 1e-14);
  int kept = 0;
  for (Index n = 0; n < mesh.node_count(); ++n) {
    EXPECT_LT((mesh.nodes[n] - state.glass.mesh.nodes[n]).norm(), 1e-6);
    if (state.glass.mesh.nodes[n][1] < 1e-9) kept += mesh.nodes[n] == state.glass.mesh.nodes[n];
    if (state.glass.mesh.nodes[n][0] == 0) EXPECT_EQ(mesh.nodes[n][0], 0);
  }
  EXPECT_GT(kept, 5) << "what stands on the pot stays";
  core::Mesh far = state.glass.mesh;
  EXPECT_FALSE(shift_free_surface(scene, state, 1.01 * volume, far));
  EXPECT_EQ(far.nodes, state.glass.mesh.nodes);
}

TEST_F(VolumeConservation, a_step_ends_with_the_volume_that_was_aimed_at) {
  const State state = gob(1e-4);
  Workspace workspace;
  const double dt = 1e-4, target = target_volume(scene, state, dt);
  const auto result = coupled_step(scene, state, dt, workspace);
  ASSERT_TRUE(result.converged) << result.reason;
  EXPECT_NEAR(core::volume(result.state.glass.mesh, scene.geometry), target, 1e-9 * target);
  EXPECT_GT(std::abs(target / core::volume(state.glass.mesh, scene.geometry) - 1), 1e-6);
}

TEST_F(VolumeConservation, a_mesh_gets_its_volume_where_no_tool_touches_it) {
  const State state = gob(0);
  core::Mesh mesh = gob(-2e-3).glass.mesh;
  restore_volume(scene, state, state.glass.initial_volume, mesh);
  EXPECT_NEAR(core::volume(mesh, scene.geometry), state.glass.initial_volume, 4e-15 * state.glass.initial_volume);
  State restored = state;
  restored.glass.mesh = mesh;
  EXPECT_LT(deepest_node(scene, restored).depth, 1e-9);
  for (const auto& node : mesh.nodes) EXPECT_GE(node[0], 0);
}

}  // namespace
}  // namespace parison::forming
