// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "../scene_text.hpp"
#include "core/case/case_file.hpp"

namespace parison::forming {
namespace {

const std::string cases = PARISON_SOURCE_DIR "/cases/";

/// Volume of revolution of an outline by its chords, m3.
double revolved_volume(const core::Profile& profile) {
  const auto points = core::polyline(profile, 5e-5, 1e-8);
  double volume = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto &a = points[i], &b = points[(i + 1) % points.size()];
    volume += M_PI / 3 * (b[1] - a[1]) * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]);
  }
  return volume;
}

TEST(Scene, a_probe_behind_a_boundary_follows_the_drawing) {
  const auto probe = [](const std::string& width) {
    const std::string text = replaced("(20, 0) (20, 10)", "(" + width + ", 0) (" + width + ", 10)");
    return scene_of(replaced("point = \"(0, 5) mm\"",
                             "boundary = \"surface\"\ndepth = \"2 mm\"\npoint = \"(19.5, 6) mm\"", text))
        .probes[0]
        .point;
  };
  EXPECT_NEAR((probe("20") - core::Point(0.018, 0.006)).norm(), 0, 1e-12);
  EXPECT_NEAR((probe("21") - core::Point(0.019, 0.006)).norm(), 0, 1e-12);
}

TEST(Scene, lengths_of_the_presets_grow_with_a_body_beyond_200_cm3) {
  const std::vector<std::string> large{"dimension.r_disc=100 mm", "dimension.thickness=12 mm"};
  const Accuracy preset = accuracy_preset("draft"), disc = read_scene(cases + "sag", "draft").accuracy;
  EXPECT_EQ(disc.surface_size, preset.surface_size);
  const Accuracy sized = read_scene(cases + "sag", "draft", large).accuracy;
  const double scale = std::cbrt(M_PI * 100 * 100 * 12 / 200e3);
  EXPECT_NEAR(sized.surface_size / preset.surface_size, scale, 1e-6);
  EXPECT_NEAR(sized.tool_contact_size / preset.tool_contact_size, scale, 1e-6);
  EXPECT_EQ(sized.max_step, preset.max_step);
  auto own = large;
  own.push_back("numerics.surface_size=1.2 mm");
  EXPECT_EQ(read_scene(cases + "sag", "draft", own).accuracy.surface_size, 1.2e-3);
}

TEST(Scene, the_contact_cylinders_carry_heat_and_do_not_flow) {
  const auto scene = read_scene(cases + "contact_cylinders", "standard");
  EXPECT_TRUE(scene.has_heat());
  EXPECT_FALSE(scene.has_flow());
  ASSERT_EQ(scene.tools.size(), 1u);
  EXPECT_DOUBLE_EQ(scene.tools[0].initial_temperature, 758.15);
  EXPECT_DOUBLE_EQ(std::get<contact::ConstantConductance>(scene.interfaces.at(0).law).h, 5000);
  ASSERT_TRUE(scene.glass.mesh.mapped);
  EXPECT_EQ(scene.glass.mesh.mapped->along_first, 20);
  EXPECT_EQ(scene.probes.size(), 4u);
  EXPECT_NEAR(core::signed_area(scene.tools[0].profile), 20e-3 * 30e-3, 1e-15);
}

TEST(Scene, the_shell_flows_and_carries_no_heat) {
  const auto scene = read_scene(cases + "shell_inflation/case.toml", "draft");
  EXPECT_FALSE(scene.has_heat());
  EXPECT_TRUE(scene.has_flow());
  EXPECT_TRUE(scene.tools.empty());
  EXPECT_DOUBLE_EQ(scene.stages.at(0).pressure.at("inner")(0), 1e5);
  EXPECT_NEAR(core::signed_area(scene.glass.profile), M_PI / 4 * (15e-3 * 15e-3 - 10e-3 * 10e-3), 1e-15);
}

