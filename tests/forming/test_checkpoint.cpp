// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include "core/io/files.hpp"
#include "core/io/hdf5.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/state/fingerprint.hpp"
#include "forming/state/initial_state.hpp"
#include "scene_text.hpp"

namespace parison::forming {
namespace {

/// A state in which no two numbers are alike.
State busy_state(const Scene& scene) {
  State state = initial_state(scene);
  double next = 1 / 3.0;
  const auto fresh = [&](double& value) { value = next *= -1.0000001; };
  for (double* value : {&state.time, &state.stage_time, &state.stage_start, &state.next_step, &state.heat_substep,
                        &state.last_step, &state.density, &state.initial_volume, &state.initial_heat})
    fresh(*value);
  Totals& totals = state.totals;
  for (double* value : {&totals.to_air,
                        &totals.to_tools,
                        &totals.dissipation,
                        &totals.remeshing.heat,
                        &totals.remeshing.max_heat,
                        &totals.remeshing.volume,
                        &totals.remeshing.max_volume,
                        &totals.remeshing.min_quality,
                        &totals.remeshing.min_median,
                        &totals.max_penetration,
                        &totals.max_drift,
                        &totals.max_reynolds,
                        &totals.max_flux_mismatch,
                        &totals.overshoot,
                        &totals.remeshing.transfer_overshoot,
                        &totals.remeshing.coarsening_factor,
                        &totals.remeshing.lap_volume,
                        &totals.work.tools,
                        &totals.work.gravity,
                        &totals.work.air,
                        &totals.work.dissipation,
                        &totals.work.friction,
                        &totals.work.impact_loss,
                        &totals.work.surface,
                        &totals.work.correction})
    fresh(*value);
  for (BodyState& body : state.bodies) {
    for (double* value : {&body.offset, &body.velocity, &body.force, &body.heat_received, &body.max_surface_temperature,
                          &body.peak_force})
      fresh(*value);
    for (double& value : body.temperature) fresh(value);
    for (Point& x : body.mesh.nodes) fresh(x[0]), fresh(x[1]);
  }
  for (Point& x : state.mass_nodes) fresh(x[0]), fresh(x[1]);
  for (Point& x : state.probes) fresh(x[0]), fresh(x[1]);
  for (double& value : state.velocity) fresh(value);
  for (double& value : state.contact.pressure) fresh(value);
  for (Eigen::VectorXd* values : {&state.acceleration, &state.dilatation_mode, &state.temperature_rate}) {
    values->resize(5);
    for (double& value : *values) fresh(value);
  }
  state.heat_couplings = {4, 7, 1, 3};
  state.moves_smoothly = !state.moves_smoothly;
  state.contact.tool_before = {2, 1, 0};
  totals.remeshing.failed = 12, totals.remeshing.laps = 13;
  state.contact.tool[3] = 1;
  state.contact.active = {{3, 5}, {1, 0}, {Point(0.6, 0.8), Point(-1, 0)}};
  state.stage = 1;
  state.next_limit = 5;
  state.has_moved = true;
  totals.steps = 7, totals.rejected = 8, totals.remeshing.count = {9, 10, 11}, totals.clamped_lookups = 1L << 40;
  state.bodies[0].mesh.boundary_names.push_back("inner, by name");
  state.bodies[0].mesh.boundary[0].boundary_id = 2;
  state.velocity[0] = std::numeric_limits<double>::infinity();
  return state;
}

bool same(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}
bool same(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return same(x, y); });
}
bool same(const std::vector<Point>& a, const std::vector<Point>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const Point& x, const Point& y) {
           return same(x[0], y[0]) && same(x[1], y[1]);
         });
}
bool same(const core::Mesh& a, const core::Mesh& b) {
  const auto same_edge = [](const core::BoundaryEdge& x, const core::BoundaryEdge& y) {
    return x.nodes == y.nodes && x.cell == y.cell && x.boundary_id == y.boundary_id;
  };
  return same(a.nodes, b.nodes) && a.vertex_count == b.vertex_count && a.cells == b.cells &&
         a.boundary_names == b.boundary_names && a.boundary.size() == b.boundary.size() &&
         std::equal(a.boundary.begin(), a.boundary.end(), b.boundary.begin(), same_edge);
}

