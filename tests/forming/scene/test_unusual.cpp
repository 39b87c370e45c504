// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../bundled_scene.hpp"
#include "../scene_text.hpp"
#include "forming/scene/describe/unusual.hpp"

namespace parison::forming {
namespace {

std::string notes_on(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return describe_unusual(bundled(name, "draft", overrides));
}

void expect_note(const std::string& name, const std::string& override, const std::string& part) {
  const std::string notes = notes_on(name, {override});
  EXPECT_NE(notes.find(part), notes.npos) << name << " with " << override << " says: " << notes;
}

TEST(Unusual, no_bundled_case_is_told_of) {
  for (const char* name :
       {"jar", "bottle", "tumbler", "nnpb", "flute", "uneven", "sag", "vial", "contact_cylinders", "shell_inflation"})
    EXPECT_EQ(notes_on(name), "") << name;
}

TEST(Unusual, a_gob_of_kelvins_that_were_meant_as_degrees_is_told) {
  expect_note("jar", "glass.temperature=1120 K", "starts at 846.9 degC (1120 K)");
  expect_note("jar", "glass.temperature=1120 K", "was \"1120 degC\" meant?");
  expect_note("jar", "glass.temperature=1300 degC", "usual are gobs of 1050 to 1200 degC");
}

TEST(Unusual, a_press_cavity_that_a_boundary_without_contact_closes_is_told) {
  const std::string early = "tool.ring.boundary.under.path=(33.5, 90) (40, 90) mm";  // a hole wider than the plunger
  const std::vector<std::string> wide{early, "tool.ring.boundary.top.path=(33.5, 115) mm",
                                      "tool.ring.boundary.hole.path=(33.5, 90) mm",
                                      "tool.plunger.boundary.outer.path=(0, 0) (27, 0) (32, 85) (34, 95) (34, 170) mm"};
  const std::string notes = notes_on("tumbler", wide);
  EXPECT_NE(notes.find("once full, the cavity of stage \"press\" has "), notes.npos) << notes;
  EXPECT_NE(notes.find(" mm of boundary \"hole\" of \"ring\" for its wall, from (33.5, "), notes.npos) << notes;
  auto kept_out = wide;
  kept_out.push_back("tool.ring.boundary.hole.condition=contact");
  EXPECT_EQ(notes_on("tumbler", kept_out).find("for its wall"), std::string::npos);
}

TEST(Unusual, a_tool_at_room_temperature_is_told) {
  expect_note("jar", "tool.blank.temperature=20 degC", "\"blank\" starts at 20 degC; usual are 400 to 530 degC");
}

TEST(Unusual, a_tool_above_the_melting_point_of_iron_is_told_in_any_case) {
  expect_note("jar", "tool.blank.temperature=4400 degC",
              "\"blank\" starts at 4400 degC, but grey iron melts at 1150 degC and bronze below; usual are 400 to 530");
  expect_note("sag", "tool.ring.temperature=1200 degC", "\"ring\" starts at 1200 degC, but grey iron melts");
}

TEST(Unusual, a_force_away_from_the_glass_is_told_in_both_directions) {
  expect_note(
      "tumbler", "stage.press.motion.plunger.force=10 kN",
      "drives \"plunger\" with 10 kN away from the glass; a force counts along the axis, a press towards smaller z is "
      "negative: was \"-10 kN\" meant?");
  expect_note("jar", "stage.press.motion.plunger.force=-8 kN", "was \"8 kN\" meant?");
}

TEST(Unusual, a_force_in_newtons_that_were_meant_as_kilonewtons_is_told) {
  const std::string notes =
      notes_on("jar", {"stage.press.motion.plunger.force=8 N", "stage.dwell.motion.plunger.force=0.15 N"});
  EXPECT_NE(notes.find("the largest force on \"plunger\" is 8 N (stage \"press\"), 0.035 bar over its face"),
            notes.npos)
      << notes;
}

TEST(Unusual, gravity_that_is_not_turned_over_with_the_parison_is_told) {
  const std::vector<std::string> forgotten{"stage.reheat.gravity=-9.81 m/s2", "stage.run.gravity=-9.81 m/s2",
                                           "stage.blow.gravity=-9.81 m/s2"};
  for (const char* name : {"bottle", "jar"}) {
    std::vector<std::string> overrides = forgotten;
    if (name == std::string("jar")) overrides.push_back("stage.hold.gravity=-9.81 m/s2");
    const std::string notes = notes_on(name, overrides);
    EXPECT_NE(notes.find("gravity acts in stage \"blow\" as in"), notes.npos) << name << " says: " << notes;
  }
}

TEST(Unusual, the_way_to_the_cold_container_is_not_told_of) {
  for (const char* name : {"jar", "bottle"}) EXPECT_EQ(notes_on(name, {"cooling=standard"}), "") << name;
}

TEST(Unusual, a_blow_of_seven_bar_is_told) {
  expect_note("jar", "stage.blow.pressure.inner=7 bar", "stage \"blow\" blows with 7 bar on \"inner\"; usual are 0.3");
}

TEST(Unusual, a_reheat_of_twenty_minutes_is_told) {
  expect_note("jar", "stage.reheat.duration=1200 s", "stage \"reheat\" takes 1200 s; usual are 10 to 13.4 s");
}

TEST(Unusual, a_mould_too_large_for_its_glass_is_told_by_its_mean_wall) {
  const Scene jar = bundled("jar", "draft");
  ContainerPlan plan = *plan_container(jar);
  ASSERT_TRUE(plan.mould_range);
  EXPECT_NEAR(1e3 * *inside_height(plan), 129, 0.5);
  const std::string notes =
      notes_on("jar", {"tool.blow_mould.boundary.inner.path=(31, 14) (37, 26) (37, 950) (0, 950) mm",
                       "tool.blow_mould.boundary.axis.path=(0, 975) mm",
                       "tool.blow_mould.boundary.outer.path=(62, 975) (62, 14) mm"});
  EXPECT_NE(notes.find("950 mm high, make a wall of about 0.42 mm on average; usual are 1.8 to 5.8 mm"), notes.npos)
      << notes;
}

TEST(Unusual, a_fill_level_below_the_bottom_is_told_and_has_no_volume) {
  expect_note("tumbler", "output.fill_level=300 mm", "the fill level is 300 mm below the rim, but the container is ");
  EXPECT_FALSE(plan_container(bundled("tumbler", "draft", {"output.fill_level=300 mm"}))->filled);
}

TEST(Unusual, a_plunger_wider_than_the_ring_is_told_with_the_place_and_by_how_much) {
  const std::string notes = notes_on(
      "jar", {"tool.ring.boundary.inner.path=(26, 0) (31, 14) mm", "tool.ring.boundary.bottom.path=(26, 0) mm"});
  EXPECT_NE(
      notes.find("\"plunger\" runs into \"ring\" on its way: from 75.84 mm on it is wider than the opening there, "
                 "by up to 1 mm, near (26, 0) mm"),
      notes.npos)
      << notes;
}

TEST(Unusual, a_plunger_that_slides_through_a_guide_plate_or_a_seal_is_not_told) {
  EXPECT_EQ(notes_on("jar"), "") << "its plate is drawn without a hole";
  EXPECT_EQ(notes_on("tumbler"), "") << "its ring has a hole 1 mm narrower than the plunger, insulated";
  const std::string notes = notes_on("tumbler", {"tool.ring.boundary.hole.condition=contact"});
  EXPECT_NE(notes.find("\"plunger\" runs into \"ring\""), notes.npos) << "a hole that shapes glass: " << notes;
}

TEST(Unusual, a_parison_longer_than_the_mould_is_told) {
  const std::string notes =
      notes_on("jar", {"tool.blow_mould.boundary.inner.path=(31, 14) (37, 26) (37, 91) (0, 91) mm"});
  EXPECT_NE(notes.find("the parison as stage \"press\" presses it is too large for \"blow_mould\" of stage \"run\": it "
                       "would reach 7 mm into that tool near ("),
            notes.npos)
      << notes;
}

TEST(Unusual, a_parison_of_blow_and_blow_wider_than_the_mould_is_told) {
  const std::string notes =
      notes_on("bottle", {"tool.mould.boundary.inner.path=(13, 16) (14, 40) (25, 60) (25, 111) (0, 109) mm"});
  EXPECT_NE(notes.find("the parison as stage \"counter_blow\" blows it is too large for \"mould\" of stage \"run\": it "
                       "would reach "),
            notes.npos)
      << notes;
}

TEST(Unusual, glass_that_lies_at_a_face_without_contact_is_told_with_tool_and_boundary) {
  const auto notes = [](const std::string& text) { return describe_unusual(scene_of(text)); };
  const std::string said = notes(replaced("(0, 0) mm\", condition = \"contact\"",
                                          "(15, 0) mm\", condition = \"contact\" },\n  { name = \"middle\", path = "
                                          "\"(0, 0) mm\", condition = \"insulated\""));
  EXPECT_NE(said.find("the glass lies at boundary \"middle\" of \"plate\", which has no contact"), said.npos) << said;
  EXPECT_EQ(notes(small_scene).find("no contact"), std::string::npos) << notes(small_scene);
}

TEST(Unusual, a_plunger_that_stops_with_less_glass_before_it_than_a_film_may_have_is_told_with_the_keys) {
  const auto glass = [](const std::string& film) {
    return "glass={ material = \"flint\", temperature = \"1100 degC\", film = { " + film +
           " }, gob = { mass = \"214.38 g\", diameter = \"50 mm\", at = \"(0, 0) mm\" } }";
  };
  expect_note("tumbler", glass(""),
              "stops for this mass, at 0.2215 mm, the glass is 0.22 mm thick from radius 0 to 24");
  expect_note("tumbler", glass(""), "thinner than film.min_thickness = 0.3 mm of the glass: the run will end there");
  EXPECT_EQ(notes_on("tumbler", {glass("then = \"freeze\"")}), "");
  EXPECT_EQ(notes_on("tumbler", {glass("min_thickness = \"0.2 mm\"")}), "");
}

}  // namespace
}  // namespace parison::forming