TEST(Scene, the_jar_is_a_gob_of_220_grams_among_five_tools) {
  const auto scene = read_scene(cases + "jar", "draft");
  EXPECT_TRUE(scene.has_heat() && scene.has_flow());
  EXPECT_NEAR(scene.glass.density() * revolved_volume(scene.glass.profile), 0.22, 1e-5);
  EXPECT_EQ(scene.tools.size(), 5u);
  EXPECT_EQ(scene.interfaces.size(), 5u);
  ASSERT_EQ(scene.stages.size(), 7u);
  const auto& press = scene.stages[1];
  EXPECT_DOUBLE_EQ(std::get<ForceMotion>(press.tools.back().motion).force(0), 8000);
  EXPECT_EQ(scene.stages[3].named_boundaries.at(0).touched, std::optional<Index>(scene.stages[1].tools.back().tool));
  EXPECT_DOUBLE_EQ(scene.stages[6].pressure.at("inner")(0), 0.35e5);
  for (const auto& tool : scene.tools) EXPECT_GT(core::signed_area(tool.profile), 0) << tool.name;
  EXPECT_DOUBLE_EQ(temperature_range(scene).min_temperature, 50 + 273.15);
  EXPECT_DOUBLE_EQ(temperature_range(scene).max_temperature, 1150 + 273.15);
}

TEST(Scene, the_jars_cavity_is_full_when_the_plunger_stands_at_91_millimetres) {
  const auto scene = read_scene(cases + "jar", "draft");
  std::vector<core::Point> cavity;
  const auto volume_below = [](const Body& body, const std::string& boundary, double offset) {
    double volume = 0;
    for (const auto& segment : body.profile.segments)
      for (int i = 0; i < 400 && body.profile.boundary_names[segment.boundary_id] == boundary; ++i) {
        const auto a = core::point_at(segment, i / 400.0), b = core::point_at(segment, (i + 1) / 400.0);
        if (a[1] + offset < -1e-9 && b[1] + offset < -1e-9) continue;
        // The one line that crosses z = 0 is a cylinder: cut it there.
        const double low = std::max(0.0, a[1] + offset), high = std::max(0.0, b[1] + offset);
        volume += M_PI / 3 * (high - low) * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]);
      }
    return std::abs(volume);
  };
  const double full = volume_below(scene.tools[0], "inner", 0) + volume_below(scene.tools[2], "inner", 0) -
                      volume_below(scene.tools[3], "outer", 91.065e-3);
  EXPECT_NEAR(full, revolved_volume(scene.glass.profile), 5e-8);
}

TEST(Scene, the_bundled_expectations_are_readable) {
  for (const char* name : {"contact_cylinders", "shell_inflation", "jar"}) {
    const auto file = core::read_case_file(cases + name + "/expect.toml");
    const core::CaseTable root(file.root, {"expect"});
    EXPECT_GE(root.tables("expect").size(), 3u);
    for (const auto* node : root.tables("expect")) {
      const core::CaseTable expect(*node, {"quantity", "history", "time", "min", "max", "value", "tolerance"});
      EXPECT_NE(expect.find("quantity") == nullptr, expect.find("history") == nullptr);
      EXPECT_EQ(expect.find("value") == nullptr, expect.find("tolerance") == nullptr);
    }
  }
}

TEST(Scene, a_clockwise_outline_is_turned_and_its_boundaries_stay_with_their_lines) {
  const std::string axis = "(0, 0) mm\", condition = \"symmetry\"";
  const std::string surface = "(0, 0) (20, 0) (20, 10) (0, 10) mm\", condition = \"contact\"";
  const auto scene = scene_of(replaced(surface, "(0, 0) (0, 10) mm\", condition = \"symmetry\"",
                                       replaced(axis, "(20, 10) (20, 0) (0, 0) mm\", condition = \"contact\"",
                                                replaced("pressure.surface", "pressure.axis"))));
  const auto& profile = scene.glass.profile;
  EXPECT_NEAR(core::signed_area(profile), 2e-4, 1e-15);
  for (const auto& segment : profile.segments) {
    const bool on_axis = segment.start[0] == 0 && segment.end[0] == 0;
    EXPECT_EQ(profile.boundary_names[segment.boundary_id], on_axis ? "surface" : "axis");
  }
}

