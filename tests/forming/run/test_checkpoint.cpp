// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <type_traits>

#include "../scene_text.hpp"
#include "core/io/files.hpp"
#include "core/io/hdf5.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/state/fingerprint.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/state/visit_state.hpp"

namespace parison::forming {
namespace {

/// Gives every value that it visits another number; no two are alike.
struct Fill {
  double& next;
  double fresh() { return next *= -1.0000001; }
  void operator()(const char*, double& value) { value = fresh(); }
  void operator()(const char*, std::vector<double>& values) { values = {fresh(), fresh()}; }
  void operator()(const char*, bool& value) { value = !value; }
  void operator()(const char*, int& value) { value = static_cast<int>(1e6 * fresh()); }
  void operator()(const char*, long& value) { value = (1L << 40) + static_cast<long>(1e6 * fresh()); }
  void operator()(const char*, Eigen::VectorXd& values) {
    values.resize(7);
    for (double& value : values) value = fresh();
  }
  void operator()(const char* name, std::vector<int>& values) {
    values.resize(8);
    for (int& value : values) (*this)(name, value);
  }
  void operator()(const char*, std::vector<Point>& points) {
    points.resize(6);
    for (Point& x : points) x = {fresh(), fresh()};
  }
  void operator()(const char* name, core::Mesh& mesh) {
    for (Point& x : mesh.nodes) x = {fresh(), fresh()};
    mesh.edit().boundaries.emplace_back(std::string("inner, named in ") + name, core::BoundaryKind::fixed);
    mesh.edit().boundary_edges[0].boundary_id = 2;
  }
  Fill part(const std::string&) { return *this; }
};

State busy_state(const Scene& scene) {
  State state = initial_state(scene);
  double next = 1 / 3.0;
  visit_state(Fill{next}, state);
  state.stage = 1;
  state.glass.velocity[0] = std::numeric_limits<double>::infinity();
  return state;
}

/// The bits of every value that it visits, by name.
struct Collect {
  std::map<std::string, std::string>& bits;
  std::string path;
  void add(const char* name, const void* data, std::size_t size) {
    const bool is_new = bits.emplace(path + name, std::string(static_cast<const char*>(data), size)).second;
    EXPECT_TRUE(is_new) << path << name << " is listed twice";
  }
  template <typename Value>
  std::enable_if_t<std::is_arithmetic_v<Value>> operator()(const char* name, const Value& value) {
    add(name, &value, sizeof value);
  }
  template <typename Value>
  std::enable_if_t<!std::is_arithmetic_v<Value>> operator()(const char* name, const Value& values) {
    add(name, values.data(), static_cast<std::size_t>(values.size()) * sizeof *values.data());
  }
  void operator()(const char* name, const core::Mesh& mesh) {
    add(name, mesh.nodes.data(), mesh.nodes.size() * sizeof(Point));
    add("cells", mesh.cells().data(), mesh.cells().size() * sizeof mesh.cells()[0]);
    add("edges", mesh.boundary_edges().data(), mesh.boundary_edges().size() * sizeof(core::BoundaryEdge));
    for (std::size_t i = 0; i < mesh.boundaries().size(); ++i) {
      const auto& [boundary, kind] = mesh.boundaries()[i];
      add(("boundary " + std::to_string(i)).c_str(), boundary.data(), boundary.size());
      add(("kind " + std::to_string(i)).c_str(), &kind, sizeof kind);
    }
  }
  Collect part(const std::string& name) { return {bits, path + name + '/'}; }
};

std::map<std::string, std::string> bits_of(const State& state) {
  std::map<std::string, std::string> bits;
  visit_state(Collect{bits, ""}, state);
  return bits;
}

RunFacts some_facts() {
  RunFacts facts;
  facts.wall_seconds = 1.5;
  facts.cpu_seconds = 1.25;
  facts.timing["heat"] = 0.75;
  facts.stages = {{"rest", 0, 1 / 3.0, "duration", {1, 2, 3, 4, 5, 6, 1 / 7.0, 8}}};
  facts.warnings = {"at 0.1 s something", "something else"};
  facts.unfilled = "the plunger stood short";
  facts.diagnostics.steps.flow_solves = 1L << 33;
  facts.diagnostics.extremes.glass = {900, 0.25, {1, 2}, 0.125, 1 / 3.0};
  facts.diagnostics.extremes.tools = {{}, {800, 0.5, {3, 4}, 0.375, 1 / 7.0}};
  facts.diagnostics.steps.limited_by.back() = 3;
  return facts;
}

TEST(Checkpoint, a_state_comes_back_to_the_bit) {
  const Scene scene = scene_of(small_scene);
  const State state = busy_state(scene);
  const std::string folder = tests::new_folder();
  write_checkpoint(folder, scene, {{state, some_facts()}, {1L << 33, 5, 7, {0, 1 / 3.0}, 11, {1 / 7.0}, 1 / 9.0}});
  const Checkpoint checkpoint = read_checkpoint(find_checkpoint(folder), scene);
  const State& read = checkpoint.outcome.state;
  const auto written = bits_of(state), found = bits_of(read);
  EXPECT_GT(written.size(), 60u);
  for (const auto& [name, bits] : written) EXPECT_TRUE(found.count(name) && found.at(name) == bits) << name;
  EXPECT_EQ(fingerprint(read), fingerprint(state));
  EXPECT_EQ(checkpoint.files.history_size, 1L << 33);
  EXPECT_EQ(checkpoint.files.tools_size, 5);
  EXPECT_EQ(checkpoint.files.interface_size, 7);
  EXPECT_EQ(checkpoint.files.solid_history_size, 11);
  EXPECT_EQ(checkpoint.files.solid_output_times, (std::vector<double>{1 / 7.0}));
  EXPECT_EQ(checkpoint.files.stage_lowest, 1 / 9.0);
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
  EXPECT_EQ(facts.unfilled, "the plunger stood short");
  EXPECT_EQ(facts.diagnostics.steps.flow_solves, 1L << 33);
  EXPECT_EQ(facts.diagnostics.steps.limited_by.back(), 3);
  EXPECT_EQ(facts.diagnostics.extremes.glass.at, Point(1, 2));
  EXPECT_EQ(facts.diagnostics.extremes.glass.seconds_beyond, 1 / 3.0);
  EXPECT_TRUE(std::isnan(facts.diagnostics.extremes.tools.at(0).temperature));
  EXPECT_EQ(facts.diagnostics.extremes.tools.at(1).temperature, 800);
  EXPECT_EQ(facts.diagnostics.extremes.tools.at(1).time, 0.5);
  EXPECT_EQ(facts.diagnostics.extremes.tools.at(1).first_beyond, 0.375);
}

TEST(Checkpoint, a_fingerprint_tells_states_apart_that_differ_in_one_bit) {
  const State state = busy_state(scene_of(small_scene));
  State other = state;
  other.tools[0].temperature[5] = std::nextafter(other.tools[0].temperature[5], 0);
  EXPECT_NE(fingerprint(other), fingerprint(state));
  other = state;
  other.totals.remeshing.count[2] += 1;
  EXPECT_NE(fingerprint(other), fingerprint(state));
}

TEST(Checkpoint, the_last_two_are_kept_and_the_earlier_one_serves_where_the_last_is_broken) {
  const Scene scene = scene_of(small_scene);
  const std::string folder = tests::new_folder();
  for (const double time : {0.25, 0.5, 0.75}) {
    State state = initial_state(scene);
    state.time = time;
    write_checkpoint(folder, scene, {{state, {}}, {}});
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 3);  // with the manifest
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

TEST(Checkpoint, one_of_another_case_file_accuracy_or_version_is_refused_with_a_sentence) {
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
  EXPECT_EQ(complaint_of_reading(path, scene), path + ": a checkpoint of version 99 was found, allowed is version 16");
  const std::int64_t version = core::open_hdf5(kept).read_integer("version");
  core::write_hdf5(path, [&](core::Hdf5Group& file) {
    file.write("version", version);
    file.write("layout", core::open_hdf5(kept).read_integer("layout") + 1);
  });
  EXPECT_EQ(
      complaint_of_reading(path, scene),
      path + ": a checkpoint whose state holds other values was found, allowed is one of this version of the program");
}

TEST(Checkpoint, the_case_says_how_often_they_are_written) {
  const std::string own = small_scene + "[output]\ncheckpoint_interval = \"2 min\"\ncheckpoint_steps = 7\n";
  EXPECT_EQ(scene_of(own).output.checkpoint_interval, 120);
  EXPECT_EQ(scene_of(own).output.checkpoint_steps, 7);
  EXPECT_EQ(scene_of(small_scene).output.checkpoint_interval, 300);
  EXPECT_FALSE(scene_of(small_scene).output.checkpoint_steps);
  const std::string never = replaced("steps = 7", "steps = 0", own);
  EXPECT_NE(complaint_about(never).find("output.checkpoint_steps: "), std::string::npos) << complaint_about(never);
}

TEST(Checkpoint, an_outline_in_a_file_of_its_own_belongs_to_the_case) {
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
