// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <limits>

#include "core/files.hpp"
#include "core/hdf5.hpp"
#include "forming/checkpoint.hpp"
#include "forming/initial_state.hpp"
#include "scene_text.hpp"

namespace parison::forming {
namespace {

std::string checkpoint_path() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(testing::TempDir()) / (std::string("parison_checkpoint_") + test->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return (folder / "checkpoint.h5").string();
}

/// A state in which no two numbers are alike.
State busy_state(const Scene& scene) {
  State state = initial_state(scene);
  double next = 1 / 3.0;
  const auto fresh = [&](double& value) { value = next *= -1.0000001; };
  for (double* value : {&state.time, &state.stage_time, &state.next_step, &state.heat_substep, &state.last_step,
                        &state.density, &state.first_volume, &state.first_heat})
    fresh(*value);
  Totals& totals = state.totals;
  for (double* value : {&totals.to_air, &totals.to_tools, &totals.dissipation, &totals.content_change,
                        &totals.remesh_heat, &totals.remesh_volume, &totals.deepest, &totals.largest_drift, &totals.largest_reynolds})
    fresh(*value);
  for (BodyState& body : state.bodies) {
    for (double* value : {&body.offset, &body.velocity, &body.force, &body.heat_received, &body.hottest_surface})
      fresh(*value);
    for (double& value : body.temperature) fresh(value);
    for (Point& x : body.mesh.nodes) fresh(x[0]), fresh(x[1]);
  }
  for (Point& x : state.mass_nodes) fresh(x[0]), fresh(x[1]);
  for (Point& x : state.probes) fresh(x[0]), fresh(x[1]);
  for (double& value : state.velocity) fresh(value);
  for (double& value : state.contact.pressure) fresh(value);
  state.contact.tool[3] = 1;
  state.contact.closed = {{3, 5}, {1, 0}, {Point(0.6, 0.8), Point(-1, 0)}};
  state.stage = 1;
  totals.steps = 7, totals.rejected = 8, totals.remeshes = 9, totals.table_holds = 1L << 40;
  state.bodies[0].mesh.pieces.push_back("inner, by name");
  state.bodies[0].mesh.boundary[0].piece = 2;
  state.velocity[0] = std::numeric_limits<double>::infinity();
  return state;
}

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool same(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return same(x, y); });
}
bool same(const std::vector<Point>& a, const std::vector<Point>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const Point& x, const Point& y) {
           return same(x[0], y[0]) && same(x[1], y[1]);
         });
}
bool same(const core::Mesh& a, const core::Mesh& b) {
  const auto same_edge = [](const core::BoundaryEdge& x, const core::BoundaryEdge& y) {
    return x.nodes == y.nodes && x.cell == y.cell && x.piece == y.piece;
  };
  return same(a.nodes, b.nodes) && a.vertex_count == b.vertex_count && a.cells == b.cells && a.pieces == b.pieces &&
         a.boundary.size() == b.boundary.size() &&
         std::equal(a.boundary.begin(), a.boundary.end(), b.boundary.begin(), same_edge);
}

void expect_same_totals(const Totals& a, const Totals& b) {
  EXPECT_TRUE(same(a.to_air, b.to_air));
  EXPECT_TRUE(same(a.to_tools, b.to_tools));
  EXPECT_TRUE(same(a.dissipation, b.dissipation));
  EXPECT_TRUE(same(a.content_change, b.content_change));
  EXPECT_TRUE(same(a.remesh_heat, b.remesh_heat));
  EXPECT_TRUE(same(a.remesh_volume, b.remesh_volume));
  EXPECT_TRUE(same(a.deepest, b.deepest));
  EXPECT_TRUE(same(a.largest_drift, b.largest_drift));
  EXPECT_TRUE(same(a.largest_reynolds, b.largest_reynolds));
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.rejected, b.rejected);
  EXPECT_EQ(a.remeshes, b.remeshes);
  EXPECT_EQ(a.table_holds, b.table_holds);
}