TEST(Scene, an_outline_may_come_from_a_csv_file) {
  const auto text = replaced("path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\"", "csv = \"outline.csv\"");
  std::ofstream(write_scene(text) + "/outline.csv") << "r_mm,z_cm\n0,0\n20,0\n20,1\n0,1\n";
  EXPECT_NEAR(core::signed_area(scene_of(text).glass.profile), 2e-4, 1e-15);
  std::ofstream(write_scene(text) + "/outline.csv") << "r_mm,z_cm\n0,0\n20,x\n";
  EXPECT_NE(complaint_about(text).find("outline.csv:3: glass.boundary.csv: "), std::string::npos);
}

TEST(Scene, the_headings_of_a_csv_outline_say_which_column_is_which) {
  const auto text = replaced("path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\"", "csv = \"outline.csv\"");
  const auto volume = [&](const std::string& table) {
    std::ofstream(write_scene(text) + "/outline.csv") << table;
    return revolved_volume(scene_of(text).glass.profile);
  };
  const double disc = M_PI * 4e-4 * 0.01;
  EXPECT_NEAR(volume("r_mm,z_mm\n0,0\n20,0\n20,10\n0,10\n"), disc, 1e-15);
  EXPECT_NEAR(volume("z_mm, r_cm\n0,0\n0,2\n10,2\n10,0\n"), disc, 1e-15);
  EXPECT_NEAR(volume("\xEF\xBB\xBFy_cm,x_mm\n0,0\n0,20\n1,20\n1,0\n"), disc, 1e-15);
  for (const char* heading : {"r_mm,r_mm", "z_mm,y_mm", "a_mm,z_mm", "r_mm,T_mm", "r,z"}) {
    std::ofstream(write_scene(text) + "/outline.csv") << heading << "\n0,0\n20,0\n20,10\n0,10\n";
    EXPECT_NE(complaint_about(text).find("outline.csv:1: glass.boundary.csv: the heading "), std::string::npos)
        << heading;
  }
}

TEST(Scene, arcs_meet_lines_and_the_axis_exactly) {
  const auto scene = scene_of(replaced("(0, 0) (20, 0) (20, 10) (0, 10) mm",
                                       "arc centre (0, 20) mm radius 20 mm from -90 deg to 90 deg",
                                       replaced("position = \"10 mm\"", "position = \"40 mm\"")));
  const auto& segments = scene.glass.profile.segments;
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_EQ(segments[0].start, core::Point(0, 0));
  EXPECT_EQ(segments[0].end, segments[1].start);
  EXPECT_EQ(segments[1].end, segments[0].start);
  EXPECT_NEAR(revolved_volume(scene.glass.profile), 4.0 / 3 * M_PI * 8e-6, 1e-10);
}

TEST(Scene, a_stages_air_replaces_the_air_of_the_case) {
  const auto text = replaced(
      "[[stage]]", "[air]\ntemperature = \"50 degC\"\nh = \"20 W/m2/K\"\nambient = \"20 degC\"\n[[stage]]",
      replaced("gravity", "air = { temperature = \"90 degC\", h = \"7 W/m2/K\", ambient = \"1 degC\" }\ngravity"));
  const auto scene = scene_of(text);
  EXPECT_DOUBLE_EQ(scene.stages[0].air.h(0), 20);
  EXPECT_DOUBLE_EQ(scene.stages[0].air.ambient_temperature(0), 293.15);
  EXPECT_DOUBLE_EQ(scene.stages[1].air.air_temperature(0), 363.15);
}

