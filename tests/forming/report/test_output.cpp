// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "../scene_text.hpp"
#include "core/io/files.hpp"
#include "forming/report/contour/contour.hpp"
#include "forming/report/files/history.hpp"
#include "forming/report/files/interface_rows.hpp"
#include "forming/report/files/result_files.hpp"
#include "forming/report/files/tool_rows.hpp"
#include "forming/report/summary.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/heat/thermal_interface.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;
using tests::absent_folder;

Scene case_of(const std::string& name) {
  return read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/" + name, "draft");
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

TEST(History, the_columns_are_those_of_the_readme) {
  EXPECT_EQ(history_header(scene_of(small_scene)),
            "time_s,stage,dt_s,volume_mm3,glass_mean_degC,heat_to_tools_J,heat_to_air_J,dissipation_J,energy_imbalance,"
            "contact_area_mm2,lowest_mm,highest_mm,length_mm,sag_mm,skin_mean_degC,skin_min_degC,skin_viscosity_Pa_s,"
            "plate_force_N,plunger_force_N,plate_position_mm,plunger_position_mm,plate_speed_mm_s,plunger_speed_mm_s,"
            "centre_degC,coupling_iterations,flow_solves,contact_changes,heat_substeps,limited_by\n");
}

/// Fields of a line by the names of a heading.
std::map<std::string, std::string> named_fields(const std::string& heading, const std::string& line) {
  const auto names = fields_of(lines_of(heading)[0]), fields = fields_of(lines_of(line)[0]);
  EXPECT_EQ(names.size(), fields.size());
  std::map<std::string, std::string> found;
  for (std::size_t i = 0; i < std::min(names.size(), fields.size()); ++i) found[names[i]] = fields[i];
  return found;
}

TEST(History, a_row_says_what_the_state_holds) {
  const Scene scene = scene_of(small_scene);
  State state = initial_state(scene);
  state.time = 0.25;
  state.tools[1].force = -4.5;
  state.tools[1].velocity = -0.02;
  StepReport report;
  report.dt = 0.125;
  report.flow_solves = 7;
  report.limit = StepLimit::event;
  HistoryRow row = history_row(scene, state, state, report);
  row.sag = 3e-3;
  auto field = named_fields(history_header(scene), history_line(row));
  EXPECT_EQ(field["time_s"], "0.25");
  EXPECT_EQ(field["stage"], "rest");
  EXPECT_EQ(field["dt_s"], "0.125");
  EXPECT_NEAR(std::stod(field["volume_mm3"]), M_PI * 20 * 20 * 10, 1e-5);
  EXPECT_NEAR(std::stod(field["glass_mean_degC"]), 1000, 1e-6);
  EXPECT_NEAR(std::stod(field["lowest_mm"]), 0, 1e-9);
  EXPECT_NEAR(std::stod(field["highest_mm"]), 10, 1e-9);
  EXPECT_NEAR(std::stod(field["length_mm"]), 10, 1e-9);
  EXPECT_EQ(field["sag_mm"], "3");
  EXPECT_NEAR(std::stod(field["skin_mean_degC"]), 1000, 1e-6);
  EXPECT_NEAR(std::stod(field["skin_min_degC"]), 1000, 1e-6);
  EXPECT_NEAR(std::stod(field["skin_viscosity_Pa_s"]), 1e4, 1e-4);
  EXPECT_EQ(field["plunger_force_N"], "-4.5");
  EXPECT_EQ(field["plunger_position_mm"], "10");
  EXPECT_EQ(field["plunger_speed_mm_s"], "-20");
  EXPECT_NEAR(std::stod(field["centre_degC"]), 1000, 1e-6);
  EXPECT_EQ(field["flow_solves"], "7");
  EXPECT_EQ(field["limited_by"], "event");
}

TEST(ToolRows, a_row_has_mean_surface_and_hottest_place_in_the_frame_of_the_case) {
  const Scene scene = scene_of(small_scene);
  State state = initial_state(scene);
  ToolState& plunger = state.tools[1];  // a disc of 15 mm radius and 20 mm height, drawn with its face at z = 0
  for (Index n = 0; n < plunger.mesh.node_count(); ++n)
    plunger.temperature[n] = 273.15 + 600 + 10e3 * plunger.mesh.nodes[n][0] - 1e3 * plunger.mesh.nodes[n][1];
  plunger.heat_received = 12;
  auto field = named_fields(tool_header(scene), tool_line(scene, state, tool_surfaces(scene, state)));
  EXPECT_NEAR(std::stod(field["plunger_mean_degC"]), 600 + 100 - 10, 1e-4);
  EXPECT_NEAR(std::stod(field["plunger_surface_mean_degC"]), 600 + 100, 1e-4);
  EXPECT_NEAR(std::stod(field["plunger_surface_max_degC"]), 750, 1e-4);
  EXPECT_NEAR(std::stod(field["plunger_surface_max_r_mm"]), 15, 1e-6);
  EXPECT_NEAR(std::stod(field["plunger_surface_max_z_mm"]), 10, 1e-6);
  // Hotter than 645 degC beyond a radius of 4.5 mm.
  EXPECT_NEAR(std::stod(field["plunger_sticking_area_mm2"]), M_PI * (15 * 15 - 4.5 * 4.5), 3);
  EXPECT_EQ(field["plunger_heat_received_J"], "12");
  EXPECT_EQ(field["plate_sticking_area_mm2"], "0");
}

TEST(Csv, every_heading_has_a_unit_but_names_counts_and_shares) {
  const Scene scene = scene_of(small_scene);
  const std::set<std::string> units{"s", "mm", "mm2", "mm3", "mm_s", "degC", "N",
                                    "J", "g",  "kg",  "Pa",  "Pa_s", "W_m2", "W_m2K"};
  const std::set<std::string> without{"stage",
                                      "energy_imbalance",
                                      "coupling_iterations",
                                      "flow_solves",
                                      "contact_changes",
                                      "heat_substeps",
                                      "limited_by",
                                      "tool",
                                      "contact_weight",
                                      "mark",
                                      "side",
                                      "loop"};
  const State state = initial_state(scene);
  const std::string folder = tests::new_folder();
  write_thickness(folder + "/thickness.csv", {});
  for (const std::string& heading :
       {history_header(scene), tool_header(scene), interface_header(), core::read_text(folder + "/thickness.csv"),
        contour_text(scene, state, {}), heights_text({})})
    for (const std::string& name : fields_of(lines_of(heading)[0])) {
      bool has_unit = without.count(name) > 0;
      for (const std::string& unit : units)
        has_unit = has_unit || (name.size() > unit.size() && name.substr(name.size() - unit.size() - 1) == '_' + unit);
      EXPECT_TRUE(has_unit) << name;
    }
}

TEST(History, the_contact_area_is_that_of_the_edges_pressed_at_all_their_nodes) {
  const Scene scene = scene_of(small_scene);
  State state = initial_state(scene);
  for (std::size_t i = 0; i < state.glass.mesh.nodes.size(); ++i)
    if (std::abs(state.glass.mesh.nodes[i][1]) < 1e-9) state.glass.contact_tool[i] = 0;
  EXPECT_NEAR(history_row(scene, state, state, {}).contact_area, M_PI * 0.02 * 0.02, 1e-12);
}

TEST(History, the_imbalance_is_the_heat_that_no_entry_explains) {
  const Scene scene = scene_of(small_scene);
  State state = initial_state(scene);
  EXPECT_EQ(glass_facts(scene, state).energy_imbalance, 0);
  state.glass.temperature.array() -= 10;
  const double lost = M_PI * 0.02 * 0.02 * 0.01 * 2400 * 1300 * 10;
  state.totals.to_tools = 0.75 * lost;
  state.totals.to_air = 0.5 * lost;
  state.totals.dissipation = 0.25 * lost;
  EXPECT_NEAR(glass_facts(scene, state).energy_imbalance, 0, 1e-10);
  state.totals.to_tools -= 0.05 * lost;
  EXPECT_NEAR(glass_facts(scene, state).energy_imbalance, 0.05 / 1.2, 1e-9);
  state.totals.remeshing.heat = -0.05 * lost;
  EXPECT_NEAR(glass_facts(scene, state).energy_imbalance, 0.05 / 1.2, 1e-9);
}

TEST(ResultFiles, an_earlier_result_folder_is_refused_and_left_as_it_is) {
  const Scene scene = scene_of(small_scene);
  const std::string folder = absent_folder();
  { ResultFiles files(scene, folder); }
  core::write_text(folder + "/history.csv", "precious");
  try {
    ResultFiles files(scene, folder);
    FAIL() << "nothing was thrown";
  } catch (const core::CaseError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(folder + ": a file or a folder that holds something was found", 0), 0u);
  }
  EXPECT_EQ(core::read_text(folder + "/history.csv"), "precious");
  EXPECT_THROW(ResultFiles(scene, folder + "/history.csv"), core::CaseError);
}

