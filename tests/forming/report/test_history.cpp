// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of history.csv.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "../scene_text.hpp"
#include "core/io/files.hpp"
#include "forming/report/files/history.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/state/initial_state.hpp"
#include "output_text.hpp"
#include "slipping_press.hpp"

namespace parison::forming {
namespace {

TEST(History, the_columns_are_those_of_the_readme) {
  EXPECT_EQ(history_header(scene_of(small_scene)),
            "time_s,stage,dt_s,volume_mm3,glass_mean_degC,heat_to_tools_J,heat_to_air_J,dissipation_J,energy_imbalance,"
            "contact_area_mm2,lowest_mm,highest_mm,length_mm,sag_mm,skin_mean_degC,skin_min_degC,skin_viscosity_Pa_s,"
            "plate_force_N,plunger_force_N,plate_position_mm,plunger_position_mm,plate_speed_mm_s,plunger_speed_mm_s,"
            "centre_degC,coupling_iterations,flow_solves,contact_changes,heat_substeps,limited_by\n");
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

TEST(History, the_force_is_that_of_the_height_beside_it) {
  const std::string folder = tests::absent_folder();
  const auto outcome = run_in_folder(scene_of(slipping_press), folder);
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  std::istringstream rows(core::read_text(folder + "/history.csv"));
  std::string line, field;
  std::getline(rows, line);
  std::vector<std::string> names;
  for (std::istringstream in(line); std::getline(in, field, ',');) names.push_back(field);
  const auto column = [&](const char* name) { return std::find(names.begin(), names.end(), name) - names.begin(); };
  double worst = 0;
  int count = 0;
  while (std::getline(rows, line)) {
    std::vector<std::string> fields;
    for (std::istringstream in(line); std::getline(in, field, ',');) fields.push_back(field);
    const double height = 1e-3 * std::stod(fields[column("plunger_position_mm")]);
    const double exact = -3 * 1e4 * M_PI * 0.02 * 0.02 * 0.01 * 0.01 / (height * height);
    worst = std::max(worst, std::abs(std::stod(fields[column("plunger_force_N")]) / exact - 1));
    ++count;
  }
  std::printf("%d rows, force off by %.4f at most\n", count, worst);
  EXPECT_GT(count, 5);
  EXPECT_LT(worst, 0.015);  // the force in the middle of a step is 6 % off and more
}

}  // namespace
}  // namespace parison::forming
