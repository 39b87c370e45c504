// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "../pot_scene.hpp"
#include "../scene_text.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/run/run.hpp"
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

/// The pot with a plunger that slides in it, its face a flat cone: full at an offset of -3.255 mm.
const std::string loose_pot = replaced("(0, 10) (12, 10) mm", "(0, 10) (11.99, 10.3) mm",
                                       replaced("(12, 20) (0, 20) mm", "(11.99, 20) (0, 20) mm", pot));

/// The pot when its press of 0.4 s is over: the plunger at an offset, m, and its speed, m/s.
State end_of_press(const Scene& scene, double offset, double velocity) {
  State state = initial_state(scene);
  state.stage_time = scene.stages[0].duration;
  state.tools[1].offset = offset;
  state.tools[1].velocity = velocity;
  state.tools[1].force = -3000;
  return state;
}

TEST(Warnings, a_plunger_short_of_the_full_cavity_is_told_with_what_its_speed_says_of_more_time) {
  const Scene scene = scene_of(loose_pot);
  const auto said = [&](double velocity) {
    return unfilled_cavity(scene, end_of_press(scene, -2e-3, velocity)).value_or("nothing");
  };
  const std::string short_of =
      "stage press ended (duration) before the glass filled its cavity: plunger stood at -2.00 mm, 1.26 mm short of "
      "-3.26 mm, where the cavity is full, and no glass touched pot. ";
  const std::string remedy = "more force, a hotter gob or less friction";
  EXPECT_EQ(said(-1e-3), short_of +
                             "Its force of 3000 N still moved it at 1 mm/s, by which it comes at most 0.4 mm "
                             "further in as long a stage again: it takes " +
                             remedy);
  EXPECT_EQ(said(-0.01),
            short_of +
                "Its force of 3000 N still moved it at 10 mm/s: a later end of the stage brings it further, or " +
                remedy);
  EXPECT_EQ(said(1e-6), short_of + "Its force of 3000 N moved it no further: it takes " + remedy);
  EXPECT_EQ(said(-0.05), short_of +
                             "It still moved at its speed_limit of 50 mm/s: a later end of the stage or a "
                             "higher speed_limit brings it further");
}

TEST(Warnings, only_a_closed_cavity_that_is_not_full_is_told_of_and_not_by_a_force_that_only_holds) {
  const std::string hold =
      "[[stage]]\nname = \"hold\"\nduration = \"1 s\"\ntools = [\"pot\", \"plunger\"]\n"
      "motion.plunger = { force = \"-100 N\", speed_limit = \"50 mm/s\" }\n[material.glass]";
  const Scene scene = scene_of(replaced("[material.glass]", hold, loose_pot));
  const auto said = [&](Index stage, double offset) {
    State state = end_of_press(scene, offset, -1e-3);
    state.stage = stage;
    state.stage_time = scene.stages[static_cast<std::size_t>(stage)].duration;
    return unfilled_cavity(scene, state);
  };
  EXPECT_EQ(said(0, -3.254e-3), "");
  EXPECT_EQ(said(1, -3.254e-3), "") << "what the press has left is filled by now";
  EXPECT_EQ(said(1, -2e-3), std::nullopt);
  EXPECT_NE(said(0, -2e-3), std::nullopt);
  State open = initial_state(scene_of(small_scene));
  open.stage = 1;
  EXPECT_EQ(unfilled_cavity(scene_of(small_scene), open), std::nullopt);
}

TEST(Warnings, a_stage_that_a_short_press_keeps_from_beginning_names_the_short_tool_first_and_once) {
  const std::string named =
      "[[stage]]\nname = \"open\"\nduration = \"1 s\"\ngravity = \"-9.81 m/s2\"\ntools = [\"pot\"]\n"
      "name_boundary = [{ name = \"top\", from = \"(12, 6.94) mm\", to = \"(0, 6.94) mm\" }]\n[material.glass]";
  const std::string text =
      replaced("duration = \"0.4 s\"", "duration = \"0.02 s\"", replaced("[material.glass]", named, loose_pot));
  const RunFacts facts = run_in_folder(scene_of(text), tests::absent_folder()).facts;
  const auto press = facts.reason.find("s: stage press ended (duration) before the glass filled its cavity: plunger");
  const auto stage = facts.reason.find("; in this stage name_boundary top: \"");
  ASSERT_NE(press, std::string::npos) << facts.reason;
  ASSERT_NE(stage, std::string::npos) << facts.reason;
  EXPECT_LT(press, stage);
  EXPECT_TRUE(facts.warnings.empty()) << facts.warnings.front();
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

/// A rod of soft glass that hangs in stage "hang", after other stages; further lines of that
/// stage may follow.
std::string hanging_rod(const std::string& before) {
  return R"(case = "rod"
geometry = "axisymmetric"
[material.soft]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "100 Pa.s" }
[glass]
material = "soft"
boundary = [
  { name = "axis", path = "(0, 20) (0, 0) mm", condition = "symmetry" },
  { name = "outer", path = "(4, 0) (4, 20) mm", condition = "air" },
  { name = "top", path = "(0, 20) mm", condition = "fixed" },
]
)" + before +
         R"([[stage]]
name = "hang"
duration = "30 s"
gravity = "-9.81 m/s2"
)";
}

const std::string falls = "s: the glass stretches under its weight alone until it falls, near (";

TEST(Warnings, glass_that_stretches_under_gravity_alone_is_not_told_as_a_film_nor_advised_less_pressure) {
  const std::string reason = run(scene_of(hanging_rod(""))).facts.reason;
  EXPECT_NE(reason.find(falls), reason.npos) << reason;
  EXPECT_EQ(reason.find("less pressure"), reason.npos) << reason;
}

TEST(Warnings, glass_that_falls_after_a_stage_with_pressure_is_told_so_and_the_run_stops_before_it_is_absurdly_fast) {
  const std::string puffed =
      hanging_rod("[[stage]]\nname = \"puff\"\nduration = \"1 ms\"\npressure.outer = \"1 mbar\"\n");
  for (const std::string& rest :
       {std::string(), std::string("pressure.outer = [[\"0 s\", \"1 mbar\"], [\"10 ms\", \"0 bar\"]]\n")}) {
    const std::string reason = run(scene_of(puffed + rest)).facts.reason;
    const auto told = reason.find(falls), speed = reason.find(" mm at ");
    ASSERT_NE(told, reason.npos) << reason;
    EXPECT_LT(std::stod(reason.substr(speed + 7)), 200) << reason;
  }
}

}  // namespace
}  // namespace parison::forming