TEST(ResultFiles, every_output_has_a_file_for_each_body_and_repeats_are_left_out) {
  const Scene scene = scene_of(small_scene);
  State state = initial_state(scene);
  const std::string folder = absent_folder();
  ResultFiles files(scene, folder);
  for (const double time : {0.0, 0.5, 0.5, 1.0}) {
    state.time = time;
    files.fields(state, {});
  }
  for (const char* body : {"glass", "plate", "plunger"}) {
    EXPECT_TRUE(fs::exists(folder + "/vtu/" + body + "_0002.vtu")) << body;
    EXPECT_FALSE(fs::exists(folder + "/vtu/" + body + "_0003.vtu")) << body;
    const std::string pvd = core::read_text(folder + '/' + body + ".pvd");
    EXPECT_NE(pvd.find(std::string("timestep=\"1\" group=\"\" part=\"0\" file=\"vtu/") + body + "_0002.vtu\""),
              pvd.npos);
  }
}

TEST(ResultFiles, history_rows_are_on_the_disk_at_once) {
  const Scene scene = scene_of(small_scene);
  const State state = initial_state(scene);
  const std::string folder = absent_folder();
  ResultFiles files(scene, folder);
  files.row(history_row(scene, state, state, {}), tool_line(scene, state, tool_surfaces(scene, state)));
  for (const char* name : {"/history.csv", "/tools.csv"})
    EXPECT_EQ(lines_of(core::read_text(folder + name)).size(), 2u) << name;
}

