// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "../scene_text.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/run/stage.hpp"
#include "forming/run/warnings.hpp"
#include "forming/state/initial_state.hpp"

namespace parison::forming {
namespace {

/// The warning of a press whose plunger moves at a speed, m/s, when its time is over.
std::string said_of_plunger(double speed, bool touches, bool has_moved) {
  const Scene scene =
      scene_of(replaced("speed_limit = \"10 mm/s\" }", "speed_limit = \"10 mm/s\" }\nend_speed = \"1 mm/s\""));
  State state = initial_state(scene);
  state.stage = 1;
  state.tools[1].velocity = speed;
  state.has_moved = has_moved;
  if (touches) state.glass.contact_tool.back() = 1;
  const Warnings warnings = moving_tool_warnings(scene, state);
  return warnings.empty() ? "" : warnings.front();
}

TEST(Warnings, a_tool_that_still_moves_against_the_glass_is_advised_more_time_or_force) {
  const std::string said = said_of_plunger(-0.006, true, true);
  EXPECT_NE(said.find("plunger still moved at 6 mm/s, above its end_speed of 1 mm/s"), said.npos) << said;
  EXPECT_NE(said.find("A longer duration or more force"), said.npos) << said;
  EXPECT_EQ(said.find("less force"), said.npos) << said;
}

TEST(Warnings, a_tool_that_moves_away_from_the_glass_is_advised_to_turn_its_force) {
  const std::string said = said_of_plunger(0.01, false, true);
  EXPECT_NE(said.find("it touches no glass"), said.npos) << said;
  EXPECT_NE(said.find("turn the sign of motion.plunger.force"), said.npos) << said;
}

TEST(Warnings, a_force_that_never_moves_its_tool_is_told_as_too_weak) {
  const std::string said = said_of_plunger(-1e-5, true, false);
  EXPECT_NE(said.find("a force of up to 5 N hardly moves it, and the glass may not be pressed"), said.npos) << said;
  EXPECT_EQ(said_of_plunger(-1e-5, true, true), "") << "it has come to rest";
}

TEST(Warnings, glass_that_has_no_room_in_a_stage_is_told_with_the_drawings_before_the_sagging) {
  const Scene scene = scene_of(small_scene);
  State state = initial_state(scene);
  state.stage = 1;
  state.tools[1].offset = 0.008;
  const std::string said = stage_precondition_failure(scene, state);
  const auto drawn = said.find("Where the blank as drawn is longer"), sagged = said.find("a parison that has sagged");
  EXPECT_EQ(said.rfind("active tool plunger overlaps the glass by 2 mm", 0), 0u) << said;
  EXPECT_LT(drawn, sagged) << said;
  EXPECT_NE(said.find("motion.plunger = { offset = [...] }"), said.npos) << said;
}

TEST(Warnings, one_fold_and_one_torn_piece_are_told_as_one) {
  State state;
  state.totals.remeshing.laps = 1;
  state.totals.remeshing.torn = 1;
  const Warnings warnings = remeshing_warnings(state);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0].rfind("the glass folded onto itself at one point. The fold was closed", 0), 0u) << warnings[0];
  EXPECT_EQ(warnings[1].rfind("one piece of glass, ", 0), 0u) << warnings[1];
}

TEST(Warnings, a_film_that_bursts_is_told_first_with_its_place_and_the_numerics_last) {
  const auto outcome = run_in_folder(scene_of(R"(case = "thimble"
geometry = "axisymmetric"
[material.soft]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e3 Pa.s" }
[glass]
material = "soft"
boundary = [
  { name = "outer", path = "(0, 0) (4, 0) (4, 20) mm", condition = "contact" },
  { name = "top", path = "(3, 20) mm", condition = "fixed" },
  { name = "inner", path = "(3, 1) (0, 1) mm", condition = "air" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" },
]
[[stage]]
name = "blow"
duration = "1 s"
pressure.inner = "10 bar"
)"),
                                     tests::absent_folder());
  const std::string& reason = outcome.facts.reason;
  EXPECT_FALSE(outcome.facts.completed);
  const auto film = reason.find("s: a film of glass bursts near ("), numerics = reason.find("(numerics: ");
  EXPECT_NE(film, reason.npos) << reason;
  EXPECT_NE(numerics, reason.npos) << reason;
  EXPECT_LT(film, numerics) << reason;
}

}  // namespace
}  // namespace parison::forming
