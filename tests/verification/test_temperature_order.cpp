// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "figure.hpp"
#include "forming/remeshing/remesh_state.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/heat/heat_step.hpp"
#include "forming/step/step.hpp"

namespace parison::forming {
namespace {

Scene bundled(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/" + name, "draft", overrides);
}

/// Time, glass side, steel side.
constexpr std::array<std::array<double, 3>, 4> exact{
    {{1, 742.0877, 575.8608}, {2, 706.4829, 583.7917}, {5, 671.5318, 591.5769}, {10, 652.8883, 595.7298}}};

/// Largest deviation of both sides of the contact from the exact temperatures with linear ones on `along` divisions of
/// each cylinder's height, K.
double deviation(Index across, Index along) {
  Scene scene = bundled("contact_cylinders", {"numerics.temperature_tolerance=0.02 K"});
  scene.accuracy.temperature_order = 1;
  for (Body* body : {static_cast<Body*>(&scene.glass), static_cast<Body*>(&scene.tools[0])}) {
    body->mesh.mapped->along_first = across;
    body->mesh.mapped->along_second = along;
  }
  State state = initial_state(scene);
  Workspace workspace;
  double worst = 0;
  for (const auto& [time, glass_side, steel_side] : exact) {
    while (state.time < time - 1e-12) {
      auto result = coupled_step(scene, state, time - state.time, workspace);
      EXPECT_TRUE(result.converged) << result.reason;
      if (!result.converged) return 1e9;
      state = std::move(result.state);
    }
    for (const Index b : {0, 1}) {
      const core::Mesh& mesh = mesh_of(state, b);
      const double side = 273.15 + (b ? steel_side : glass_side);
      for (const auto& edge : mesh.boundary_edges())
        for (const Index node : edge.nodes)
          if (mesh.boundaries()[edge.boundary_id].name == "contact")
            worst = std::max(worst, std::abs(temperature_of(state, b)[node] - side));
    }
  }
  return worst;
}

/// On flat cells linear triangles disturb a one-dimensional field across the cells: both directions are refined.
TEST(TemperatureOrder, linear_temperatures_of_the_contact_cylinders_converge_to_within_a_tenth_of_a_kelvin) {
  const double coarse = deviation(40, 48), finer = deviation(80, 96), finest = deviation(160, 128);
  std::printf("linear temperatures: worst deviation %.4f, %.4f, %.4f K\n", coarse, finer, finest);
  EXPECT_GT(std::log2(coarse / finer), 1.7);
  tests::expect_at_most("glass on steel with linear temperatures, finest of three meshes: off by", finest, 0.1, "K");
}

TEST(TemperatureOrder, a_new_glass_mesh_keeps_linear_temperatures_and_their_heat) {
  Scene scene = bundled("jar");
  scene.accuracy.temperature_order = 1;
  State state = initial_state(scene);
  const core::Mesh& mesh = state.glass.mesh;
  for (Index n = 0; n < mesh.node_count(); ++n) state.glass.temperature[n] += 3e4 * mesh.nodes[n][0];
  state.glass.temperature = core::from_vertices(mesh, state.glass.temperature.head(mesh.vertex_count()));
  const RemeshedState remeshed = remesh_state(scene, state, RemeshReason::quality);
  ASSERT_TRUE(remeshed.ok) << remeshed.reason;
  const auto& glass = remeshed.state.glass;
  ASSERT_NE(glass.mesh.node_count(), mesh.node_count());
  EXPECT_NEAR(glass_heat(scene, remeshed.state) / glass_heat(scene, state), 1, 1e-12);
  const auto linear = core::from_vertices(glass.mesh, glass.temperature.head(glass.mesh.vertex_count()));
  EXPECT_LT((glass.temperature - linear).lpNorm<Eigen::Infinity>(), 1e-9);
}

}  // namespace
}  // namespace parison::forming
