// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "../pot_scene.hpp"
#include "../scene_parts.hpp"
#include "../scene_text.hpp"
#include "forming/remeshing/remesh_state.hpp"
#include "forming/report/files/history.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/state/fingerprint.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/state/interpolate.hpp"
#include "forming/step/contact/carrier.hpp"
#include "forming/step/heat/heat_step.hpp"
#include "forming/step/step.hpp"
#include "forming/step/step_control.hpp"
#include "remesh/mesher/quality.hpp"

namespace parison::forming {
namespace {

class Pot : public ::testing::Test {
 protected:
  const std::filesystem::path folder = tests::new_folder();
  Scene scene = scene_of(pot);
};

TEST_F(Pot, is_filled_by_a_plunger_that_stops_by_its_force) {
  const auto outcome = run_in_folder(scene, (folder / "results").string());
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  const State& state = outcome.state;
  const double full = 10.0 * 10.0 * 10.0 / (12.0 * 12.0);  // mm
  const double height = 10 + 1e3 * state.tools[1].offset;
  const auto facts = glass_facts(scene, state);
  std::printf(
      "pot: plunger at %.3f mm (full at %.3f), drift %.1e (largest %.1e), imbalance %.1e, %d steps, %d remeshes\n",
      height, full, facts.volume_drift, outcome.facts.diagnostics.max_drift, facts.energy_imbalance, state.totals.steps,
      remeshes(state));
  EXPECT_NEAR(height, full, 0.05);
  EXPECT_NEAR(state.tools[1].force, -3000, 1);
  EXPECT_LT(std::abs(state.tools[1].velocity), 1e-3);
  EXPECT_LT(outcome.facts.diagnostics.max_drift, 1e-3);
  EXPECT_LT(std::abs(facts.energy_imbalance), 1e-4);
  EXPECT_LT(outcome.facts.diagnostics.in_tools.node.depth, 5e-5);
  EXPECT_GT(state.totals.to_tools, 100);
  EXPECT_NEAR(state.tools[0].heat_received + state.tools[1].heat_received, state.totals.to_tools,
              1e-9 * state.totals.to_tools);
  // The work of the plunger all turns to heat, but for what gravity and the last speeds take.
  EXPECT_GT(state.totals.dissipation, 0);
  for (const auto* file : {"summary.json", "thickness.csv"})
    EXPECT_FALSE(std::filesystem::exists(folder / "results" / file));
  for (const auto* file : {"history.csv", "interface.csv", "glass.pvd", "plunger.pvd", "checkpoint.h5"})
    EXPECT_TRUE(std::filesystem::exists(folder / "results" / file)) << file;
}

TEST_F(Pot, a_stage_too_short_for_its_tool_to_come_to_rest_is_warned_of) {
  const auto end_of = [&](const std::string& duration) {
    const std::string text =
        replaced("duration = \"0.4 s\"", "duration = \"" + duration + "\"\nend_speed = \"2 mm/s\"", pot);
    const auto outcome = run_in_folder(scene_of(text), tests::absent_folder());
    EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    const auto& warnings = outcome.facts.warnings;
    const bool warned = std::any_of(warnings.begin(), warnings.end(), [](const std::string& sentence) {
      return sentence.find("plunger still moved at ") != sentence.npos &&
             sentence.find("end_speed of 2 mm/s") != sentence.npos;
    });
    return std::pair(outcome.facts.stages.back().end_reason, warned);
  };
  EXPECT_EQ(end_of("0.02 s"), (std::pair<std::string, bool>("duration", true)));
  EXPECT_EQ(end_of("0.4 s"), (std::pair<std::string, bool>("tools at rest", false)));
}

TEST_F(Pot, a_tool_moved_by_its_position_does_not_end_a_stage_that_waits_for_driven_ones) {
  // The pot is drawn away by an offset while the plunger stands still under next to no force.
  std::string text = replaced("duration = \"0.4 s\"", "duration = \"0.02 s\"\nend_speed = \"2 mm/s\"", pot);
  const auto at = text.find("motion.plunger");
  const auto end = text.find('\n', at);
  text = text.substr(0, at) +
         "motion.plunger = { force = \"-1 mN\", speed_limit = \"1 um/s\" }\nmotion.pot = { offset = [[\"0 s\", \"0 "
         "mm\"], [\"0.02 s\", \"-1 mm\"]] }" +
         text.substr(end);
  const auto outcome = run_in_folder(scene_of(text), tests::absent_folder());
  EXPECT_EQ(outcome.facts.stages.back().end_reason, outcome.facts.completed ? "duration" : "failure");
}

std::vector<double> written_times(const std::filesystem::path& pvd) {
  std::ifstream file(pvd);
  std::vector<double> times;
  const std::string key = "timestep=\"";
  for (std::string line; std::getline(file, line);)
    if (const auto at = line.find(key); at != line.npos) times.push_back(std::stod(line.substr(at + key.size())));
  return times;
}

TEST_F(Pot, output_times_are_met_and_change_nothing_of_the_run) {
  scene.stages[0].duration = 0.05;
  scene.output.interval = 0;
  const auto quiet = run_in_folder(scene, (folder / "quiet").string());
  scene.output.interval = 0.01;
  scene.output.times = {0.0123};
  const auto watched = run_in_folder(scene, (folder / "watched").string());
  ASSERT_TRUE(quiet.facts.completed && watched.facts.completed);
  EXPECT_EQ(fingerprint(watched.state), fingerprint(quiet.state));
  const auto times = written_times(folder / "watched" / "glass.pvd");
  const std::vector<double> wanted{0, 0.01, 0.0123, 0.02, 0.03, 0.04, 0.05};
  ASSERT_EQ(times.size(), wanted.size());
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], wanted[i], 1e-12);
  EXPECT_EQ(written_times(folder / "quiet" / "glass.pvd").size(), 2);
}

