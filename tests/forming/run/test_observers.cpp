// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "../pot_scene.hpp"
#include "../scene_text.hpp"
#include "core/process/run_error.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/state/fingerprint.hpp"

namespace parison::forming {
namespace {

/// The pot with two short stages and a remesh in between; the second without the plunger.
Scene two_stages() {
  std::string text = replaced("output.interval = \"0.2 s\"", "output.interval = \"0.02 s\"", pot);
  text = replaced("duration = \"0.4 s\"", "duration = \"0.05 s\"", text);
  return scene_of(replaced("[material.glass]",
                           "[[stage]]\nname = \"rest\"\nduration = \"0.03 s\"\ngravity = \"-9.81 m/s2\"\n"
                           "tools = [\"pot\"]\n[material.glass]",
                           text));
}

/// Writes down what it is told, and checks what it sees on the way.
class Witness : public RunObserver {
 public:
  std::string events;  ///< a letter each
  std::vector<double> field_times;
  long tried = 0, taken = 0, checkpoints = 0;

  void run_begins(const RunView& run) override {
    events += 'R';
    EXPECT_TRUE(run.facts.stages.empty());
  }
  void stage_begins(const RunView& run) override {
    events += 'S';
    EXPECT_EQ(run.state.stage_time, 0);
  }
  void step_begins(const RunView& run) override { before_ = fingerprint(run.state); }
  void step_tried(const RunView& run, const StepResult& result) override {
    ++tried;
    EXPECT_EQ(fingerprint(run.state), before_);
    EXPECT_TRUE(result.converged || !result.reason.empty());
  }
  void step_taken(const RunView& run, const State& before, const StepReport& report) override {
    ++taken;
    EXPECT_EQ(run.state.totals.steps, taken);
    EXPECT_NEAR(run.state.time - before.time, report.dt, 1e-12);
    EXPECT_GE(run.facts.cpu_seconds, cpu_seconds_);
    cpu_seconds_ = run.facts.cpu_seconds;
  }
  void fields_due(const RunView&, const State& at) override { field_times.push_back(at.time); }
  void checkpoint_possible(const RunView&, bool) override { ++checkpoints; }
  void stage_ends(const RunView& run) override {
    events += 'E';
    EXPECT_EQ(run.facts.stages.back().end, run.state.time);
  }
  void run_ends(const RunView& run) override {
    events += run.facts.completed ? 'C' : 'F';
    EXPECT_EQ(run.facts.reason.empty(), run.facts.completed);
  }

 private:
  std::uint64_t before_ = 0;
  double cpu_seconds_ = 0;
};

/// Throws after so many steps.
template <typename Error>
class Thrower : public RunObserver {
 public:
  Thrower(int steps, Error error) : steps_(steps), error_(error) {}
  void step_taken(const RunView&, const State&, const StepReport&) override {
    if (--steps_ == 0) throw error_;
  }