void expect_same_totals(const Totals& a, const Totals& b) {
  EXPECT_TRUE(same(a.to_air, b.to_air));
  EXPECT_TRUE(same(a.to_tools, b.to_tools));
  EXPECT_TRUE(same(a.dissipation, b.dissipation));
  EXPECT_EQ(a.remeshing.count, b.remeshing.count);
  EXPECT_TRUE(same(a.remeshing.heat, b.remeshing.heat));
  EXPECT_TRUE(same(a.remeshing.max_heat, b.remeshing.max_heat));
  EXPECT_TRUE(same(a.remeshing.volume, b.remeshing.volume));
  EXPECT_TRUE(same(a.remeshing.max_volume, b.remeshing.max_volume));
  EXPECT_TRUE(same(a.remeshing.min_quality, b.remeshing.min_quality));
  EXPECT_TRUE(same(a.remeshing.min_median, b.remeshing.min_median));
  EXPECT_TRUE(same(a.max_penetration, b.max_penetration));
  EXPECT_TRUE(same(a.max_drift, b.max_drift));
  EXPECT_TRUE(same(a.max_reynolds, b.max_reynolds));
  EXPECT_TRUE(same(a.max_flux_mismatch, b.max_flux_mismatch));
  for (double Work::*part : {&Work::tools, &Work::gravity, &Work::air, &Work::dissipation, &Work::friction,
                             &Work::arrival, &Work::surface, &Work::corrections})
    EXPECT_TRUE(same(a.work.*part, b.work.*part));
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.rejected, b.rejected);
  EXPECT_EQ(a.clamped_lookups, b.clamped_lookups);
}

void expect_same_body(const BodyState& a, const BodyState& b) {
  EXPECT_TRUE(same(a.mesh, b.mesh));
  EXPECT_TRUE(same(a.temperature, b.temperature));
  EXPECT_TRUE(same(a.offset, b.offset));
  EXPECT_TRUE(same(a.velocity, b.velocity));
  EXPECT_TRUE(same(a.force, b.force));
  EXPECT_TRUE(same(a.heat_received, b.heat_received));
  EXPECT_TRUE(same(a.max_surface_temperature, b.max_surface_temperature));
}

RunFacts some_facts() {
  RunFacts facts;
  facts.wall_seconds = 1.5;
  facts.cpu_seconds = 1.25;
  facts.timing["heat"] = 0.75;
  facts.stages = {{"rest", 0, 1 / 3.0, "duration", {1, 2, 3, 4, 5, 6, 1 / 7.0, 8}}};
  facts.warnings = {"at 0.1 s something", "something else"};
  facts.solver_statistics.flow_solves = 1L << 33;
  facts.solver_statistics.limited_by.back() = 3;
  return facts;
}