TEST_F(Pot, a_state_within_a_step_lies_on_its_straight_motion) {
  const State before = initial_state(scene);
  Workspace workspace;
  const auto result = coupled_step(scene, before, 4e-3, workspace);
  ASSERT_TRUE(result.converged) << result.reason;
  const State& after = result.state;
  const State state = interpolate(before, after, 1e-3);
  for (Index n = 0; n < state.glass.mesh.node_count(); ++n)
    EXPECT_NEAR(
        (before.glass.mesh.nodes[n] + 1e-3 * flow::node_velocity(after.glass.velocity, n) - state.glass.mesh.nodes[n])
            .norm(),
        0, 1e-15);
  EXPECT_NEAR(state.tools[1].offset, before.tools[1].offset + 1e-3 * after.tools[1].velocity, 1e-15);
  EXPECT_NEAR((0.75 * before.glass.temperature + 0.25 * after.glass.temperature - state.glass.temperature).norm(), 0,
              1e-9);
  EXPECT_EQ(state.time, 1e-3);
}

TEST_F(Pot, a_new_mesh_keeps_volume_mass_and_heat) {
  State state = initial_state(scene);
  Workspace workspace;
  for (int i = 0; i < 5; ++i) {
    auto result = coupled_step(scene, state, 4e-3, workspace);
    ASSERT_TRUE(result.converged) << result.reason;
    state = std::move(result.state);
  }
  const auto remeshed = remesh_state(scene, state, RemeshReason::quality);
  ASSERT_TRUE(remeshed.ok) << remeshed.reason;
  const auto before = glass_facts(scene, state), after = glass_facts(scene, remeshed.state);
  EXPECT_NEAR(after.mass, before.mass, 1e-12 * before.mass);
  EXPECT_NEAR(glass_heat(scene, remeshed.state), glass_heat(scene, state), 1e-11 * state.glass.initial_heat);
  EXPECT_NEAR(after.volume, before.volume, 1e-6 * before.volume);
  EXPECT_GT(remesh::quality(remeshed.state.glass.mesh).min, 0.3);
  int touching_before = 0, touching_after = 0;
  for (const Index tool : state.glass.contact_tool) touching_before += tool >= 0;
  for (const Index tool : remeshed.state.glass.contact_tool) touching_after += tool >= 0;
  const RemeshStatistics& statistics = remeshed.state.totals.remeshing;
  EXPECT_EQ(statistics.count, (std::array<Index, 3>{0, 1, 0}));
  EXPECT_EQ(statistics.heat, glass_heat(scene, remeshed.state) - glass_heat(scene, state));
  EXPECT_EQ(statistics.max_heat, std::abs(statistics.heat));
  EXPECT_EQ(statistics.volume, after.volume - before.volume);
  EXPECT_EQ(statistics.max_volume, std::abs(statistics.volume));
  EXPECT_EQ(statistics.min_quality, remesh::quality(remeshed.state.glass.mesh).min);
  EXPECT_EQ(statistics.min_median, remesh::quality(remeshed.state.glass.mesh).median);
  EXPECT_GT(touching_before, 10);
  EXPECT_GT(touching_after, 10);
}

TEST_F(Pot, a_failed_step_is_a_value_and_leaves_the_state_alone) {
  // Without any active tool the gob falls: a flow without inertia has no answer.
  scene.stages[0].tools.clear();
  const State state = initial_state(scene);
  Workspace workspace;
  const auto result = coupled_step(scene, state, 1e-3, workspace);
  EXPECT_FALSE(result.converged);
  EXPECT_NE(result.reason.find("not constrained"), std::string::npos) << result.reason;
  EXPECT_EQ(state.totals.steps, 0);
}

