// SPDX-License-Identifier: GPL-3.0-or-later
// Glass that has grown longer or wider than a tool of the next stage.
#include <gtest/gtest.h>

#include "../bundled_scene.hpp"
#include "forming/run/room_in_tool.hpp"
#include "forming/run/stage.hpp"
#include "forming/state/initial_state.hpp"

namespace parison::forming {
namespace {

/// The jar in its reheat, with its gob stretched along the axis or across it.
struct Stretched {
  Scene scene = bundled("jar", "draft coarser 4");
  State state = initial_state(scene);
  Index reheat = 0, mould = 0;

  Stretched(double across, double along) {
    while (scene.stages[reheat].name != "reheat") ++reheat;
    while (scene.tools[mould].name != "blow_mould") ++mould;
    state.stage = reheat;
    for (Point& x : state.glass.mesh.nodes) x = {across * x[0], along * x[1]};
  }
};

TEST(RoomInTool, glass_that_fits_is_not_told) {
  const Stretched gob(1, 1);
  EXPECT_EQ(excess_size(gob.scene, gob.state, gob.mould).length, 0);
  EXPECT_EQ(outgrown_tool(gob.scene, gob.state), "");
}

TEST(RoomInTool, a_parison_longer_than_the_next_mould_is_told_with_what_is_too_much) {
  // The gob ends at 81.4 mm, the cavity on the axis at 126 mm.
  const Stretched parison(1, 2);
  const double end = 2 * 81.43627;
  const ExcessSize excess = excess_size(parison.scene, parison.state, parison.mould);
  EXPECT_TRUE(excess.along_axis);
  EXPECT_NEAR(1e3 * excess.length, end - 126, 0.2);
  EXPECT_NE(
      outgrown_tool(parison.scene, parison.state).find("36.8 mm longer than blow_mould, which comes in stage run"),
      std::string::npos)
      << outgrown_tool(parison.scene, parison.state);
}

TEST(RoomInTool, a_parison_wider_than_the_next_mould_is_told_with_the_height) {
  // A gob of 26 mm radius, made 45.5 mm wide, in a cavity of 37 mm.
  const Stretched parison(1.75, 1);
  const ExcessSize excess = excess_size(parison.scene, parison.state, parison.mould);
  EXPECT_FALSE(excess.along_axis);
  EXPECT_NEAR(1e3 * excess.length, 1.75 * 26 - 37, 0.6);
  EXPECT_NE(outgrown_tool(parison.scene, parison.state).find("wider than blow_mould at z = "), std::string::npos);
}

TEST(RoomInTool, glass_around_a_tool_is_not_too_wide_for_it) {
  // A ring of glass around the plunger, which fills the axis there.
  Stretched ring(1, 1);
  for (Point& x : ring.state.glass.mesh.nodes) x += Point(0.035, -0.03);
  Index plunger = 0;
  while (ring.scene.tools[plunger].name != "plunger") ++plunger;
  EXPECT_EQ(excess_size(ring.scene, ring.state, plunger).length, 0);
}

TEST(RoomInTool, a_stage_that_begins_with_such_glass_names_the_excess_and_not_the_thickness_of_the_iron) {
  Stretched parison(1, 2);
  parison.state.stage = parison.reheat + 1;
  const std::string failure = stage_precondition_failure(parison.scene, parison.state);
  EXPECT_NE(failure.find("which is 36.8 mm longer than its cavity"), std::string::npos) << failure;
}

}  // namespace
}  // namespace parison::forming