TEST(Checkpoint, AStateComesBackToTheBit) {
  const Scene scene = scene_of(small_scene);
  const State state = busy_state(scene);
  const std::string folder = tests::new_folder();
  write_checkpoint(folder, scene, {{state, some_facts()}, {1L << 33, 7, {0, 1 / 3.0}}});
  const Checkpoint checkpoint = read_checkpoint(find_checkpoint(folder), scene);
  const State& read = checkpoint.outcome.state;
  EXPECT_TRUE(same(read.time, state.time));
  EXPECT_EQ(read.stage, state.stage);
  EXPECT_TRUE(same(read.stage_time, state.stage_time));
  EXPECT_TRUE(same(read.stage_start, state.stage_start));
  EXPECT_EQ(read.has_moved, state.has_moved);
  EXPECT_TRUE(same(read.next_step, state.next_step));
  EXPECT_EQ(read.next_limit, state.next_limit);
  EXPECT_TRUE(same(read.heat_substep, state.heat_substep));
  EXPECT_TRUE(same(read.last_step, state.last_step));
  EXPECT_TRUE(same(read.mass_nodes, state.mass_nodes));
  EXPECT_TRUE(same(read.density, state.density));
  EXPECT_TRUE(same(read.initial_volume, state.initial_volume));
  EXPECT_TRUE(same(read.initial_heat, state.initial_heat));
  EXPECT_TRUE(same(read.velocity, state.velocity));
  EXPECT_EQ(read.contact.tool, state.contact.tool);
  EXPECT_EQ(read.contact.active.node, state.contact.active.node);
  EXPECT_EQ(read.contact.active.tool, state.contact.active.tool);
  EXPECT_TRUE(same(read.contact.active.normal, state.contact.active.normal));
  EXPECT_TRUE(same(read.contact.pressure, state.contact.pressure));
  EXPECT_EQ(read.contact.tool_before, state.contact.tool_before);
  EXPECT_TRUE(same(read.acceleration, state.acceleration));
  EXPECT_TRUE(same(read.dilatation_mode, state.dilatation_mode));
  EXPECT_TRUE(same(read.temperature_rate, state.temperature_rate));
  EXPECT_EQ(read.heat_couplings, state.heat_couplings);
  EXPECT_EQ(read.moves_smoothly, state.moves_smoothly);
  EXPECT_TRUE(same(read.totals.overshoot, state.totals.overshoot));
  EXPECT_TRUE(same(read.totals.remeshing.transfer_overshoot, state.totals.remeshing.transfer_overshoot));
  EXPECT_TRUE(same(read.totals.remeshing.coarsening_factor, state.totals.remeshing.coarsening_factor));
  EXPECT_EQ(read.totals.remeshing.failed, state.totals.remeshing.failed);
  EXPECT_TRUE(same(read.totals.remeshing.lap_volume, state.totals.remeshing.lap_volume));
  EXPECT_EQ(read.totals.remeshing.laps, state.totals.remeshing.laps);
  for (std::size_t i = 0; i < read.bodies.size(); ++i)
    EXPECT_TRUE(same(read.bodies[i].peak_force, state.bodies[i].peak_force));
  EXPECT_TRUE(same(read.probes, state.probes));
  expect_same_totals(read.totals, state.totals);
  ASSERT_EQ(read.bodies.size(), state.bodies.size());
  for (std::size_t i = 0; i < read.bodies.size(); ++i) expect_same_body(read.bodies[i], state.bodies[i]);
  EXPECT_EQ(fingerprint(read), fingerprint(state));
  EXPECT_EQ(checkpoint.files.history_size, 1L << 33);
  EXPECT_EQ(checkpoint.files.interface_size, 7);
  EXPECT_EQ(checkpoint.files.output_times, (std::vector<double>{0, 1 / 3.0}));
  const RunFacts& facts = checkpoint.outcome.facts;
  EXPECT_EQ(facts.wall_seconds, 1.5);
  EXPECT_EQ(facts.cpu_seconds, 1.25);
  EXPECT_EQ(facts.timing.at("heat"), 0.75);
  ASSERT_EQ(facts.stages.size(), 1u);
  EXPECT_EQ(facts.stages[0].name, "rest");
  EXPECT_EQ(facts.stages[0].end, 1 / 3.0);
  EXPECT_EQ(facts.stages[0].end_reason, "duration");
  EXPECT_EQ(facts.stages[0].work.surface, 1 / 7.0);
  EXPECT_EQ(facts.warnings, (std::vector<std::string>{"at 0.1 s something", "something else"}));
  EXPECT_EQ(facts.solver_statistics.flow_solves, 1L << 33);
  EXPECT_EQ(facts.solver_statistics.limited_by.back(), 3);
}

TEST(Checkpoint, AFingerprintTellsStatesApartThatDifferInOneBit) {
  const State state = busy_state(scene_of(small_scene));
  State other = state;
  other.bodies[1].temperature[5] = std::nextafter(other.bodies[1].temperature[5], 0);
  EXPECT_NE(fingerprint(other), fingerprint(state));
  other = state;
  other.totals.remeshing.count[2] += 1;
  EXPECT_NE(fingerprint(other), fingerprint(state));
}