void expect_same_body(const BodyState& a, const BodyState& b) {
  EXPECT_TRUE(same(a.mesh, b.mesh));
  EXPECT_TRUE(same(a.temperature, b.temperature));
  EXPECT_TRUE(same(a.offset, b.offset));
  EXPECT_TRUE(same(a.velocity, b.velocity));
  EXPECT_TRUE(same(a.force, b.force));
  EXPECT_TRUE(same(a.heat_received, b.heat_received));
  EXPECT_TRUE(same(a.hottest_surface, b.hottest_surface));
}

TEST(Checkpoint, AStateComesBackToTheBit) {
  const Scene scene = scene_of(small_scene);
  const State state = busy_state(scene);
  const std::string path = checkpoint_path();
  write_checkpoint(path, scene, state);
  const State read = read_checkpoint(path, scene);
  EXPECT_TRUE(same(read.time, state.time));
  EXPECT_EQ(read.stage, state.stage);
  EXPECT_TRUE(same(read.stage_time, state.stage_time));
  EXPECT_TRUE(same(read.next_step, state.next_step));
  EXPECT_TRUE(same(read.heat_substep, state.heat_substep));
  EXPECT_TRUE(same(read.last_step, state.last_step));
  EXPECT_TRUE(same(read.mass_nodes, state.mass_nodes));
  EXPECT_TRUE(same(read.density, state.density));
  EXPECT_TRUE(same(read.first_volume, state.first_volume));
  EXPECT_TRUE(same(read.first_heat, state.first_heat));
  EXPECT_TRUE(same(read.velocity, state.velocity));
  EXPECT_EQ(read.contact.tool, state.contact.tool);
  EXPECT_EQ(read.contact.closed.node, state.contact.closed.node);
  EXPECT_EQ(read.contact.closed.tool, state.contact.closed.tool);
  EXPECT_TRUE(same(read.contact.closed.normal, state.contact.closed.normal));
  EXPECT_TRUE(same(read.contact.pressure, state.contact.pressure));
  EXPECT_TRUE(same(read.probes, state.probes));
  expect_same_totals(read.totals, state.totals);
  ASSERT_EQ(read.bodies.size(), state.bodies.size());
  for (std::size_t i = 0; i < read.bodies.size(); ++i) expect_same_body(read.bodies[i], state.bodies[i]);
}

TEST(Checkpoint, ALaterOneTakesThePlaceOfTheFirstAndLeavesNothingBeside) {
  const Scene scene = scene_of(small_scene);
  State state = initial_state(scene);
  const std::string path = checkpoint_path();
  write_checkpoint(path, scene, state);
  state.time = 0.75;
  write_checkpoint(path, scene, state);
  EXPECT_EQ(read_checkpoint(path, scene).time, 0.75);
  const auto folder = std::filesystem::directory_iterator(std::filesystem::path(path).parent_path());
  EXPECT_EQ(std::distance(begin(folder), end(folder)), 1);
}

TEST(Checkpoint, OneOfAnotherCaseFileOrVersionIsRefusedWithASentence) {
  const Scene scene = scene_of(small_scene);
  const std::string path = checkpoint_path();
  write_checkpoint(path, scene, initial_state(scene));
  const Scene other = scene_of(replaced("1000 degC", "1001 degC"));
  try {
    read_checkpoint(path, other);
    FAIL() << "nothing was thrown";
  } catch (const core::CaseError& error) {
    EXPECT_EQ(std::string(error.what()),
              path + ": a checkpoint of the case \"small\" with another case file was found, allowed is one of \"small\" as "
                     "it is now");
  }
  core::create_hdf5(path).write("version", std::int64_t{99});
  try {
    read_checkpoint(path, scene);
    FAIL() << "nothing was thrown";
  } catch (const core::CaseError& error) {
    EXPECT_EQ(std::string(error.what()), path + ": a checkpoint of version 99 was found, allowed is version 1");
  }
}

}  // namespace
}  // namespace parison::forming
