// SPDX-License-Identifier: GPL-3.0-or-later
// Cooling as stages of a run: a plate from its case, stopped and gone on with, and mistakes in such cases.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "figure.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/state/fingerprint.hpp"
#include "forming/step/cooling/cooling_step.hpp"
#include "test_folder.hpp"

namespace parison::forming {
namespace {

/// Half a plate of 3 mm as the middle of a disc, of the glass of the published plates, under a fan from 600 degC.
const std::string plate = R"(case = "plate"
geometry = "axisymmetric"
stage = [{ name = "fan", kind = "cooling", duration = "623 s", air = { temperature = "20 degC", h = "60 W/m2/K", ambient = "20 degC" } }]
[material.reference]
density = "2500 kg/m3"
expansion = { cold_density = "2500 kg/m3", solid = "9e-6 1/K", liquid = "32e-6 1/K", transformation = "573 degC" }
heat_capacity = "1330 J/kg/K"
conductivity = [["0 degC", "0.975 W/m/K"], ["1000 degC", "1.833 W/m/K"]]
viscosity = { law = "vft", A = -27.62366, B = "33093.7 K", T0 = "0.001 K" }
annealing = { young = "70 GPa", poisson = 0.22, frozen_share = 0.5, shear = [[0.05523, 6.658e-5], [0.08205, 1.197e-3],
  [0.1215, 1.514e-2], [0.2286, 0.1672], [0.2860, 0.7497], [0.22662, 3.292]], structure = [[0.05523, 5.965e-4],
  [0.08205, 1.077e-2], [0.1215, 0.1362], [0.2286, 1.505], [0.2860, 6.747], [0.22662, 29.63]] }
[glass]
material = "reference"
temperature = "600 degC"
mesh = { mapped = [12, 12], ratio = [1, 0.4] }
boundary = [
  { name = "middle", path = "(0, 0) (9, 0) mm", condition = "symmetry" },
  { name = "rim", path = "(9, 1.5) mm", condition = "insulated" },
  { name = "surface", path = "(0, 1.5) mm", condition = "air" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" }]
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

class CoolingRun : public ::testing::Test {
 protected:
  const std::filesystem::path folder = tests::new_folder();

  Scene read(const std::string& text, const std::string& accuracy = "draft") const {
    core::write_text(folder / "case.toml", text);
    return read_scene(folder.string(), accuracy);
  }
  std::string complaint(const std::string& text) const {
    try {
      read(text);
    } catch (const core::CaseError& error) {
      return error.what();
    }
    return "";
  }
  void expect_complaint(const std::string& from, const std::string& to, const std::string& said) const {
    const std::string found = complaint(replaced(plate, from, to));
    EXPECT_NE(found.find(said), std::string::npos) << found;
  }
};

/// Hoop stress at the node nearest to a place, MPa.
double hoop(const State& state, const Point& at) {
  Index nearest = 0;
  const auto& nodes = state.glass.mesh.nodes;
  for (Index n = 0; n < state.glass.mesh.node_count(); ++n)
    if ((nodes[n] - at).norm() < (nodes[nearest] - at).norm()) nearest = n;
  return 1e-6 * nodal_stress(state.glass)[4 * nearest + 2];
}

TEST_F(CoolingRun, a_plate_from_its_case_has_its_residual_stress) {
  const RunOutcome outcome = run(read(plate, "standard"), {}, {}, remesh::triangulate);
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  tests::expect_at_most("plate under a fan by a run: surface stress off by",
                        std::abs(hoop(outcome.state, {0, 1.5e-3}) / -10.41 - 1), 5e-3);
  tests::expect_at_most("plate under a fan by a run: stress in the middle off by",
                        std::abs(hoop(outcome.state, {0, 0}) / 5.88 - 1), 5e-3);
  EXPECT_NEAR(1e-6 * outcome.facts.diagnostics.cooling.largest.outer.stress, 8.13, 0.1);
}

TEST_F(CoolingRun, stopped_and_gone_on_with_it_is_the_same_to_the_last_bit) {
  const Scene scene = read(plate);
  const RunOutcome whole = run_in_folder(scene, (folder / "whole").string());
  ASSERT_TRUE(whole.facts.completed) << whole.facts.reason;
  const auto stop_after = [](int steps) { return [steps]() mutable { return --steps == 0; }; };
  const RunOutcome part = run_in_folder(scene, (folder / "part").string(), {}, stop_after(17));
  ASSERT_TRUE(part.facts.stopped);
  const RunOutcome rest = resume_in_folder(scene, (folder / "part").string());
  EXPECT_EQ(fingerprint(rest.state), fingerprint(whole.state));
  EXPECT_EQ(rest.facts.diagnostics.cooling.largest.outer.stress, whole.facts.diagnostics.cooling.largest.outer.stress);
}

TEST_F(CoolingRun, a_lehr_gives_duration_and_air) {
  const Scene scene = read(
      replaced(plate, R"(duration = "623 s", air = { temperature = "20 degC", h = "60 W/m2/K", ambient = "20 degC" })",
               R"(lehr = { belt_speed = "0.6 m/min", zones = [["6 m", "560 degC", "20 W/m2/K"],
  ["12 m", "100 degC", "30 W/m2/K"]] })"));
  const Stage& stage = scene.stages.front();
  EXPECT_NEAR(stage.duration, 1800, 1e-9);
  EXPECT_NEAR(stage.air.air_temperature(300), 833.15, 1e-9);
  EXPECT_NEAR(stage.air.h(1200), 30, 1e-12);
  EXPECT_NEAR(stage.air.ambient_temperature(750), 273.15 + 330, 1e-9);
}

TEST_F(CoolingRun, mistakes_are_told_in_a_sentence_before_the_run) {
  expect_complaint("[0.22662, 3.292]", "[0.5, 3.292]", "weights with the sum");
  expect_complaint("poisson = 0.22", "poisson = 0.5", "0.5 was found, allowed is 0 to below 0.5");
  expect_complaint("frozen_share = 0.5", "frozen_share = 2", "2 was found, allowed is 0 to 1");
  expect_complaint(R"(kind = "cooling")", R"(kind = "coling")", "did you mean \"cooling\"?");
  expect_complaint(R"(duration = "623 s")", R"(duration = "623 s", pressure.surface = "1 bar")",
                   "found in a stage of kind = \"cooling\", allowed only where glass is formed");
  expect_complaint(R"(kind = "cooling", )", R"(lehr = { belt_speed = "1 m/min", zones = [] }, )",
                   "allowed only in a stage of kind = \"cooling\"");
  expect_complaint(R"({ law = "vft", A = -27.62366, B = "33093.7 K", T0 = "0.001 K" })",
                   R"({ law = "constant", value = "1e9 Pa.s" })",
                   "\"cooling\" was found with a constant viscosity, which never sets");
  expect_complaint(R"(duration = "623 s",)", R"(lehr = { belt_speed = "1 m/min", zones = [["6 m", "560 degC"]] },)",
                   "found beside a lehr");
  expect_complaint(R"(temperature = "600 degC")", R"(temperature = "400 degC")", "so that its stress is not known");
  const std::string twice = replaced(plate, "}]\n[material",
                                     "}, { name = \"form\", duration = \"1 s\", air = { temperature = "
                                     "\"20 degC\", h = \"1 W/m2/K\", ambient = \"20 degC\" } }]\n[material");
  EXPECT_NE(complaint(twice).find("the stage forms glass that the stage before has cooled"), std::string::npos)
      << complaint(twice);
}

TEST(Standing, a_bottle_with_a_round_bottom_is_refused_where_it_is_put_down) {
  const std::string bottle = PARISON_SOURCE_DIR "/cases/bottle", cold = "cooling=standard";
  const std::string round = R"(tool.mould.boundary.inner.path=["(13, 16) (25, 36) (25, 86) mm",
    "arc centre (0, 86) mm radius 25 mm from 0 deg to 90 deg"])";
  EXPECT_NO_THROW(read_scene(bottle, "draft", {cold}));
  EXPECT_NO_THROW(read_scene(bottle, "draft", {round})) << "it is not put down";
  try {
    read_scene(bottle, "draft", {cold, round});
    ADD_FAILURE() << "it would fall over";
  } catch (const core::CaseError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("cannot stand was found: its bottom is round, with a radius of 25 mm"), said.npos) << said;
  }
}

}  // namespace
}  // namespace parison::forming
