// SPDX-License-Identifier: GPL-3.0-or-later
// The machine's timing in degrees, and quantities over the time of a stage as the case file gives them.
#include <gtest/gtest.h>

#include "../scene_text.hpp"
#include "forming/run/run.hpp"
#include "forming/scene/describe/describe_timing.hpp"

namespace parison::forming {
namespace {

/// 8 sections at 60 cuts a minute: 8 s for 360 deg. The second stage passes the end of the cycle.
const std::string timing = R"([timing]
cuts = "60 1/min"
sections = 8
event = { gob = "300 deg", plunger_up = "345 deg", plunger_down = "30 deg" }
[[stage]]
name = "rest"
from = "gob"
until = "plunger_up"
tools = ["plate"]
)";
const std::string own_stages = "[[stage]]\nname = \"rest\"\nduration = \"1 s\"\ntools = [\"plate\"]\n";

std::string timed(const std::string& table = timing, const std::string& press = "until = \"plunger_down\"") {
  return replaced("duration = \"2 s\"", press, replaced(own_stages, table));
}

std::string said(const std::string& text) {
  const std::string complaint = complaint_about(text);
  return complaint.substr(complaint.find(' ') + 1);
}

TEST(Timing, stages_follow_from_events_in_degrees_past_the_end_of_a_cycle) {
  const Scene scene = scene_of(timed());
  ASSERT_TRUE(scene.timing);
  EXPECT_DOUBLE_EQ(scene.timing->cycle, 8);
  EXPECT_NEAR(scene.stages[0].duration, 1, 1e-12);
  EXPECT_NEAR(scene.stages[1].duration, 1, 1e-12);
  EXPECT_NEAR(*scene.stages[1].end_time, 2, 1e-12);
  EXPECT_NEAR(scene.stages[1].timed->from, 345, 1e-9);
  const Scene faster =
      read_scene(write_scene(timed()), "draft", {"timing.cuts=120 1/min", "timing.event.plunger_up=330 deg"});
  EXPECT_NEAR(faster.stages[0].duration, 30.0 / 360 * 4, 1e-12);
  EXPECT_NEAR(faster.stages[1].duration, 60.0 / 360 * 4, 1e-12);
}

TEST(Timing, formulas_may_use_the_events_and_the_cycle_as_times) {
  const auto text = timed(timing, "duration = \"plunger_up - gob + 15/360*cycle\"\nend_speed = \"1 um/s\"");
  const Scene scene = scene_of(text);
  EXPECT_NEAR(scene.stages[1].duration, 1 + 8.0 / 24, 1e-12);
  EXPECT_FALSE(scene.stages[1].end_time);
}

TEST(Timing, check_prints_degrees_and_seconds_and_how_long_a_tool_is_in_use) {
  const std::string text = describe_timing(scene_of(timed()));
  for (const auto* line : {"timing                60 cuts a minute, 8 sections: a cycle of 8 s, 45 deg/s",
                           "  rest                300 to 345        0 to 1              plunger_up",
                           "  press               345 to 30         1 to 2              plunger_down",
                           "  plate               in use for 90 deg, 25 % of the cycle",
                           "  plunger             in use for 45 deg, 12 % of the cycle"})
    EXPECT_NE(text.find(line), text.npos) << line << "\n" << text;
  EXPECT_EQ(describe_timing(scene_of(small_scene)), "");
}

TEST(Timing, an_event_ends_its_stage_at_its_time_also_where_the_stage_before_ended_early) {
  const auto text =
      replaced("tools = [\"plate\"]\n", "tools = [\"plate\"]\nend = { surface_below = \"999 degC\" }\n", timed());
  const RunOutcome outcome = run(scene_of(text), {});
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  EXPECT_EQ(outcome.facts.stages[0].end_reason, "surface below its temperature");
  EXPECT_LT(outcome.facts.stages[0].end, 0.9);
  EXPECT_EQ(outcome.facts.stages[1].end_reason, "duration");
  EXPECT_NEAR(outcome.state.time, 2, 1e-9);
}

TEST(Timing, mistakes_have_their_sentences) {
  EXPECT_EQ(said(timed(timing, "until = \"plunger_dow\"")),
            "stage.until: \"plunger_dow\" was found (did you mean \"plunger_down\"?), allowed are plunger_down, gob, "
            "plunger_up")
      << "by angle";
  EXPECT_EQ(said(timed(timing, "duration = \"1 s\"\nuntil = \"gob\"")),
            "stage.until: a duration and an event were found, allowed is one of them");
  EXPECT_EQ(
      said(timed(timing, "from = \"plunger_down\"\nuntil = \"gob\"")),
      "stage.from: \"plunger_down\" is at 30 deg, but the stage before ends at 345 deg; allowed is an event there, or "
      "none");
  EXPECT_EQ(
      said(timed(replaced("from = \"gob\"\n", "", timing))),
      "stage.until: nothing says where the machine is at the stage's start, allowed is from = \"EVENT\" in the first "
      "stage");
  EXPECT_EQ(said(timed(replaced("345 deg", "375 deg", timing))),
            "timing.event.plunger_up: 375 deg was found, allowed are angles from 0 to 360 deg such as \"40 deg\"");
  EXPECT_EQ(said(timed(replaced("gob = \"300 deg\"", "gob = 300", timing)))
                .rfind("timing.event.gob: 17188.7 deg was found", 0),
            0u);
  EXPECT_EQ(said(timed(replaced("60 1/min", "60", timing))),
            "timing.cuts: \"60\" is a plain number, allowed is a number in a time such as \"12 1/min\"");
  EXPECT_EQ(said(timed(replaced("gob = ", "cycle = ", timing))),
            "timing.event.cycle: \"cycle\" is a name that formulas of the case have already, allowed is another");
  EXPECT_EQ(said(replaced("duration = \"2 s\"", "until = \"plunger_down\"")),
            "stage.until: an event was found, allowed only in a case with a table [timing]");
}

TEST(OverTheStage, pressure_force_and_speed_limit_may_be_lists) {
  const Scene scene =
      scene_of(replaced("force = \"-5 N\", speed_limit = \"10 mm/s\"",
                        "force = [[\"0 s\", \"0 N\"], [\"0.2 s\", \"-5 N\"]], speed_limit = [[\"0 s\", \"10 mm/s\"], "
                        "[\"1 s\", \"20 mm/s\"]]",
                        replaced("pressure.surface = \"0.1 bar\"",
                                 "pressure.surface = [[\"0 s\", \"0 bar\"], [\"0.2 s\", \"0.4 bar\"]]")));
  const Stage& press = scene.stages[1];
  EXPECT_NEAR(press.pressure.at("surface")(0.1), 2e4, 1e-9);
  EXPECT_NEAR(press.pressure.at("surface").mean(0.1, 0.3), 3.5e4, 1e-9);
  const auto& motion = std::get<ForceMotion>(press.tools[1].motion);
  EXPECT_NEAR(motion.force(0.1), -2.5, 1e-12);
  EXPECT_NEAR(motion.speed_limit(0.5), 0.015, 1e-12);
}

TEST(OverTheStage, mistakes_have_their_sentences) {
  const auto force = [](const std::string& value) { return said(replaced("force = \"-5 N\"", "force = " + value)); };
  EXPECT_EQ(force("[[\"0 s\", \"0 N\"], [\"1 s\", \"0 N\"]]"),
            "stage.motion.plunger.force: no force but zero was found, allowed is one other than zero");
  EXPECT_EQ(force("[[\"1 s\", \"-5 N\"], [\"0 s\", \"-8 N\"]]"),
            "stage.motion.plunger.force: \"0 s\" does not lie above the entry before, allowed are rising entries");
  EXPECT_EQ(force("[[\"1 s\", \"-5 bar\"]]"),
            "stage.motion.plunger.force: \"-5 bar\" is a pressure, allowed is a force such as \"8 kN\"");
  EXPECT_EQ(
      said(replaced("speed_limit = \"10 mm/s\"", "speed_limit = [[\"0 s\", \"0 mm/s\"]]")),
      "stage.motion.plunger.speed_limit: \"0 mm/s\" was found, allowed is a speed such as \"150 mm/s\", above zero");
  EXPECT_EQ(said(replaced("pressure.surface = \"0.1 bar\"", "pressure.surface = [\"0 s\", \"0.1 bar\"]")),
            "stage.pressure.surface: the text \"0 s\" was found, allowed is a list in brackets");
}

}  // namespace
}  // namespace parison::forming
