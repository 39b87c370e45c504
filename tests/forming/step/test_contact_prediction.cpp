// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "../pot_scene.hpp"
#include "../scene_text.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/contact_prediction.hpp"

namespace parison::forming {
namespace {

class ContactGuess : public ::testing::Test {
 protected:
  /// Node 0 stands at an end of the first tool's outline, beside it by `away`, m, and was closed against two normals
  /// there.
  void put_at_corner(double away) {
    const Point corner = scene.tools[0].profile.segments[0].end + state.tools[0].offset * core::axis_direction();
    state.glass.mesh.nodes[0] = corner + Point(away, 0);
    state.glass.active_contacts = {{0, 0}, {0, 0}, {Point(-1, 0), Point(-0.94, 0.341174)}};
  }
  const Scene scene = scene_of(pot);
  State state = initial_state(scene);
};

TEST_F(ContactGuess, a_node_in_a_corner_keeps_both_of_its_sides) {
  put_at_corner(0);
  const auto bounds = corner_bounds(scene, state);
  ASSERT_EQ(bounds.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(bounds[i].node, 0);
    EXPECT_EQ(bounds[i].tool, 0);
    EXPECT_EQ(bounds[i].normal, state.glass.active_contacts.normal[i]);
    EXPECT_EQ(bounds[i].rate, 0);
  }
}

TEST_F(ContactGuess, a_node_that_left_its_corner_or_touched_one_side_keeps_none) {
  put_at_corner(2e-5);
  EXPECT_TRUE(corner_bounds(scene, state).empty());
  put_at_corner(0);
  state.glass.active_contacts = {{0}, {0}, {Point(-1, 0)}};
  EXPECT_TRUE(corner_bounds(scene, state).empty());
  state.glass.active_contacts = {{0, 1}, {0, 0}, {Point(-1, 0), Point(-0.94, 0.341174)}};
  EXPECT_TRUE(corner_bounds(scene, state).empty());
}

TEST_F(ContactGuess, kept_bounds_stand_beside_their_node_unless_it_has_them) {
  const auto candidate = [](Index node, const Point& normal) {
    return flow::ContactCandidate{node, 0, normal, 0.0, false, 1.0, Point::Zero()};
  };
  std::vector<flow::ContactCandidate> candidates{candidate(3, {1, 0}), candidate(5, {1, 0})};
  keep_bounds({candidate(3, {0, 1}), candidate(5, {1, 0}), candidate(7, {1, 0})}, candidates);
  ASSERT_EQ(candidates.size(), 4u);
  const Index nodes[] = {3, 3, 5, 7};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(candidates[i].node, nodes[i]);
  EXPECT_EQ(candidates[1].normal, Point(0, 1));
}

}  // namespace
}  // namespace parison::forming