TEST(InterfaceRows, they_run_along_the_contact_with_both_temperatures_and_the_flux) {
  const Scene scene = scene_of(small_scene);
  const State state = initial_state(scene);
  const auto lines = lines_of(interface_lines(scene, state, thermal_interface(scene, state)));
  ASSERT_GT(lines.size(), 10u);
  double last = 0;
  for (const std::string& line : lines) {
    const auto fields = fields_of(line);
    ASSERT_EQ(fields.size(), fields_of(interface_header()).size());
    EXPECT_EQ(fields[1], "plate");
    const double arc = std::stod(fields[2]), contact_weight = std::stod(fields[12]);
    EXPECT_GT(arc, last);
    last = arc;
    // The glass surface starts on the axis and first runs along the plate.
    EXPECT_NEAR(arc, std::stod(fields[3]), 1e-6);
    EXPECT_NEAR(std::stod(fields[5]), 1000, 1e-5);
    EXPECT_NEAR(std::stod(fields[6]), 400, 1e-5);
    EXPECT_NEAR(std::stod(fields[8]), 1e4, 1e-3);
    EXPECT_NEAR(std::stod(fields[9]), 2000, 1e-3);
    EXPECT_NEAR(contact_weight, 1, 1e-6);
    EXPECT_NEAR(std::stod(fields[10]), 2000 * 600, 2);
  }
  EXPECT_GT(last, 19);
  const core::Mesh& glass = state.glass.mesh;
  const auto on_plate =
      std::count_if(glass.boundary_edges().begin(), glass.boundary_edges().end(),
                    [&](const core::BoundaryEdge& edge) { return std::abs(glass.nodes[edge.nodes[2]][1]) < 1e-9; });
  EXPECT_GT(static_cast<long>(lines.size()), 2 * on_plate);
  EXPECT_LE(static_cast<long>(lines.size()), 4 * on_plate);
}

TEST(ThicknessProfile, a_shell_has_its_thickness_and_its_outer_area_everywhere) {
  const Scene scene = case_of("shell_inflation");
  const auto rows = thickness_profile(scene, initial_state(scene)).rows;
  double area = 0, arc = -1;
  for (const ThicknessRow& row : rows) {
    EXPECT_NEAR(row.position.norm(), 0.015, 1e-6);
    EXPECT_NEAR(row.thickness, 0.005, 5e-6);
    EXPECT_TRUE(row.is_wall());
    EXPECT_TRUE(std::isnan(row.inner_temperature));
    EXPECT_GT(row.arc, arc);
    arc = row.arc;
    area += row.area;
  }
  EXPECT_NEAR(arc, 0.5 * M_PI * 0.015, 1e-7);
  EXPECT_NEAR(area, 2 * M_PI * 0.015 * 0.015, 1e-8);
  const ThicknessRange range = thickness_range(rows);
  for (const double thickness : {range.lowest, range.mean, range.highest}) EXPECT_NEAR(thickness, 0.005, 5e-6);
}

TEST(ThicknessProfile, both_temperatures_of_a_linear_field_are_found) {
  const Scene scene = case_of("contact_cylinders");
  State state = initial_state(scene);
  GlassState& glass = state.glass;
  for (Index i = 0; i < glass.mesh.node_count(); ++i)
    glass.temperature[i] = 1300 + 5000 * glass.mesh.nodes[i][1] + 1000 * glass.mesh.nodes[i][0];
  int bottom = 0;
  for (const ThicknessRow& row : thickness_profile(scene, state).rows) {
    if (row.position[1] > 1e-9 || row.position[0] > 0.0199) continue;
    EXPECT_NEAR(row.thickness, 0.02, 1e-9);
    EXPECT_NEAR(row.outer_temperature, 1300 + 1000 * row.position[0], 1e-9);
    EXPECT_NEAR(row.inner_temperature, row.outer_temperature + 100, 1e-6);
    ++bottom;
  }
  EXPECT_GT(bottom, 20);
}