TEST(Checkpoint, TheLastTwoAreKeptAndTheEarlierOneServesWhereTheLastIsBroken) {
  const Scene scene = scene_of(small_scene);
  const std::string folder = tests::new_folder();
  for (const double time : {0.25, 0.5, 0.75}) {
    State state = initial_state(scene);
    state.time = time;
    write_checkpoint(folder, scene, {{state, {}}, {}});
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 2);
  const std::string last = find_checkpoint(folder);
  EXPECT_EQ(read_checkpoint(last, scene).outcome.state.time, 0.75);
  core::write_text(last, core::read_text(last).substr(0, 1000));
  EXPECT_EQ(read_checkpoint(find_checkpoint(folder), scene).outcome.state.time, 0.5);
}

std::string complaint_of_reading(const std::string& path, const Scene& scene) {
  try {
    read_checkpoint(path, scene);
  } catch (const core::CaseError& error) {
    return error.what();
  }
  return "";
}

TEST(Checkpoint, OneOfAnotherCaseFileAccuracyOrVersionIsRefusedWithASentence) {
  const Scene scene = scene_of(small_scene);
  const std::string folder = tests::new_folder();
  write_checkpoint(folder, scene, {{initial_state(scene), {}}, {}});
  const std::string path = find_checkpoint(folder);
  EXPECT_EQ(complaint_of_reading(path, scene), "");
  EXPECT_EQ(read_origin(path).file, scene.file);
  EXPECT_EQ(read_origin(path).accuracy, "draft");
  EXPECT_EQ(complaint_of_reading(path, scene_of(replaced("1000 degC", "1001 degC"))),
            path +
                ": a checkpoint of the case \"small\" with another case file was found, allowed is one of \"small\" as "
                "it is now");
  Scene fine = scene;
  fine.accuracy_name = "fine";
  EXPECT_EQ(complaint_of_reading(path, fine),
            path + ": a checkpoint at draft accuracy was found, allowed is one at fine accuracy");
  const std::string kept = path + ".kept";
  std::filesystem::copy_file(path, kept);
  core::write_hdf5(path, [](core::Hdf5Group& file) { file.write("version", std::int64_t{99}); });
  EXPECT_EQ(complaint_of_reading(path, scene), path + ": a checkpoint of version 99 was found, allowed is version 6");
  const std::int64_t version = core::open_hdf5(kept).read_integer("version");
  core::write_hdf5(path, [&](core::Hdf5Group& file) {
    file.write("version", version);
    file.write("layout", core::open_hdf5(kept).read_integer("layout") + 1);
  });
  EXPECT_EQ(
      complaint_of_reading(path, scene),
      path + ": a checkpoint whose state holds other values was found, allowed is one of this version of the program");
}

TEST(Checkpoint, TheCaseSaysHowOftenTheyAreWritten) {
  const std::string own = small_scene + "[output]\ncheckpoint_interval = \"2 min\"\ncheckpoint_steps = 7\n";
  EXPECT_EQ(scene_of(own).output.checkpoint_interval, 120);
  EXPECT_EQ(scene_of(own).output.checkpoint_steps, 7);
  EXPECT_EQ(scene_of(small_scene).output.checkpoint_interval, 300);
  EXPECT_FALSE(scene_of(small_scene).output.checkpoint_steps);
  const std::string never = replaced("steps = 7", "steps = 0", own);
  EXPECT_NE(complaint_about(never).find("output.checkpoint_steps: "), std::string::npos) << complaint_about(never);
}

TEST(Checkpoint, AnOutlineInAFileOfItsOwnBelongsToTheCase) {
  const std::string text = replaced("path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\"", "csv = \"outline.csv\"");
  const auto outline = [&](const char* radius) {
    core::write_text(write_scene(text) + "/outline.csv",
                     std::string("r_mm,z_mm\n0,0\n") + radius + ",0\n20,10\n0,10\n");
    return scene_of(text).fingerprint;
  };
  const auto first = outline("20");
  EXPECT_NE(outline("19.5"), first);
  EXPECT_EQ(outline("20"), first);
}

}  // namespace
}  // namespace parison::forming
