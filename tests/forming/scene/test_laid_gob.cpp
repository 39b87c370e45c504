// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "../bundled_scene.hpp"
#include "core/case/case_error.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/scene/describe/unusual.hpp"

namespace parison::forming {
namespace {

std::string glass_with(const std::string& gob) {
  return "glass={ material = \"flint\", temperature = \"1120 degC\", gob = { " + gob + " } }";
}

Scene with_gob(const std::string& name, const std::string& gob, std::vector<std::string> overrides = {}) {
  overrides.push_back(glass_with(gob));
  return bundled(name, "draft", overrides);
}

std::string complaint(const std::string& name, const std::string& gob, std::vector<std::string> overrides = {}) {
  try {
    with_gob(name, gob, std::move(overrides));
  } catch (const core::CaseError& error) {
    return error.what();
  }
  return "";
}

double lowest(const Scene& scene) {
  return scene.glass.profile.segments.front().start[1];
}

double highest(const Scene& scene) {
  return scene.glass.profile.segments.back().start[1];
}

TEST(LaidGob, it_comes_to_rest_on_the_plunger_or_the_pin) {
  EXPECT_DOUBLE_EQ(lowest(with_gob("uneven", "mass = \"219.6 g\", diameter = \"52 mm\", in = \"blank\"")), 0.02);
  EXPECT_DOUBLE_EQ(lowest(with_gob("bottle", "mass = \"125 g\", diameter = \"28 mm\", in = \"blank\"")), 0.012);
  EXPECT_DOUBLE_EQ(lowest(with_gob("tumbler", "mass = \"278 g\", diameter = \"54 mm\", in = \"mould\"")), 0);
}

TEST(LaidGob, in_a_narrow_neck_it_comes_to_rest_on_the_cone_of_the_blank) {
  const std::string cone = "tool.blank.boundary.inner.path=(13, 16) (14, 30) (17.5, 100) mm";
  const Scene scene = with_gob("bottle", "mass = \"125 g\", diameter = \"30 mm\", in = \"blank\"", {cone});
  const double slope = 3.5 / 70, centre = 30 + (15 * std::hypot(1, slope) - 14) / slope;
  EXPECT_NEAR(lowest(scene), 1e-3 * (centre - 15), 1e-7);
  const std::string described = describe_scene(scene);
  EXPECT_NE(described.find("carried at start by blank\n"), described.npos) << described;
}

TEST(LaidGob, its_sides_have_names_that_pressure_can_use) {
  const Scene down = with_gob("uneven", "mass = \"219.6 g\", diameter = \"52 mm\", in = \"blank\"",
                              {"stage.settle.pressure.top=0.1 bar"});
  EXPECT_EQ(down.glass.profile.boundary_names, (std::vector<std::string>{"side", "top", "axis"}));
  const Scene up = with_gob("uneven", "mass = \"219.6 g\", diameter = \"52 mm\", in = \"blank\"",
                            {"stage.settle.gravity=9.81 m/s2"});
  EXPECT_NEAR(highest(up), 0.098, 1e-9) << "with gravity along the axis it comes to rest on the baffle";
  const auto& segments = up.glass.profile.segments;
  EXPECT_EQ(up.glass.boundaries[static_cast<std::size_t>(segments[0].boundary_id)].name, "top");
  EXPECT_EQ(up.glass.boundaries[static_cast<std::size_t>(segments[1].boundary_id)].name, "side");
  EXPECT_EQ(up.glass.boundaries[static_cast<std::size_t>(segments[2].boundary_id)].name, "side");
}

TEST(LaidGob, an_outline_with_a_mass_is_laid_down_too) {
  const std::string drawn =
      "glass={ material = \"flint\", temperature = \"1130 degC\", gob = { mass = \"180 g\", in = \"blank\" }, boundary "
      "= "
      "[{ name = \"surface\", condition = \"contact\", path = [\"arc centre (0, 121) mm radius 11 mm from -90 deg to 0 "
      "deg\", \"(11.2, 126) (12.2, 156) (16.5, 209) (16.5, 228.5) mm\", \"arc centre (7.5, 228.5) mm radius 9 mm from "
      "0 "
      "deg to 90 deg\", \"(0, 237.5) mm\"] }, { name = \"axis\", condition = \"symmetry\", path = \"(0, 110) mm\" }] }";
  EXPECT_NEAR(lowest(bundled("nnpb", "draft", {drawn})), 0.01, 1e-9) << "drawn 100 mm higher";
}

TEST(LaidGob, one_that_finds_no_room_is_refused_with_what_is_too_much) {
  const std::string wide = complaint("bottle", "mass = \"125 g\", diameter = \"36 mm\", in = \"blank\"");
  EXPECT_NE(wide.find("glass.gob.diameter: a gob of 36 mm is 1.22 mm too wide to lie in"), wide.npos) << wide;
  const std::string slim = complaint("uneven", "mass = \"219.6 g\", diameter = \"36 mm\", in = \"blank\"");
  EXPECT_NE(slim.find("glass.gob.diameter: a gob of 36 mm is 103.6 mm long, "), slim.npos) << slim;
  EXPECT_NE(slim.find(" mm too long for \"blank\", allowed for this mass are "), slim.npos) << slim;
  const std::string heavy = complaint("tumbler", "mass = \"2 kg\", diameter = \"60 mm\", in = \"mould\"");
  EXPECT_NE(heavy.find("glass.gob.mass: 849 cm3 of glass find no room in \"mould\""), heavy.npos) << heavy;
}

TEST(LaidGob, it_may_stand_out_of_a_shallow_mould) {
  const std::string shallow = "tool.mould.boundary.inner.path=(0, 60) (30, 60) (37.17442, 95) mm";
  const Scene scene = with_gob(
      "tumbler", "mass = \"278 g\", diameter = \"50 mm\", in = \"mould\"",
      {shallow, "stage=[{ name = \"settle\", duration = \"0.2 s\", gravity = \"-9.81 m/s2\", tools = [\"mould\"] }]"});
  EXPECT_DOUBLE_EQ(lowest(scene), 0.060) << "its middle lies above the rim";
  EXPECT_GT(highest(scene), 0.130);
}

/// A blank of 16.6 cm3 above a neck of 16 mm, closed by its baffle: no capsule of 38 g finds room in it.
std::vector<std::string> small_blank(double plunger) {
  return {"tool.blank.boundary.inner.path=(11.3, 16) (11.6, 22) (13, 42) (13, 53) (0, 53) mm",
          "tool.plunger.position=" + std::to_string(plunger) + " mm"};
}

TEST(LaidGob, without_a_diameter_it_takes_the_shape_of_its_room) {
  const std::string path =
      "tool.blank.boundary.inner.path=(12.6, 16) (12, 26) (13, 56) (17.2, 109) (17.2, 132) (0, 144) mm";
  const Scene scene = with_gob("nnpb", "mass = \"170 g\", in = \"blank\"", {path});
  const auto& profile = scene.glass.profile;
  EXPECT_NEAR(outline_volume(profile, scene.geometry) * scene.glass.flow->density, 0.170, 1e-9);
  EXPECT_EQ(profile.boundary_names, (std::vector<std::string>{"side", "top", "axis"}));
  EXPECT_NEAR(lowest(scene), 0.010, 1e-4) << "it stands on the plunger";
  double low_of_top = HUGE_VAL, high_of_side = -HUGE_VAL;
  for (const core::Segment& segment : profile.segments) {
    const double z = segment.start[1], wall = z > 0.056 ? 13 + 4.2 * (1e3 * z - 56) / 53 : 12 + (1e3 * z - 26) / 30;
    if (z > 0.030 && z < 0.100 && segment.boundary_id == 0)
      EXPECT_NEAR(1e3 * segment.start[0], wall, 0.15) << "beside the wall at " << 1e3 * z << " mm";
    if (segment.boundary_id == 1) low_of_top = std::min(low_of_top, segment.end[1]);
    if (segment.boundary_id == 0) high_of_side = std::max(high_of_side, segment.end[1]);
  }
  EXPECT_GE(low_of_top, high_of_side);
  const Scene turned = with_gob("uneven", "mass = \"219.6 g\", in = \"blank\"", {"stage.settle.gravity=9.81 m/s2"});
  const core::Segment& low = turned.glass.profile.segments.front();
  EXPECT_EQ(turned.glass.boundaries[static_cast<std::size_t>(low.boundary_id)].name, "top");
  EXPECT_NEAR(highest(turned), 0.098, 1e-4) << "with gravity along the axis it comes to rest on the baffle";
}

TEST(LaidGob, without_a_diameter_it_does_not_take_the_bore_of_the_plunger_for_its_room) {
  const Scene scene = with_gob("tumbler", "mass = \"278 g\", in = \"mould\"");
  EXPECT_NEAR(lowest(scene), 0, 1e-4);
  EXPECT_LT(highest(scene), 0.070) << "below the plunger";
}

TEST(LaidGob, a_tool_that_comes_down_on_it_later_is_told) {
  const auto notes = [](const std::string& blow) {
    return describe_unusual(with_gob("bottle", "mass = \"125 g\", diameter = \"28 mm\", in = \"blank\"", {blow}));
  };
  const std::string unpressed = notes("stage.settle_blow.pressure.top=0 bar");
  EXPECT_NE(unpressed.find("\"baffle\", which comes in stage \"corkage\", reaches "), unpressed.npos) << unpressed;
  EXPECT_EQ(notes("stage.settle_blow.pressure.top=1 bar"), "") << "the air presses it down before";
}

TEST(LaidGob, a_mass_for_which_no_capsule_finds_room_is_told_what_does) {
  const std::string capsule =
      complaint("nnpb", "mass = \"60 g\", diameter = \"22 mm\", in = \"blank\"", small_blank(6));
  EXPECT_NE(
      capsule.find("glass.gob.mass: 25.47 cm3 of glass find no room in \"blank\" with the tools of the first stage, "
                   "whatever their diameter; allowed are up to "),
      capsule.npos)
      << capsule;
  EXPECT_NE(capsule.find(" g without a diameter, for a gob that takes the shape of \"blank\", or a tool that starts "
                         "further away or comes in a later stage"),
            capsule.npos)
      << capsule;
}

TEST(LaidGob, mistakes_have_their_sentences) {
  EXPECT_NE(
      complaint("bottle", "mass = \"125 g\", diameter = \"28 mm\", in = \"mould\"").find("glass.gob.in: \"mould\""),
      std::string::npos);
  EXPECT_NE(complaint("bottle", "mass = \"125 g\", diameter = \"28 mm\", in = \"blank\", at = \"(0, 3) mm\"")
                .find("\"at\" and \"in\" were found, allowed is one of them"),
            std::string::npos);
  EXPECT_NE(complaint("bottle", "mass = \"125 g\", diameter = \"28 mm\"").find("neither \"in\" nor \"at\" was found"),
            std::string::npos);
  EXPECT_NE(complaint("bottle", "mass = \"125 g\", diameter = \"28 mm\", in = \"blank\"", {"stage.load.gravity=0 m/s2"})
                .find("the first stage, \"load\", has no gravity that lays the gob down"),
            std::string::npos);
}

TEST(LaidGob, a_plunger_that_leaves_it_no_room_is_told_where_it_would) {
  const std::string near =
      complaint("tumbler", "mass = \"278 g\", diameter = \"54 mm\", in = \"mould\"", {"tool.plunger.position=50 mm"});
  EXPECT_NE(near.find("\"plunger\" overlaps the glass at the start by "), near.npos) << near;
  EXPECT_NE(near.find("with `position = \"69.5"), near.npos) << near;
}

TEST(LaidGob, glass_that_touches_no_tool_is_told_with_how_far_it_falls) {
  const std::string notes =
      describe_unusual(with_gob("uneven", "mass = \"219.6 g\", diameter = \"52 mm\", at = \"(0, 25) mm\""));
  EXPECT_NE(
      notes.find("nothing carries the glass at the start of stage \"settle\": it touches no tool and falls by 5 mm "
                 "until it meets \"plunger\" at "),
      notes.npos)
      << notes;
  const std::string described =
      describe_scene_briefly(with_gob("uneven", "mass = \"219.6 g\", diameter = \"52 mm\", at = \"(0, 25) mm\""));
  EXPECT_NE(described.find("carried at start by nothing\n"), described.npos) << described;
}

}  // namespace
}  // namespace parison::forming
