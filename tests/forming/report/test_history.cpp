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
  state.tools[1].end_force = -4.5;
  state.tools[1].velocity = -0.02;
  StepReport report;
  report.dt = 0.125;
  report.flow_solves = 7;
  report.limit = StepLimit::event;
  HistoryRow row = history_row(scene, state, report);
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
  EXPECT_NEAR(history_row(scene, state, {}).contact_area, M_PI * 0.02 * 0.02, 1e-12);
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

/// The disc between plates without friction, whose upper one a force drives, and the force that it takes to press it at
/// a speed: 3 eta V v / h^2.
std::string driven_press(const std::string& motion, const std::string& ends) {
  return replaced("motion.plunger = { offset = [[\"0 s\", \"10 mm\"], [\"0.5 s\", \"5 mm\"]] }",
                  "motion.plunger = " + motion + "\n" + ends, slipping_press);
}

TEST(History, no_force_is_larger_than_the_drive_and_a_tool_below_its_speed_limit_has_just_that) {
  // At 20 mm/s it takes 75 N at 10 mm, 150 N at 7.1 mm.
  const auto outcome_of = [](const std::string& text) {
    const std::string folder = tests::absent_folder();
    EXPECT_TRUE(run_in_folder(scene_of(text), folder).facts.completed);
    return core::read_text(folder + "/history.csv");
  };
  std::istringstream rows(outcome_of(driven_press("{ force = \"-150 N\", speed_limit = \"20 mm/s\" }", "")));
  std::string header, line;
  std::getline(rows, header);
  int limited = 0, balanced = 0;
  while (std::getline(rows, line)) {
    auto field = named_fields(header + '\n', line + '\n');
    const double force = std::stod(field["plunger_force_N"]), speed = std::stod(field["plunger_speed_mm_s"]);
    EXPECT_GE(force, -150 * (1 + 1e-9)) << line;
    if (speed > -20 * (1 - 1e-9)) {
      EXPECT_NEAR(force, -150, 1e-6) << line;
      ++balanced;
    } else {
      ++limited;
    }
  }
  EXPECT_GT(limited, 3);
  EXPECT_GT(balanced, 3);
}

TEST(History, a_stage_ends_at_the_moment_at_which_a_force_is_reached) {
  const Scene scene = scene_of(
      driven_press("{ offset = [[\"0 s\", \"10 mm\"], [\"0.5 s\", \"5 mm\"]] }", "end = { force = \"100 N\" }"));
  const auto outcome = run_in_folder(scene, tests::absent_folder());
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  EXPECT_EQ(outcome.facts.stages.back().end_reason, std::string("force reached"));
  const double height = std::sqrt(3 * 1e4 * M_PI * 0.02 * 0.02 * 0.01 * 0.01 / 100);
  std::printf("height %.4f mm, exact %.4f mm, last step %.4f s\n", 1e3 * outcome.state.tools[1].offset, 1e3 * height,
              outcome.state.last_step);
  EXPECT_NEAR(outcome.state.tools[1].offset, height, 0.003 * height);
}

/// The mean contact pressure on the plates at outputs, over the exact one at that time.
struct PressureWatch : RunObserver {
  double worst = 0;
  int count = 0;
  void fields_due(const RunView& run, const State& at) override {
    if (at.time == 0 || run.state.totals.steps < 3) return;
    const double height = at.tools[1].offset, exact = 3 * 1e4 * 0.01 / height;
    double sum = 0;
    int nodes = 0;
    for (Index n = 0; n < at.glass.mesh.node_count(); ++n)
      if (at.glass.contact_tool[n] >= 0) sum += at.glass.contact_pressure[n], ++nodes;
    worst = std::max(worst, std::abs(sum / nodes / exact - 1));
    ++count;
  }
};

TEST(History, the_contact_pressure_is_that_of_the_time_of_the_output) {
  Scene scene = scene_of(slipping_press);
  scene.output.interval = 0.013;
  PressureWatch watch;
  const auto outcome = run_in_folder(scene, tests::absent_folder(), {&watch});
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  std::printf("%d outputs, pressure off by %.4f at most\n", watch.count, watch.worst);
  EXPECT_GT(watch.count, 20);
  EXPECT_LT(watch.worst, 0.01);
}

}  // namespace
}  // namespace parison::forming