TEST_F(Pot, a_change_of_temperature_repeats_a_step_but_not_one_near_the_shortest) {
  StepReport report;
  report.unforeseen_error = 100 * scene.accuracy.work_per_step;
  report.dt = 100 * scene.accuracy.min_step;
  report.strain = scene.accuracy.strain_per_step;
  EXPECT_TRUE(rejected_by_error_control(scene, report));
  report.strain = std::pow(scene.accuracy.strain_per_step, 2);
  EXPECT_TRUE(rejected_by_error_control(scene, report));
  report.flickers = true;
  EXPECT_FALSE(rejected_by_error_control(scene, report)) << "glass that hardly moves opens and closes a contact";
  report.strain = scene.accuracy.strain_per_step;
  report.dt = 5 * scene.accuracy.min_step;
  EXPECT_FALSE(rejected_by_error_control(scene, report)) << "a thin cell where a fold has closed evens out at once";
  report.strain = 10 * scene.accuracy.strain_per_step;
  report.unforeseen_error = 0;
  EXPECT_TRUE(rejected_by_error_control(scene, report)) << "whatever else it changes";
}

TEST_F(Pot, glass_that_lands_by_turns_two_edges_and_none_is_not_held_up_by_the_two) {
  const double allowed = scene.accuracy.landing_per_step * scene.accuracy.surface_size;
  State before = initial_state(scene);
  StepReport two, none;
  two.dt = none.dt = before.last_step = 1e-3;
  two.landed_length = 1.6 * allowed;
  const auto next = [&](const StepReport& report) { return propose_step(scene, before, report, report.dt); };
  EXPECT_NEAR(next(two).dt, 0.9 / 0.8 * two.dt, 1e-12);
  before.last_landed = two.landed_length;
  EXPECT_NEAR(next(none).dt, 0.9 / 0.8 * none.dt, 1e-12) << "two may land again in the next one";
  EXPECT_NEAR(next(two).dt, 0.9 / 1.6 * two.dt, 1e-12);
  before.last_step = 0;
  EXPECT_NEAR(next(two).dt, 0.9 / 1.6 * two.dt, 1e-12) << "nothing is known of the step before";
  two.landed_length = 4 * allowed;
  before.last_step = 1e-3;
  before.last_landed = 0;
  EXPECT_NEAR(next(two).dt, 0.9 / 4 * two.dt, 1e-12) << "a step that is refused counts by itself";
}

TEST(StepControl, a_load_that_falls_within_a_step_is_followed_by_several) {
  Scene scene = scene_of(small_scene);
  State state = initial_state(scene);
  const double free = clip_step_to_event(scene, state, 0.2);
  EXPECT_EQ(free, 0.2);
  scene.stages[0].pressure["surface"] = core::TimeFunction(core::Table{{0.0, 0.2, 0.9}, {1e5, 0.0, 0.0}});
  const double share = scene.accuracy.strain_per_step;
  EXPECT_LE(clip_step_to_event(scene, state, 0.2), 1.001 * share * 0.2);
  state.stage_time = 0.2;
  EXPECT_EQ(clip_step_to_event(scene, state, 0.2), 0.2) << "a load that stays limits nothing";
}

/// A hot ball that a ram presses flat on a plate: place after place of it lands and chills at once.
std::string ball_between_plates(const std::string& numerics) {
  return R"(case = "ball"
geometry = "axisymmetric"
interface = [{ tools = ["plate", "ram"], law = "constant", h = "5e4 W/m2/K" }]
stage = [{ name = "press", duration = "0.3 s", tools = ["plate", "ram"], motion.ram = { force = "-100 N", speed_limit = "50 mm/s" } }]
)" + iron +
         container_glass("1.3 W/m/K") +
         R"([glass]
material = "glass"
temperature = "1150 degC"
boundary = [
  { name = "surface", condition = "contact", path = ["arc centre (0, 10) mm radius 10 mm from -90 deg to 90 deg"] },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" } ]
[[tool]]
name = "plate"
material = "iron"
temperature = "460 degC"
friction = { law = "navier", coefficient = "1e6 Pa.s/m" }
boundary = [
  { name = "top", condition = "contact", path = "(30, 0) (0, 0) mm" },
  { name = "axis", condition = "symmetry", path = "(0, -10) mm" },
  { name = "outer", condition = "insulated", path = "(30, -10) (30, 0) mm" } ]
[[tool]]
name = "ram"
material = "iron"
temperature = "460 degC"
friction = { law = "navier", coefficient = "1e6 Pa.s/m" }
boundary = [
  { name = "face", condition = "contact", path = "(0, 20) (30, 20) mm" },
  { name = "outer", condition = "insulated", path = "(30, 30) (0, 30) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 20) mm" } ]
[numerics]
)" + numerics;
}