TEST(Scene, numerics_override_the_accuracy_level) {
  const auto scene = scene_of(small_scene + "[numerics]\nsurface_size = \"0.7 mm\"\n");
  const auto preset = accuracy_preset("draft");
  EXPECT_DOUBLE_EQ(scene.accuracy.surface_size, 0.7e-3);
  EXPECT_DOUBLE_EQ(scene.accuracy.skin_size, preset.skin_size);
}

TEST(Scene, each_turn_of_the_accuracy_level_is_finer_in_everything) {
  const auto draft = accuracy_preset("draft"), standard = accuracy_preset("standard"), fine = accuracy_preset("fine");
  for (auto member : {&Accuracy::surface_size, &Accuracy::skin_size, &Accuracy::tool_contact_size,
                      &Accuracy::strain_per_step, &Accuracy::temperature_tolerance, &Accuracy::max_step}) {
    EXPECT_LT(standard.*member, draft.*member);
    EXPECT_LT(fine.*member, standard.*member);
  }
  EXPECT_THROW(accuracy_preset("rough"), core::CaseError);
}

TEST(Scene, every_conductance_law_is_read) {
  const std::string constant = "law = \"constant\"\nh = \"2000 W/m2/K\"";
  const auto full = scene_of(replaced(constant,
                                      "law = \"pressure-viscosity\"\nh0 = \"500 W/m2/K\"\nh1 = \"20 kW/m2/K\"\n"
                                      "p_ref = \"0.2 MPa\"\neta_ref = \"1e3 Pa.s\"\na = 1\nb = 0.25\n"
                                      "transition_gap = \"50 um\""));
  const auto& law = std::get<contact::PressureViscosityConductance>(full.interfaces.at(1).law);
  EXPECT_DOUBLE_EQ(law.h1, 20000);
  EXPECT_DOUBLE_EQ(law.p_ref, 2e5);
  EXPECT_DOUBLE_EQ(full.interfaces[1].transition_gap, 50e-6);
  const std::string table =
      "law = \"table\"\npressure = [\"1 kPa\", \"1 MPa\"]\nviscosity = [\"1e3 Pa.s\", \"1e6 Pa.s\"]\n";
  const auto tabled = scene_of(replaced(constant, table + "h = [[\"500 W/m2/K\", \"400 W/m2/K\"], "
                                                          "[\"9000 W/m2/K\", \"8000 W/m2/K\"]]"));
  EXPECT_EQ(std::get<contact::TableConductance>(tabled.interfaces.at(0).law).h,
            (std::vector<double>{500, 400, 9000, 8000}));
  const auto ragged = replaced(constant, table + "h = [[\"500 W/m2/K\", \"400 W/m2/K\"]]");
  EXPECT_EQ(complaint_about(ragged),
            std::to_string(line_of("h = [[", ragged)) +
                ": interface.h: 1 members were found, allowed is one for each of the 2 pressures");
}

TEST(Scene, every_condition_of_a_boundary_is_read) {
  const std::string rest = "path = \"(15, 20) (0, 20) mm\", condition = \"insulated\"";
  const auto cooled = scene_of(replaced(rest,
                                        "path = \"(15, 20) (0, 20) mm\", condition.cooled = { h = \"200 W/m2/K\", "
                                        "temperature = \"50 degC\" }"));
  EXPECT_EQ(cooled.tools[1].boundaries[1].kind, BoundaryKind::cooled);
  EXPECT_DOUBLE_EQ(cooled.tools[1].boundaries[1].cooling.h(0), 200);
  const auto given = scene_of(replaced(rest, "path = \"(15, 20) (0, 20) mm\", condition.temperature = \"50 degC\""));
  EXPECT_EQ(given.tools[1].boundaries[1].kind, BoundaryKind::temperature);
  EXPECT_DOUBLE_EQ(given.tools[1].boundaries[1].temperature(0), 323.15);
}

}  // namespace
}  // namespace parison::forming
