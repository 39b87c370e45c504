// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>

#include "../pot_scene.hpp"
#include "../scene_text.hpp"
#include "forming/run/run.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/balance/work.hpp"
#include "forming/step/contact/contact_geometry.hpp"

namespace parison::forming {
namespace {

/// The pot with a slender gob and another inner outline.
std::string pot_with(const std::string& inner) {
  return replaced("path = \"(12, 20) (12, 0) (0, 0) mm\"", "path = " + inner,
                  replaced("(0, 0) (10, 0) (10, 10) (0, 10) mm", "(0, 0) (6, 0) (6, 10) (0, 10) mm", pot));
}
const std::string round_pot =
    pot_with(R"(["(12, 20) (12, 6) mm", "arc centre (6, 6) mm radius 6 mm from 0 deg to -90 deg", "(0, 0) mm"])");
const std::string chamfered_pot = pot_with(R"("(12, 20) (12, 4) (8, 0) (0, 0) mm")");

/// The contact candidate with the pot of a node that touches it at `from` and reaches `to`, m, after a step of 1 ms.
flow::ContactCandidate sliding_candidate(const std::string& text, const Point& from, const Point& to) {
  constexpr double dt = 1e-3;
  const Scene scene = scene_of(text);
  State state = initial_state(scene);
  const Index node = contact_nodes(state.glass.mesh).front();
  state.glass.mesh.nodes[node] = from;
  state.glass.contact_tool[node] = 0;
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(core::dim * state.glass.mesh.node_count());
  velocity.segment<core::dim>(core::dim * node) = (to - from) / dt;
  const auto candidates = contact_candidates(scene, state, velocity, dt);
  return *std::find_if(candidates.begin(), candidates.end(),
                       [&](const auto& c) { return c.node == node && c.tool == 0; });
}

/// The contact force of a node that slides from one place on the tool to another does no work on it.
void expect_no_work(const std::string& text, const Point& from, const Point& to) {
  const auto candidate = sliding_candidate(text, from, to);
  EXPECT_NEAR(candidate.normal.norm(), 1, 1e-12);
  EXPECT_NEAR(candidate.normal.dot(to - from) / (to - from).norm(), 0, 1e-9);
  EXPECT_NEAR(candidate.rate, 0, 1e-9 * (to - from).norm() / 1e-3);
}

TEST(ContactCandidate, of_a_node_that_slides_along_an_arc_is_perpendicular_to_its_path) {
  const auto on_arc = [](double angle) { return Point(6e-3 + 6e-3 * std::cos(angle), 6e-3 + 6e-3 * std::sin(angle)); };
  expect_no_work(round_pot, on_arc(-0.4), on_arc(-0.6));
}

TEST(ContactCandidate, of_a_node_that_slides_around_a_corner_is_perpendicular_to_its_path) {
  expect_no_work(chamfered_pot, {12e-3, 4.2e-3}, {11.9e-3, 3.9e-3});
}

TEST(ContactCandidate, of_a_node_that_slides_along_the_bottom_keeps_the_wall_ahead_of_it) {
  for (const char* wall : {R"("(12, 20) (12, 0) (0, 0) mm")", R"("(12, 20) (14, 10) (12, 0) (0, 0) mm")"}) {
    const Scene scene = scene_of(pot_with(wall));
    State state = initial_state(scene);
    const Index node = contact_nodes(state.glass.mesh).front();
    state.glass.mesh.nodes[node] = {11.8e-3, 0};
    state.glass.contact_tool[node] = 0;
    Eigen::VectorXd velocity = Eigen::VectorXd::Zero(core::dim * state.glass.mesh.node_count());
    velocity[core::dim * node] = 0.17;  // to 30 um before the corner
    int walls = 0;
    for (const auto& candidate : contact_candidates(scene, state, velocity, 1e-3)) {
      if (candidate.node != node || candidate.tool != 0) continue;
      EXPECT_TRUE(std::isfinite(candidate.rate)) << wall;
      if (candidate.normal[0] > -0.9) continue;
      ++walls;
      EXPECT_NEAR(candidate.rate, 1e3 * 0.2e-3 * candidate.normal[0], 1e-9) << "the way to the wall";
    }
    EXPECT_EQ(walls, 1) << wall;
  }
}

TEST(ContactCandidate, of_a_node_that_creeps_on_the_bottom_is_not_wedged_by_the_wall_far_ahead) {
  const Scene scene = scene_of(pot_with(R"("(12, 20) (12, 0) (0, 0) mm")"));
  for (const double angle : {-8, -5, -4, 4, 5, 8}) {  // degrees, off the bottom
    State state = initial_state(scene);
    const Index node = contact_nodes(state.glass.mesh).front();
    state.glass.mesh.nodes[node] = {11.8e-3, 0};
    state.glass.contact_tool[node] = 0;
    Eigen::VectorXd velocity = Eigen::VectorXd::Zero(core::dim * state.glass.mesh.node_count());
    velocity.segment<core::dim>(core::dim * node) =
        1e-3 * Point(std::cos(angle * M_PI / 180), std::sin(angle * M_PI / 180));
    std::vector<Point> normals;
    for (const auto& candidate : contact_candidates(scene, state, velocity, 1e-3))
      if (candidate.node == node && candidate.tool == 0) normals.push_back(candidate.normal);
    for (const Point& normal : normals)
      EXPECT_NEAR(normal.cwiseAbs().maxCoeff(), 1, 1e-12) << angle << ": neither bottom nor wall";
    EXPECT_FALSE(normals.empty());
  }
}

TEST(ContactCandidate, none_of_a_node_that_enters_a_tool_through_a_face_without_contact) {
  const Scene scene = scene_of(pot_with(R"("(12, 20) (12, 0) (0, 0) mm")"));
  const auto candidates_from = [&](const Point& from, const Point& to) {
    State state = initial_state(scene);
    const Index node = contact_nodes(state.glass.mesh).front();
    state.glass.mesh.nodes[node] = from;
    state.glass.contact_tool[node] = 0;
    Eigen::VectorXd velocity = Eigen::VectorXd::Zero(core::dim * state.glass.mesh.node_count());
    velocity.segment<core::dim>(core::dim * node) = (to - from) / 1e-3;
    const auto found = contact_candidates(scene, state, velocity, 1e-3);
    return std::count_if(found.begin(), found.end(), [&](const auto& c) { return c.node == node && c.tool == 0; });
  };
  EXPECT_EQ(candidates_from({12.1e-3, 20.01e-3}, {12.1e-3, 19.99e-3}), 0) << "from above, through the rim of the pot";
  EXPECT_EQ(candidates_from({11.99e-3, 19.9e-3}, {12.01e-3, 19.9e-3}), 1) << "through the wall";
}

TEST(ContactCandidate, of_a_node_that_lands_has_the_normal_where_it_lands) {
  const Scene scene = scene_of(round_pot);
  State state = initial_state(scene);
  const Index node = contact_nodes(state.glass.mesh).front();
  const Point to(6e-3 + 6e-3 * std::cos(-0.5), 6e-3 + 6e-3 * std::sin(-0.5));
  state.glass.mesh.nodes[node] = to - Point(2e-4, 0);
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(core::dim * state.glass.mesh.node_count());
  velocity[core::dim * node] = 0.2;
  for (const auto& candidate : contact_candidates(scene, state, velocity, 1e-3))
    if (candidate.node == node && candidate.tool == 0)
      EXPECT_NEAR((candidate.normal - Point(-std::cos(-0.5), -std::sin(-0.5))).norm(), 0, 1e-9);
}

TEST(ContactCandidate, of_a_node_at_rest_between_two_facing_walls_have_unit_normals_and_finite_rates) {
  const Scene scene = scene_of(pot_with(R"("(12, 20) (12, 0) (11.9, 8) (8, 0) (0, 0) mm")"));
  State state = initial_state(scene);
  const Index node = contact_nodes(state.glass.mesh).front();
  state.glass.mesh.nodes[node] = {12e-3, 5e-3};
  state.glass.contact_tool[node] = 0;
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(core::dim * state.glass.mesh.node_count());
  int found = 0;
  for (const auto& candidate : contact_candidates(scene, state, rest, 1e-3))
    if (candidate.node == node && candidate.tool == 0) {
      ++found;
      EXPECT_NEAR(candidate.normal.norm(), 1, 1e-12);
      EXPECT_TRUE(std::isfinite(candidate.rate));
    }
  EXPECT_EQ(found, 2);
}

/// Whether the middle and the first end of an edge on the bottom of a pot that grips are tied to it, where the other
/// end has left it by `open`, m.
std::array<bool, 2> tied_beside_open_end(double open) {
  const Scene scene =
      scene_of(replaced("friction = \"stick\"", "friction = \"grip\"", pot_with("\"(12, 20) (12, 0) (0, 0) mm\"")));
  State state = initial_state(scene);
  state.totals.steps = 1;
  core::Mesh& mesh = state.glass.mesh;
  const auto edge = *std::find_if(mesh.boundary_edges().begin(), mesh.boundary_edges().end(), [&](const auto& e) {
    return mesh.nodes[e.nodes[0]][1] == 0 && mesh.nodes[e.nodes[1]][1] == 0 && mesh.nodes[e.nodes[0]][0] > 0;
  });
  for (const Index node : edge.nodes) state.glass.contact_tool[node] = 0;
  mesh.nodes[edge.nodes[1]][1] = open;
  if (open > 0) state.glass.contact_tool[edge.nodes[1]] = -1;
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(core::dim * mesh.node_count());
  std::array<bool, 2> tied{};
  for (const auto& candidate : contact_candidates(scene, state, rest, 1e-3))
    for (const int i : {0, 1})
      if (candidate.node == edge.nodes[i == 0 ? 2 : 0] && candidate.tool == 0) tied[i] = candidate.tied;
  return tied;
}

TEST(ContactCandidate, of_the_middle_of_an_edge_that_grips_lets_go_where_the_end_of_its_edge_has_left) {
  EXPECT_EQ(tied_beside_open_end(0), (std::array<bool, 2>{true, true}));
  EXPECT_EQ(tied_beside_open_end(0.3e-3), (std::array<bool, 2>{false, true}));
}

/// The speed at which a node 20 um inside the bottom of the pot is moved out, m/s, by the viscosity of the glass, Pa.s.
double recovery_speed(const std::string& viscosity) {
  const std::string law = "viscosity = { law = \"constant\", value = \"" + viscosity + " Pa.s\" }";
  const Scene scene = scene_of(std::regex_replace(pot, std::regex("viscosity = \\{[^}]*\\}"), law));
  State state = initial_state(scene);
  const Index node = contact_nodes(state.glass.mesh).front();
  state.glass.mesh.nodes[node] = {5e-3, -20e-6};
  state.glass.contact_tool[node] = 0;
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(core::dim * state.glass.mesh.node_count());
  for (const auto& candidate : contact_candidates(scene, state, rest, 1e-3))
    if (candidate.node == node && candidate.tool == 0) return candidate.recovery;
  return 0;
}

TEST(ContactCandidate, of_a_penetrated_node_moves_out_more_slowly_the_stiffer_the_glass_is) {
  const double soft = recovery_speed("1e3"), firm = recovery_speed("1e5"), stiff = recovery_speed("1e8");
  EXPECT_GT(soft, 19e-6 / 20e-3) << "19 um over 20 ms";
  EXPECT_NEAR(firm, soft / 5, 1e-9 * soft) << "over 0.1 s";
  EXPECT_NEAR(stiff, soft / 5000, 1e-9 * soft) << "over 100 s";
}

TEST(Work, of_glass_that_slides_along_a_round_tool_is_balanced) {
  const std::string slips = replaced("duration = \"0.4 s\"", "duration = \"0.18 s\"",
                                     replaced("friction = \"stick\"", "friction = \"slip\"", round_pot));
  const Scene scene =
      scene_of(replaced(R"(path = "(0, 10) (12, 10) mm")",
                        R"(path = ["arc centre (0, 18) mm radius 8 mm from -90 deg to 0 deg", "(8, 30) mm"])",
                        replaced(R"(path = "(12, 20) (0, 20) mm")", R"(path = "(0, 30) mm")", slips)));
  const auto outcome = run(scene, {}, nullptr);
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  for (const StageRecord& stage : outcome.facts.stages) {
    std::printf("%s: off by %.1e\n", stage.name.c_str(), work_imbalance(stage.work));
    EXPECT_LT(std::abs(work_imbalance(stage.work)), 1e-3);
  }
}

}  // namespace
}  // namespace parison::forming
