// SPDX-License-Identifier: GPL-3.0-or-later
// What a run says of its wall.
#include <gtest/gtest.h>

#include "../scene_text.hpp"
#include "core/io/files.hpp"
#include "core/io/json_read.hpp"
#include "forming/report/summary.hpp"
#include "forming/run/folder_run.hpp"

namespace parison::forming {
namespace {

/// A disc of 6 mm on a cold table, with gravity alone.
const std::string sagging_disc = R"(case = "sag"
geometry = "axisymmetric"
interface = [{ tools = ["table"], law = "constant", h = "2000 W/m2/K" }]
stage = [{ name = "sag", duration = "0.05 s", gravity = "-9.81 m/s2", tools = ["table"] }]
)" + container_glass("1.3 W/m/K") +
                                 iron + R"([glass]
material = "glass"
temperature = "1100 degC"
boundary = [{ name = "bottom", path = "(0, 0) (30, 0) mm", condition = "contact" },
            { name = "surface", path = "(30, 6) (0, 6) mm", condition = "contact" },
            { name = "axis", path = "(0, 0) mm", condition = "symmetry" }]
[[tool]]
name = "table"
material = "iron"
temperature = "450 degC"
friction = "stick"
boundary = [{ name = "top", path = "(40, 0) (0, 0) mm", condition = "contact" },
            { name = "axis", path = "(0, -20) mm", condition = "symmetry" },
            { name = "rest", path = "(40, -20) (40, 0) mm", condition = "insulated" }]
)";

TEST(WallSides, a_run_without_any_pressure_gives_the_thickness_of_its_disc_with_places_and_marks) {
  const std::string folder = tests::absent_folder();
  const Scene scene = scene_of(sagging_disc);
  const RunOutcome end = run_in_folder(scene, folder);
  ASSERT_TRUE(end.facts.completed);
  write_summary(folder, scene, end);
  const core::JsonValue summary = core::read_json(core::read_text(folder + "/summary.json"), "summary.json");
  const core::JsonValue& thickness = *summary.find("thickness");
  for (const char* key : {"min_mm", "mean_mm", "max_mm"}) EXPECT_NEAR(thickness.number_of(key), 6, 0.1) << key;
  EXPECT_LT(thickness.number_of("max_r_mm"), thickness.number_of("min_r_mm"));
  EXPECT_NEAR(thickness.number_of("min_z_mm"), 0, 1e-6);
  const core::JsonValue& place = *summary.find("quantities")->find("thickness_min_at");
  EXPECT_NEAR(place.number_of("r_mm"), 33 * place.number_of("value"), 0.1) << "to the middle of the rim";
  EXPECT_EQ(place.number_of("r_mm"), thickness.number_of("min_r_mm")) << "one least wall, not two";
  EXPECT_EQ(summary.find("quantities")->find("thickness_min")->number_of("value"), thickness.number_of("min_mm"));
  const std::string rows = core::read_text(folder + "/thickness.csv");
  EXPECT_NE(rows.find(",wall,"), rows.npos);
  EXPECT_NE(rows.find(",rim,nan,nan\n"), rows.npos);
}

TEST(WallSides, a_run_that_leaves_a_gob_says_that_it_is_no_wall) {
  std::string gob = replaced("path = \"(0, 0) (30, 0) mm\"",
                             "path = \"arc centre (0, 20) mm radius 20 mm from -90 deg to 0 deg\"", sagging_disc);
  gob = replaced("path = \"(30, 6) (0, 6) mm\"", "path = \"arc centre (0, 20) mm radius 20 mm from 0 deg to 90 deg\"",
                 gob);
  const std::string folder = tests::absent_folder();
  const Scene scene = scene_of(gob);
  const RunOutcome end = run_in_folder(scene, folder);
  ASSERT_TRUE(end.facts.completed);
  write_summary(folder, scene, end);
  const core::JsonValue summary = core::read_json(core::read_text(folder + "/summary.json"), "summary.json");
  const core::JsonValue& thickness = *summary.find("thickness");
  EXPECT_EQ(thickness.text_of("absent").rfind("the glass is no wall: ", 0), 0u) << thickness.text_of("absent");
  EXPECT_EQ(thickness.find("min_mm"), nullptr);
  EXPECT_EQ(summary.find("quantities")->find("thickness_min"), nullptr);
  EXPECT_EQ(core::read_text(folder + "/thickness.csv").find(",wall,"), std::string::npos);
}

}  // namespace
}  // namespace parison::forming