TEST(StepControl, glass_that_lands_takes_steps_by_the_error_that_its_cooling_makes) {
  const auto pressed = [](const std::string& numerics) {
    const auto outcome = run(scene_of(ball_between_plates(numerics)), {}, {});
    EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    return outcome.state.totals;
  };
  const Totals usual = pressed(""), fine = pressed("work_per_step = 1e-6\n");
  std::printf("%d steps, heat %.2f J; %d, %.2f J\n", usual.steps, usual.to_tools, fine.steps, fine.to_tools);
  EXPECT_LT(usual.steps, 200) << "369 by 40 K of the surface in a step";
  EXPECT_NEAR(usual.to_tools / fine.to_tools, 1, 0.01);
}

TEST_F(Pot, glass_above_the_tools_is_told_how_far_it_would_fall_onto_which) {
  scene.stages[0].gravity = -9.81;
  State state = initial_state(scene);
  EXPECT_EQ(unsupported_glass(scene, state), "");
  scene.stages[0].tools.resize(1);
  for (Point& node : state.glass.mesh.nodes) node[1] += 3e-3;
  for (Tool& tool : scene.tools) tool.friction.law = flow::Friction::Law::slip;
  const std::string told = unsupported_glass(scene, state), name = scene.tools[scene.stages[0].tools[0].tool].name;
  EXPECT_NE(told.find("it would fall 3 mm along the axis onto " + name), std::string::npos) << told;
  for (Point& node : state.glass.mesh.nodes) node[1] -= 1;
  EXPECT_NE(unsupported_glass(scene, state).find("it would fall past all tools"), std::string::npos);
  scene.stages[0].gravity = 9.81;
  const std::string off = unsupported_glass(scene, initial_state(scene));
  EXPECT_NE(off.find("it would fall past all tools"), std::string::npos) << "off the tool that it stands on: " << off;
}

TEST_F(Pot, a_run_that_cannot_go_on_says_where_and_leaves_its_results) {
  scene.stages[0].tools.clear();
  const auto outcome = run_in_folder(scene, (folder / "results").string());
  EXPECT_FALSE(outcome.facts.completed);
  EXPECT_EQ(outcome.facts.reason.rfind("stage press at 0.00000 s: ", 0), 0u) << outcome.facts.reason;
  EXPECT_TRUE(std::filesystem::exists(folder / "results" / "checkpoint.h5"));
  EXPECT_TRUE(std::filesystem::exists(folder / "results" / "glass.pvd"));
}

TEST_F(Pot, a_motion_that_does_not_start_at_the_position_of_its_tool_stops_the_run) {
  scene.stages[0].tools[1].motion = PositionMotion{{{0, 0.4}, {-1e-3, -3e-3}}};
  const auto outcome = run_in_folder(scene, (folder / "results").string());
  EXPECT_FALSE(outcome.facts.completed);
  EXPECT_NE(outcome.facts.reason.find("tool plunger is at 0 mm, but its motion starts at -1 mm"), std::string::npos)
      << outcome.facts.reason;
}

TEST_F(Pot, a_tool_that_closes_inside_the_glass_stops_the_run) {
  scene.tools[1].position = -2e-3;
  const auto outcome = run_in_folder(scene, (folder / "results").string());
  EXPECT_FALSE(outcome.facts.completed);
  EXPECT_NE(outcome.facts.reason.find("overlaps the glass by 2 mm"), std::string::npos) << outcome.facts.reason;
}

TEST_F(Pot, naming_a_boundary_leaves_symmetry_and_fixed_boundaries_alone) {
  scene.stages[0].named_boundaries.push_back({"inner", {0, 0.01}, {0.01, 0}});
  const State state = start_stage(scene, initial_state(scene), 0);
  const auto& mesh = state.glass.mesh;
  const Index inner = core::find_boundary(mesh, "inner"), axis = core::find_boundary(mesh, "axis");
  int named = 0, on_axis = 0;
  for (const auto& edge : mesh.boundary_edges()) {
    named += edge.boundary_id == inner;
    on_axis += edge.boundary_id == axis;
    if (edge.boundary_id == axis) EXPECT_LT(std::abs(mesh.nodes[edge.nodes[2]][0]), 1e-12);
  }
  EXPECT_GT(named, 0);
  EXPECT_GE(on_axis, 5);
}

TEST(StaticStage, heat_that_changes_fast_does_not_make_a_static_stage_step_back) {
  Scene scene = read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/contact_cylinders", "draft");
  scene.accuracy.initial_step = scene.accuracy.max_step = 0.5;
  scene.stages[0].duration = 1;
  const auto outcome = run_in_folder(scene, tests::absent_folder());
  EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  EXPECT_EQ(outcome.facts.diagnostics.steps.rejected, 0);
  const double exact = 1236161 * M_PI * 0.02 * 0.02;
  EXPECT_NEAR(outcome.state.totals.to_tools, exact, 2e-4 * exact);
}

}  // namespace
}  // namespace parison::forming