TEST(ThicknessProfile, only_rows_of_the_wall_count_and_the_extremes_have_places) {
  std::vector<ThicknessRow> rows(3);
  rows[0] = {0, {1, 2}, 2e-3, 0, 0, 1e-4, WallMark::wall, {0, 0}};
  rows[1] = {1, {3, 4}, 4e-3, 0, 0, 3e-4, WallMark::wall, {0, 0}};
  rows[2] = {2, {5, 6}, 9e-3, 0, 0, 9e-4, WallMark::rim, {0, 0}};
  const ThicknessRange range = thickness_range(rows);
  EXPECT_EQ(range.lowest, 2e-3);
  EXPECT_EQ(range.highest, 4e-3);
  EXPECT_EQ(range.lowest_at, Point(1, 2));
  EXPECT_EQ(range.highest_at, Point(3, 4));
  EXPECT_NEAR(range.mean, 3.5e-3, 1e-15);
}

TEST(ThicknessProfile, an_end_face_looks_along_the_wall_and_does_not_count) {
  std::string text =
      replaced("{ name = \"surface\", path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\", condition = \"contact\" },",
               "{ name = \"end\", path = \"(27, 0) (31, 0) mm\", condition = \"contact\" },"
               "{ name = \"outer\", path = \"(31, 40) mm\", condition = \"contact\" },"
               "{ name = \"top\", path = \"(27, 40) mm\", condition = \"contact\" },");
  text = replaced("{ name = \"axis\", path = \"(0, 0) mm\", condition = \"symmetry\" },",
                  "{ name = \"inner\", path = \"(27, 0) mm\", condition = \"contact\" },", text);
  text = replaced("pressure.surface", "pressure.inner", replaced("(0, 5) mm", "(29, 5) mm", text));
  const Scene scene = scene_of(text);
  int walls = 0, ends = 0;
  const auto rows = thickness_profile(scene, initial_state(scene)).rows;
  for (const ThicknessRow& row : rows) {
    const bool on_side = row.position[0] > 0.031 - 1e-9 && row.position[1] > 1e-3 && row.position[1] < 0.039;
    const bool on_end = row.position[0] < 0.0309 && row.position[1] < 1e-9;
    EXPECT_TRUE(!on_side || row.is_wall());
    EXPECT_FALSE(on_end && row.is_wall());
    walls += on_side;
    ends += on_end;
  }
  EXPECT_GT(walls, 20);
  EXPECT_GT(ends, 4);
  const ThicknessRange range = thickness_range(rows);
  EXPECT_NEAR(range.mean, 4e-3, 1e-9);
  EXPECT_NEAR(range.highest, 4e-3, 1e-9);
}

RunFacts some_facts() {
  RunFacts run;
  run.completed = true;
  run.wall_seconds = 1.5;
  run.timing = {{"heat", 1.0}};
  run.warnings = {"a \"quoted\" warning"};
  run.stages = {{"contact", 0, 10, "duration"}};
  return run;
}

TEST(Summary, the_file_is_valid_json_with_the_names_of_the_readme) {
  const Scene scene = case_of("contact_cylinders");
  const std::string folder = absent_folder();
  ResultFiles files(scene, folder);
  write_summary(folder, scene, initial_state(scene), some_facts());
  const std::string text = core::read_text(folder + "/summary.json");
  for (const char* key : {"case",
                          "accuracy",
                          "completed",
                          "wall_seconds",
                          "steps",
                          "rejected_steps",
                          "remeshes",
                          "timing",
                          "flow",
                          "heat",
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

TEST(Summary, the_table_names_tools_stages_and_the_reason_of_a_stop) {
  const Scene scene = case_of("contact_cylinders");
  const State state = initial_state(scene);
  RunFacts run = some_facts();
  Summary summary = summarise(scene, state, run, thickness_profile(scene, state));
  std::string table = summary_table(scene, state, summary);
  for (const char* text : {"62.8 g", "mean 1150 degC", "steel", "485", "contact", "completed", "a \"quoted\" warning"})
    EXPECT_NE(table.find(text), table.npos) << text << table;
  summary.run.completed = false;
  summary.run.reason = "stage contact at 0 s: no reason";
  table = summary_table(scene, state, summary);
  EXPECT_NE(table.find("stopped at 0 s: stage contact at 0 s: no reason"), table.npos);
}

}  // namespace
}  // namespace parison::forming
