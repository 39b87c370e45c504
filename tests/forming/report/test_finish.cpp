// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../scene_text.hpp"
#include "forming/report/thickness_profile.hpp"
#include "forming/state/initial_state.hpp"

namespace parison::forming {
namespace {

/// Five places of a wall one above the other, 1 mm apart, with these thicknesses, mm.
ThicknessProfile wall_of(const std::vector<double>& thickness) {
  ThicknessProfile profile;
  for (std::size_t i = 0; i < thickness.size(); ++i) {
    const double z = 1e-3 * double(i), wall = 1e-3 * thickness[i];
    profile.rows.push_back({z, Point(0.03, z), wall, 900, 900, 1, WallMark::wall, Point(0.03 - wall, z)});
    profile.nodes.push_back(static_cast<Index>(i));
  }
  return profile;
}

TEST(Finish, its_thin_places_leave_the_thinnest_wall_of_the_body_to_be_seen) {
  Scene scene = scene_of(small_scene);
  State state = initial_state(scene);
  const ThicknessProfile profile = wall_of({0.9, 0.2, 0.8, 1.5, 2.5});
  std::fill(state.glass.contact_tool.begin(), state.glass.contact_tool.end(), -1);
  EXPECT_TRUE(std::isnan(thickness_beside_finish(scene, state, profile).mean)) << "nothing grips";

  scene.tools[0].friction.law = flow::Friction::Law::grip;
  state.glass.contact_tool[0] = state.glass.contact_tool[2] = 0;  // the thinnest place lies between
  const ThicknessRange body = thickness_beside_finish(scene, state, profile);
  EXPECT_NEAR(body.lowest, 1.5e-3, 1e-12);
  EXPECT_NEAR(body.lowest_at[1], 3e-3, 1e-12);
  EXPECT_NEAR(thickness_range(profile.rows).lowest, 0.2e-3, 1e-12);
}

}  // namespace
}  // namespace parison::forming
