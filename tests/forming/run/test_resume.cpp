// SPDX-License-Identifier: GPL-3.0-or-later
// A run that is stopped and goes on is the uninterrupted one.
#include <gtest/gtest.h>

#include <set>

#include "../scene_text.hpp"
#include "core/io/files.hpp"
#include "forming/remeshing/remesh_state.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/state/fingerprint.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/step.hpp"
#include "resume_run.hpp"

namespace parison::forming {
namespace {

/// Two cylinders in which nothing moves, over two seconds.
Scene static_stage() {
  Scene scene = read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/contact_cylinders", "draft");
  scene.accuracy.max_step = 0.1;
  scene.stages[0].duration = 2;
  scene.output.interval = 0.5;
  return scene;
}

TEST_F(Resume, a_run_stopped_again_and_again_is_the_uninterrupted_one_to_the_last_bit_and_so_is_a_second_run) {
  const auto whole = run_in_folder(scene, in("whole"));
  ASSERT_TRUE(whole.facts.completed) << whole.facts.reason;
  ASSERT_GE(remeshes(whole.state), 4);
  write_summary(in("whole"), scene, whole);
  write_summary(in("again"), scene, run_in_folder(scene, in("again")));
  expect_same_results(in("again"), in("whole"));

  auto outcome = run_in_folder(scene, in("parts"), {}, stop_after(4));
  std::set<Index> remeshes_before;
  int parts = 0;
  for (int steps = 5; !outcome.facts.completed; ++steps, ++parts) {
    ASSERT_TRUE(outcome.facts.stopped) << outcome.facts.reason;
    EXPECT_NE(outcome.facts.reason.find("the run was stopped on request"), std::string::npos);
    EXPECT_EQ(outcome.facts.stages.back().end_reason, "stop");
    remeshes_before.insert(remeshes(outcome.state));
    outcome = resume_in_folder(scene, in("parts"), {}, stop_after(steps));
  }
  EXPECT_GE(parts, 5);
  EXPECT_GE(remeshes_before.size(), 3u);
  EXPECT_GT(outcome.facts.wall_seconds, 0.2 * whole.facts.wall_seconds);
  write_summary(in("parts"), scene, outcome);
  expect_same_results(in("parts"), in("whole"));
  // A run that is over has nothing left to do.
  write_summary(in("parts"), scene, resume_in_folder(scene, in("parts")));
  expect_same_results(in("parts"), in("whole"));
}

/// The same with light in bands, and surfaces that see each other.
std::string with_light() {
  const std::string radiation =
      R"(radiation = { model = "transfer", refractive_index = 1.5, bands = [{ up_to = "2.75 um", absorption = "150 1/m" }] }
)";
  std::string text = replaced("emissivity = 0.89\n", "emissivity = 0.89\n" + radiation, two_stages());
  text = replaced("[material.iron]\n", "[material.iron]\nemissivity = 0.8\n", text);
  return "enclosure = true\n" + text;
}

TEST_F(Resume, where_light_was_traced_is_part_of_the_state_to_the_last_bit) {
  core::write_text(folder / "case.toml", with_light());
  scene = read_scene(folder.string(), "draft coarser 2");
  const auto whole = run_in_folder(scene, in("whole"), {}, stop_after(14));
  ASSERT_TRUE(whole.facts.stopped) << whole.facts.reason;
  EXPECT_FALSE(whole.state.light.rays.empty());
  EXPECT_FALSE(whole.state.light.views.empty());
  // Its time is counted apart from that of the heat.
  EXPECT_GT(whole.facts.timing.at("radiation"), 0);
  EXPECT_GT(whole.facts.timing.at("heat"), 0);
  // Light was traced some steps before the run is stopped, and is not traced where it goes on.
  const auto begun = run_in_folder(scene, in("parts"), {}, stop_after(5));
  EXPECT_NE(begun.state.light.rays, begun.state.glass.mesh.nodes);
  const auto parts = resume_in_folder(scene, in("parts"), {}, stop_after(9));
  ASSERT_TRUE(parts.facts.stopped) << parts.facts.reason;
  EXPECT_EQ(parts.state.totals.steps, whole.state.totals.steps);
  EXPECT_EQ(fingerprint(parts.state), fingerprint(whole.state));
}

TEST_F(Resume, trapped_air_is_part_of_the_state_to_the_last_bit) {
  const std::string air =
      "trapped_air = { law = \"adiabatic\", temperature = \"500 degC\", vent_area = \"0.1 mm2\" }\n";
  core::write_text(folder / "case.toml", air + two_stages());
  scene = read_scene(folder.string(), "draft");
  const auto whole = run_in_folder(scene, in("whole"));
  ASSERT_TRUE(whole.facts.completed) << whole.facts.reason;
  write_summary(in("whole"), scene, whole);
  const std::string history = core::read_text(in("whole") + "/history.csv");
  EXPECT_NE(history.find(",cavities,"), std::string::npos);
  auto outcome = run_in_folder(scene, in("parts"), {}, stop_after(5));
  std::size_t sealed = 0;
  while (!outcome.facts.completed) {
    ASSERT_TRUE(outcome.facts.stopped) << outcome.facts.reason;
    sealed = std::max(sealed, outcome.state.cavity_air.volume.size());
    outcome = resume_in_folder(scene, in("parts"), {}, stop_after(5));
  }
  EXPECT_GE(sealed, 1u);
  write_summary(in("parts"), scene, outcome);
  expect_same_results(in("parts"), in("whole"));
}

TEST_F(Resume, a_step_does_not_depend_on_what_the_solvers_keep) {
  State state = initial_state(scene);
  Workspace used;
  for (int i = 0; i < 4; ++i) {
    auto result = coupled_step(scene, state, 2e-3, used);
    ASSERT_TRUE(result.converged) << result.reason;
    state = std::move(result.state);
  }
  Workspace fresh;
  EXPECT_EQ(fingerprint(coupled_step(scene, state, 2e-3, used).state),
            fingerprint(coupled_step(scene, state, 2e-3, fresh).state));
}

TEST_F(Resume, a_static_stage_goes_on_from_its_last_checkpoint_to_the_same_bits) {
  scene = static_stage();
  scene.output.checkpoint_steps = 4;
  write_summary(in("whole"), scene, run_in_folder(scene, in("whole")));
  auto outcome = run_in_folder(scene, in("parts"), {}, stop_after(10));
  for (const Index steps : {8, 16}) {
    ASSERT_TRUE(outcome.facts.stopped);
    EXPECT_EQ(read_checkpoint(find_checkpoint(in("parts")), scene).outcome.state.totals.steps, steps);
    outcome = resume_in_folder(scene, in("parts"), {}, stop_after(9));
  }
  write_summary(in("parts"), scene, resume_in_folder(scene, in("parts")));
  expect_same_results(in("parts"), in("whole"));
}

TEST_F(Resume, a_checkpoint_by_the_clock_in_a_static_stage_changes_no_bit) {
  scene = static_stage();
  scene.accuracy.temperature_tolerance = 1e-6;  // many steps of the integrator
  scene.accuracy.max_step = 0.05;
  write_summary(in("whole"), scene, run_in_folder(scene, in("whole")));
  scene.output.checkpoint_interval = 1e-9;
  ASSERT_TRUE(run_in_folder(scene, in("parts"), {}, stop_after(36)).facts.stopped);
  const Index steps = read_checkpoint(find_checkpoint(in("parts")), scene).outcome.state.totals.steps;
  EXPECT_GT(steps, 0);
  EXPECT_LT(steps, 36);
  write_summary(in("parts"), scene, resume_in_folder(scene, in("parts")));
  expect_same_results(in("parts"), in("whole"));
}

}  // namespace
}  // namespace parison::forming