 private:
  int steps_;
  Error error_;
};

TEST(Observers, a_run_without_any_and_one_with_files_and_a_witness_give_the_same_bits) {
  const Scene scene = two_stages();
  const RunOutcome alone = run(scene);
  ASSERT_TRUE(alone.facts.completed) << alone.facts.reason;
  Witness witness;
  const RunOutcome watched = run_in_folder(scene, tests::absent_folder(), {&witness});
  EXPECT_EQ(fingerprint(watched.state), fingerprint(alone.state));
  EXPECT_EQ(watched.facts.warnings, alone.facts.warnings);
}

TEST(Observers, an_observer_is_told_of_each_stage_step_output_time_and_the_end_in_their_order) {
  const Scene scene = two_stages();
  Witness witness;
  const RunOutcome outcome = run(scene, {&witness});
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  EXPECT_EQ(witness.events, "RSESEC");
  EXPECT_EQ(witness.taken, outcome.state.totals.steps);
  EXPECT_EQ(witness.tried, outcome.state.totals.steps + outcome.facts.diagnostics.steps.rejected);
  EXPECT_EQ(witness.checkpoints, witness.taken + 3);  // at the run's start and at each stage's end too
  const std::vector<double> wanted{0, 0.02, 0.04, 0.05, 0.06, 0.08, 0.08};
  ASSERT_EQ(witness.field_times.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(witness.field_times[i], wanted[i], 1e-12);
}

TEST(Observers, a_run_is_taken_up_again_from_what_an_observer_kept_to_the_last_bit) {
  class Keeper : public RunObserver {
   public:
    RunOutcome kept;
    void checkpoint_possible(const RunView& run, bool) override {
      if (run.state.totals.steps == 3) kept = {run.state, run.facts};
    }
  } keeper;
  const Scene scene = two_stages();
  const RunOutcome whole = run(scene, {&keeper});
  ASSERT_EQ(keeper.kept.state.totals.steps, 3);
  EXPECT_EQ(fingerprint(resume(scene, std::move(keeper.kept)).state), fingerprint(whole.state));
}

TEST(Observers, what_the_system_refuses_to_an_observer_ends_the_run_with_its_sentence) {
  Thrower<core::RunError> refused(4, core::RunError("history.csv: cannot be written"));
  Witness witness;
  const RunOutcome outcome = run(two_stages(), {&refused, &witness});
  EXPECT_FALSE(outcome.facts.completed);
  EXPECT_FALSE(outcome.facts.stopped);
  EXPECT_NE(outcome.facts.reason.find("s: history.csv: cannot be written"), std::string::npos) << outcome.facts.reason;
  EXPECT_EQ(outcome.facts.stages.back().end_reason, "failure");
  EXPECT_EQ(outcome.state.totals.steps, 4);
  EXPECT_EQ(witness.events, "RSF");
}

TEST(Observers, a_mistake_in_the_program_is_no_failed_run_and_leaves_the_last_checkpoint) {
  Scene scene = two_stages();
  scene.output.checkpoint_steps = 1;
  Thrower<std::logic_error> mistaken(4, std::logic_error("a wrong index"));
  Thrower<std::bad_alloc> greedy(4, std::bad_alloc());
  const std::string folder = tests::new_folder();
  EXPECT_THROW(run_in_folder(scene, folder + "/mistaken", {&mistaken}), std::logic_error);
  EXPECT_THROW(run_in_folder(scene, folder + "/greedy", {&greedy}), std::bad_alloc);
  const RunOutcome whole = run(scene);
  for (const char* name : {"/mistaken", "/greedy"}) {
    EXPECT_EQ(read_checkpoint(find_checkpoint(folder + name), scene).outcome.state.totals.steps, 3);
    EXPECT_EQ(fingerprint(resume_in_folder(scene, folder + name).state), fingerprint(whole.state));
  }
}

TEST(Observers, a_run_without_fields_writes_tables_alone_until_it_is_stopped_and_goes_on_to_the_last_bit) {
  namespace fs = std::filesystem;
  const Scene scene = two_stages();
  const std::string folder = tests::new_folder();
  const auto has = [&](const std::string& name) { return fs::exists(folder + name); };
  const RunFiles tables{false, false, {}}, shared{false, false, {scene.stages[0].name}};
  const RunOutcome whole = run_in_folder(scene, folder + "/whole", {}, {}, remesh::triangulate, tables);
  ASSERT_TRUE(whole.facts.completed) << whole.facts.reason;
  EXPECT_EQ(fingerprint(whole.state), fingerprint(run(scene).state));
  for (const auto& entry : fs::directory_iterator(folder + "/whole/vtu"))
    EXPECT_EQ(entry.path().filename(), ".parison_written") << "nothing but the manifest";
  EXPECT_FALSE(has("/whole/glass.pvd") || has("/whole/checkpoint.h5"));
  EXPECT_GT(fs::file_size(folder + "/whole/history.csv"), 0u);

  run_in_folder(scene, folder + "/shared", {}, {}, remesh::triangulate, shared);
  EXPECT_TRUE(has("/shared/checkpoint_after_" + scene.stages[0].name + ".h5"));
  EXPECT_FALSE(has("/shared/checkpoint_after_" + scene.stages[1].name + ".h5"));

  int asked = 0;
  const StopRequest after_five = [&] { return ++asked == 5; };
  EXPECT_TRUE(run_in_folder(scene, folder + "/stopped", {}, after_five, remesh::triangulate, tables).facts.stopped);
  EXPECT_TRUE(has("/stopped/checkpoint.h5") && has("/stopped/glass.pvd") && has("/stopped/vtu/glass_0000.vtu"));
  const RunOutcome resumed = resume_in_folder(scene, folder + "/stopped", {}, {}, remesh::triangulate, tables);
  EXPECT_EQ(fingerprint(resumed.state), fingerprint(whole.state));
}

TEST(Observers, a_request_to_stop_stops_after_the_step_and_changes_nothing_else) {
  const Scene scene = two_stages();
  int asked = 0;
  Witness witness;
  const RunOutcome outcome = run(scene, {&witness}, [&] { return ++asked == 5; });
  EXPECT_TRUE(outcome.facts.stopped);
  EXPECT_EQ(outcome.state.totals.steps + outcome.facts.diagnostics.steps.rejected, 5);
  EXPECT_EQ(outcome.facts.stages.back().end_reason, "stop");
  EXPECT_EQ(witness.events, "RSEF");
  asked = 0;
  const RunOutcome whole = run(scene, {}, [&] { return ++asked, false; });
  EXPECT_EQ(fingerprint(whole.state), fingerprint(run(scene).state));
  EXPECT_EQ(asked, whole.state.totals.steps + whole.facts.diagnostics.steps.rejected);
}

TEST(Observers, glass_is_remeshed_by_the_mesher_that_the_run_is_given) {
  int meshed = 0;
  const auto counting = [&](const remesh::Outline& outline, const remesh::SizeField& size) {
    ++meshed;
    return remesh::triangulate(outline, size);
  };
  const Scene scene = two_stages();
  const RunOutcome outcome = run(scene, {}, {}, counting);
  EXPECT_GE(meshed, 1);
  EXPECT_EQ(meshed, remeshes(outcome.state));
  EXPECT_EQ(fingerprint(outcome.state), fingerprint(run(scene).state));
}

}  // namespace
}  // namespace parison::forming
