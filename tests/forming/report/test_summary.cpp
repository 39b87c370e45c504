// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdlib>

#include "../scene_text.hpp"
#include "core/io/files.hpp"
#include "forming/report/files/result_files.hpp"
#include "forming/report/summary.hpp"
#include "forming/report/thickness_profile.hpp"
#include "forming/state/initial_state.hpp"
#include "output_text.hpp"

namespace parison::forming {
namespace {

RunFacts some_facts() {
  RunFacts run;
  const Scene scene = case_of("contact_cylinders");
  run.diagnostics = first_diagnostics(scene, initial_state(scene));
  run.completed = true;
  run.wall_seconds = 1.5;
  run.timing = {{"heat", 1.0}};
  run.warnings = {"a \"quoted\" warning"};
  run.stages = {{"contact", 0, 10, "duration"}};
  return run;
}

TEST(Summary, the_file_is_valid_json_with_the_names_of_the_readme) {
  const Scene scene = case_of("contact_cylinders");
  const std::string folder = tests::absent_folder();
  ResultFiles files(scene, folder);
  write_summary(folder, scene, {initial_state(scene), some_facts()});
  const std::string text = core::read_text(folder + "/summary.json");
  for (const char* key : {"case",
                          "geometry",
                          "accuracy",
                          "completed",
                          "wall_seconds",
                          "steps",
                          "rejected_steps",
                          "remeshes",
                          "timing",
                          "flow",
                          "heat",
                          "radiation",
                          "contact",
                          "remesh",
                          "output",
                          "state_fingerprint",
                          "remeshing",
                          "for_stage_start",
                          "for_quality",
                          "for_failed_step",
                          "heat_drift",
                          "max_heat_change",
                          "max_volume_change",
                          "min_quality",
                          "min_median_quality",
                          "seconds",
                          "volume_drift",
                          "energy_imbalance",
                          "glass",
                          "mass_kg",
                          "temperature_mean_degC",
                          "temperature_min_degC",
                          "temperature_max_degC",
                          "tools",
                          "heat_received_J",
                          "surface_temperature_max_degC",
                          "stages",
                          "thickness",
                          "min_mm",
                          "mean_mm",
                          "max_mm",
                          "min_r_mm",
                          "min_z_mm",
                          "max_r_mm",
                          "max_z_mm",
                          "warnings"})
    EXPECT_NE(text.find('"' + std::string(key) + "\": "), text.npos) << key;
  const std::string check = "python3 -c \"import json; s = json.load(open('" + folder +
                            "/summary.json')); assert abs(s['glass']['mass_kg'] - 0.0628319) < 1e-6; "
                            "assert s['warnings'][0].count(chr(34)) == 2; assert s['stages'][0]['end_s'] == 10; "
                            "assert s['tools']['steel']['surface_temperature_max_degC'] is not None\"";
  EXPECT_EQ(std::system(check.c_str()), 0);
  EXPECT_EQ(lines_of(core::read_text(folder + "/thickness.csv"))[0],
            "arc_mm,r_outer_mm,z_outer_mm,thickness_mm,T_inner_degC,T_outer_degC,mark,r_inner_mm,z_inner_mm");
}

TEST(Summary, the_share_of_the_surface_near_tools_is_that_of_the_face_in_contact) {
  const Scene scene = case_of("contact_cylinders");
  const State state = initial_state(scene);
  const Summary summary = summarise(scene, state, some_facts(), thickness_profile(scene, state));
  // The face is a third of the outer surface, which is itself and the side; the lowest 0.2 mm of that add 0.7 percent.
  EXPECT_GE(summary.outer_within_02mm, 1.0 / 3 - 1e-9);
  EXPECT_LE(summary.outer_within_02mm, 0.3405);
}

TEST(Summary, a_thickness_that_no_row_gives_is_not_a_number_in_the_table) {
  const Scene scene = case_of("contact_cylinders");
  const State state = initial_state(scene);
  const std::string table = summary_table(scene, state, summarise(scene, state, some_facts(), {}));
  EXPECT_NE(table.find("wall thickness        n/a\n"), table.npos) << table;
}

TEST(Summary, the_table_says_that_the_numbers_of_a_planar_scene_are_for_a_metre_of_depth) {
  const std::string half = R"(case = "half"
geometry = "planar"
stage = [{ name = "rest", duration = "1 s" }]
[material.glass]
density = "2400 kg/m3"
heat_capacity = "1300 J/kg/K"
conductivity = "1.3 W/m/K"
[glass]
material = "glass"
temperature = "1000 degC"
boundary = [
  { name = "rest", path = "(0, 0) (10, 0) (10, 10) (0, 10) mm", condition = "insulated" },
  { name = "middle", path = "(0, 0) mm", condition = "symmetry" } ]
)";
  const auto table = [](const Scene& scene) {
    const State state = initial_state(scene);
    return summary_table(scene, state, summarise(scene, state, some_facts(), {}));
  };
  const std::string told = "masses, volumes, heats and forces are those of a metre of depth";
  const std::string of_half = table(scene_of(half)), whole = replaced("\"symmetry\"", "\"insulated\"", half);
  EXPECT_NE(of_half.find(told + ", of the part of the section that is drawn\n"), of_half.npos) << of_half;
  EXPECT_NE(table(scene_of(whole)).find(told + "\n"), std::string::npos);
  EXPECT_EQ(table(case_of("contact_cylinders")).find(told), std::string::npos);
}

TEST(Summary, the_table_gives_small_glass_to_four_figures_and_of_each_tool_its_offset_at_the_end) {
  const Scene scene = case_of("contact_cylinders");
  State state = initial_state(scene);
  Summary summary = summarise(scene, state, some_facts(), thickness_profile(scene, state));
  summary.glass.mass = 1.7312e-3;
  summary.glass.volume = 0.77654e-6;
  summary.tools[0].position = 17.53e-3;
  std::string table = summary_table(scene, state, summary);
  EXPECT_NE(table.find("1.731 g, 0.7765 cm3"), table.npos) << table;
  EXPECT_NE(table.find("end offset, mm"), table.npos) << table;
  EXPECT_NE(table.find("17.53\n"), table.npos) << table;
  summary.glass.mass = 0.2196;
  summary.glass.volume = 91.5e-6;
  table = summary_table(scene, state, summary);
  EXPECT_NE(table.find("219.6 g, 91.50 cm3"), table.npos) << table;
}

TEST(Summary, the_table_names_tools_stages_and_the_reason_of_a_stop) {
  const Scene scene = case_of("contact_cylinders");
  const State state = initial_state(scene);
  RunFacts run = some_facts();
  Summary summary = summarise(scene, state, run, thickness_profile(scene, state));
  std::string table = summary_table(scene, state, summary);
  for (const char* text :
       {"62.83 g", "mean 1150 degC", "steel", "485", "contact", "1.5 s: heat 1.0", "completed", "a \"quoted\" warning"})
    EXPECT_NE(table.find(text), table.npos) << text << table;
  summary.run.completed = false;
  summary.run.reason = "stage contact at 0 s: no reason";
  table = summary_table(scene, state, summary);
  EXPECT_NE(table.find("stopped at 0 s: stage contact at 0 s: no reason"), table.npos);
}

}  // namespace
}  // namespace parison::forming
