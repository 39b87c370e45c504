// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <thread>

#include "../pot_scene.hpp"
#include "../scene_text.hpp"
#include "core/io/files.hpp"
#include "forming/remeshing/remesh_state.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/state/fingerprint.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/step.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;

/// The pot, with remeshes in mid-stage, and a second stage without the plunger.
std::string two_stages() {
  std::string text = pot + "quality_floor = 0.6\n";
  text = replaced("output.interval = \"0.2 s\"", "output.interval = \"0.02 s\"\noutput.checkpoint_steps = 3", text);
  text = replaced("duration = \"0.4 s\"", "duration = \"0.1 s\"", text);
  return replaced(
      "[material.glass]",
      "[[stage]]\nname = \"rest\"\nduration = \"0.1 s\"\ngravity = \"-9.81 m/s2\"\ntools = [\"pot\"]\n[material.glass]",
      text);
}

class Resume : public ::testing::Test {
 protected:
  const fs::path folder = tests::absent_folder();
  Scene scene;

  void SetUp() override {
    fs::create_directories(folder);
    fs::permissions(folder, fs::perms::all);
    core::write_text(folder / "case.toml", two_stages());
    scene = read_scene(folder.string(), "draft");
  }
  void TearDown() override { fs::remove_all(folder); }
  std::string in(const std::string& name) const { return (folder / name).string(); }
};

/// Two cylinders in which nothing moves, over two seconds.
Scene static_stage() {
  Scene scene = read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/contact_cylinders", "draft");
  scene.accuracy.max_step = 0.1;
  scene.stages[0].duration = 2;
  scene.output.interval = 0.5;
  return scene;
}

/// Every file of a result folder by its name; the summary without what the clock says, checkpoints left out.
std::map<std::string, std::string> results(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder);
    if (!entry.is_regular_file() || entry.path().extension() == ".h5") continue;
    files[name] = core::read_text(entry.path());
    if (name == "summary.json")
      files[name] = std::regex_replace(
          files[name], std::regex("\"(wall_seconds|cpu_seconds|seconds|flow|heat|contact|remesh|output)\": [^\n]*\n"),
          "");
  }
  return files;
}

void write_summary_of(const Scene& scene, const std::string& folder, const RunOutcome& outcome) {
  write_summary(folder, scene, outcome.state, outcome.facts);
}

void expect_same_results(const std::string& folder, const std::string& reference) {
  const auto a = results(folder), b = results(reference);
  std::set<std::string> names;
  for (const auto* files : {&a, &b})
    for (const auto& [name, text] : *files) names.insert(name);
  EXPECT_GT(names.size(), 12u);
  for (const auto& name : names) EXPECT_TRUE(a.count(name) && b.count(name) && a.at(name) == b.at(name)) << name;
}

/// Asks to stop once, after `steps` steps from now.
StopRequest stop_after(int steps) {
  return [steps]() mutable { return --steps == 0; };
}

TEST_F(Resume, a_run_stopped_again_and_again_is_the_uninterrupted_one_to_the_last_bit_and_so_is_a_second_run) {
  const auto whole = run_in_folder(scene, in("whole"));
  ASSERT_TRUE(whole.facts.completed) << whole.facts.reason;
  ASSERT_GE(remeshes(whole.state), 4);
  write_summary_of(scene, in("whole"), whole);
  write_summary_of(scene, in("again"), run_in_folder(scene, in("again")));
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
  write_summary_of(scene, in("parts"), outcome);
  expect_same_results(in("parts"), in("whole"));
  // A run that is over has nothing left to do.
  write_summary_of(scene, in("parts"), resume_in_folder(scene, in("parts")));
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
  write_summary_of(scene, in("whole"), whole);
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
  write_summary_of(scene, in("parts"), outcome);
  expect_same_results(in("parts"), in("whole"));
}

/// Does the work in a process of its own.
pid_t start_process(const std::function<bool()>& work) {
  const pid_t process = ::fork();
  if (process == 0) {
    std::freopen("/dev/null", "w", stdout);
    ::_exit(work() ? 0 : 1);
  }
  return process;
}

long lines_in(const std::string& path) {
  if (!fs::exists(path)) return 0;
  const std::string text = core::read_text(path);
  return std::count(text.begin(), text.end(), '\n');
}

/// Kills a process when history.csv has so many lines; false when it ended before.
bool kill_at(pid_t process, const std::string& results, long lines) {
  int status = 0;
  while (lines_in(results + "/history.csv") < lines || !fs::exists(results + "/checkpoint.h5")) {
    if (::waitpid(process, &status, WNOHANG) != 0) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ::kill(process, SIGKILL);
  ::waitpid(process, &status, 0);
  return WIFSIGNALED(status);
}

TEST_F(Resume, a_run_killed_three_times_ends_as_the_uninterrupted_one_to_the_last_bit) {
  const auto whole = run_in_folder(scene, in("whole"));
  write_summary_of(scene, in("whole"), whole);
  const long steps = whole.state.totals.steps;
  ASSERT_TRUE(kill_at(start_process([&] { return run_in_folder(scene, in("killed")).facts.completed; }), in("killed"),
                      steps / 5));
  for (const long lines : {2 * steps / 5, 4 * steps / 5})
    ASSERT_TRUE(kill_at(start_process([&] { return resume_in_folder(scene, in("killed")).facts.completed; }),
                        in("killed"), lines));
  write_summary_of(scene, in("killed"), resume_in_folder(scene, in("killed")));
  expect_same_results(in("killed"), in("whole"));
}

TEST_F(Resume, a_folder_in_use_by_a_run_is_refused_to_another) {
  const pid_t process = start_process(
      [&] { return run_in_folder(scene, in("used"), {}, [] { return ::pause() != 0; }).facts.completed; });
  while (!fs::exists(in("used/checkpoint.h5"))) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_THROW(resume_in_folder(scene, in("used")), std::runtime_error);
  ::kill(process, SIGKILL);
  ::waitpid(process, nullptr, 0);
  EXPECT_TRUE(resume_in_folder(scene, in("used"), {}, stop_after(1)).facts.stopped);
}

/// The case file of the test with a text replaced, read anew.
Scene corrected(const fs::path& folder, const std::string& from, const std::string& to) {
  core::write_text(folder / "case.toml", replaced(from, to, core::read_text(folder / "case.toml")));
  return read_scene(folder.string(), "draft");
}

const std::string rest = "name = \"rest\"\nduration = \"0.1 s\"";

TEST_F(Resume, from_the_end_of_a_stage_a_run_goes_on_as_before_to_the_last_bit) {
  const auto whole = run_in_folder(scene, in("whole"));
  write_summary_of(scene, in("whole"), whole);
  fs::copy(in("whole"), in("back"), fs::copy_options::recursive);
  return_to_stage_end(in("back"), "press");
  EXPECT_FALSE(fs::exists(in("back/checkpoint_after_rest.h5")));
  const Checkpoint checkpoint = read_checkpoint(find_checkpoint(in("back")), scene);
  EXPECT_EQ(checkpoint.outcome.state.stage, 0);
  EXPECT_LT(checkpoint.files.history_size, fs::file_size(in("whole/history.csv")));
  write_summary_of(scene, in("back"), resume_in_folder(scene, in("back")));
  expect_same_results(in("back"), in("whole"));
  try {
    return_to_stage_end(in("back"), "prss");
    FAIL();
  } catch (const core::CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("no checkpoint of the end of a stage \"prss\" was found, allowed are "),
              std::string::npos);
  }
}

TEST_F(Resume, with_a_later_stage_corrected_a_run_is_that_of_the_corrected_case) {
  write_summary_of(scene, in("parts"), run_in_folder(scene, in("parts")));
  return_to_stage_end(in("parts"), "press");
  const Scene now = corrected(folder, rest, "name = \"rest\"\nduration = \"0.05 s\"");
  write_summary_of(now, in("parts"), resume_in_folder(now, in("parts")));
  write_summary_of(now, in("whole"), run_in_folder(now, in("whole")));
  expect_same_results(in("parts"), in("whole"));
}

TEST_F(Resume, with_a_change_of_what_the_run_has_used_it_is_refused_by_its_key) {
  run_in_folder(scene, in("parts"), {}, stop_after(5));
  const auto complaint = [&](const std::string& from, const std::string& to) {
    const std::string text = core::read_text(folder / "case.toml");
    std::string found;
    try {
      read_checkpoint(find_checkpoint(in("parts")), corrected(folder, from, to));
    } catch (const core::CaseError& error) {
      found = error.what();
    }
    core::write_text(folder / "case.toml", text);
    return found;
  };
  EXPECT_EQ(complaint(rest, "name = \"rest\"\nduration = \"0.05 s\""), "");
  EXPECT_EQ(complaint("interval = \"0.02 s\"", "interval = \"0.03 s\""), "");
  EXPECT_NE(complaint("name = \"press\"\nduration = \"0.1 s\"", "name = \"press\"\nduration = \"0.2 s\"")
                .find(": stage.press.duration has changed, which the run up to this checkpoint has used; allowed are "
                      "changes of output and of the stages after \"press\""),
            std::string::npos);
  EXPECT_NE(
      complaint("temperature = \"1100 degC\"", "temperature = \"1101 degC\"").find(": glass.temperature has changed"),
      std::string::npos);
}

TEST_F(Resume, a_changed_copy_of_the_case_is_refused_or_taken_up_where_it_is_named) {
  run_in_folder(scene, in("parts"), {}, stop_after(5));
  const std::string copy = in("parts/case/case.toml"), text = core::read_text(copy);
  EXPECT_NO_THROW(require_unchanged_copy(in("parts"), scene));
  for (const auto& [from, to] : {std::pair{rest, "name = \"rest\"\nduration = \"0.05 s\""},
                                 std::pair{std::string("[material.glass]"), "[material.glas]"}}) {
    core::write_text(copy, replaced(from, to, text));
    try {
      require_unchanged_copy(in("parts"), scene);
      FAIL() << to;
    } catch (const core::CaseError& error) {
      EXPECT_NE(std::string(error.what()).find("/parts/case/case.toml: this copy of the case"), std::string::npos);
    }
  }
  core::write_text(copy, replaced(rest, "name = \"rest\"\nduration = \"0.05 s\"", text));
  const Scene now = read_scene(in("parts/case"), "draft");
  EXPECT_NO_THROW(require_unchanged_copy(in("parts"), now));
  const auto outcome = resume_in_folder(now, in("parts"));
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  EXPECT_NEAR(outcome.state.time, 0.15, 1e-12);
  // A case that has changed where it is, and the copy as it was; and a case that is again as at the end of a stage.
  EXPECT_NO_THROW(require_unchanged_copy(in("parts"), scene));
}

TEST_F(Resume, a_result_folder_has_the_case_that_was_run) {
  run_in_folder(scene, in("copy"), {}, stop_after(1));
  EXPECT_EQ(core::read_text(in("copy/case/case.toml")), core::read_text(in("case.toml")));
  EXPECT_EQ(core::read_text(in("copy/case/command.txt")), "parison run case --accuracy 'draft'\n");
  EXPECT_EQ(read_scene(in("copy/case"), "draft").fingerprint, scene.fingerprint);
}

/// Runs in a process where `hinder` has been called, and writes the summary if that can be; why the run ended.
std::string reason_when_hindered(const Scene& scene, const std::string& folder, const std::function<void()>& hinder,
                                 const StopRequest& each_step = {}) {
  const pid_t process = start_process([&] {
    hinder();
    const auto outcome = run_in_folder(scene, folder, {}, each_step);
    core::write_text(folder + ".reason", outcome.facts.reason);
    write_summary_of(scene, folder, outcome);
    return true;
  });
  ::waitpid(process, nullptr, 0);
  return core::read_text(folder + ".reason");
}

TEST_F(Resume, a_run_out_of_room_says_so_and_goes_on_from_its_last_checkpoint_when_there_is_room) {
  run_in_folder(scene, in("begun"), {}, stop_after(5));
  const auto begun = static_cast<rlim_t>(fs::file_size(in("begun/checkpoint.h5")));
  const std::string reason = reason_when_hindered(scene, in("full"), [&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit room{begun + 1000, begun + 1000};  // a checkpoint of later stages is larger
    ::setrlimit(RLIMIT_FSIZE, &room);
  });
  EXPECT_TRUE(
      std::regex_match(reason, std::regex("stage (press|rest) at 0\\.\\d+ s: .*: cannot be written: File too large")))
      << reason;
  const std::string summary = core::read_text(in("full/summary.json"));
  EXPECT_NE(summary.find("\"completed\": false"), summary.npos);
  EXPECT_NE(summary.find("cannot be written: File too large\""), summary.npos);
  const auto checkpoint = read_checkpoint(find_checkpoint(in("full")), scene);
  EXPECT_GT(checkpoint.outcome.state.totals.steps, 3);
  write_summary_of(scene, in("full"), resume_in_folder(scene, in("full")));
  write_summary_of(scene, in("whole"), run_in_folder(scene, in("whole")));
  expect_same_results(in("full"), in("whole"));
}

TEST_F(Resume, a_folder_made_read_only_ends_the_run_with_a_sentence_and_leaves_the_checkpoint) {
  int steps = 0;
  const auto shut = [&] {
    if (++steps == 8)
      for (const char* part : {"ro/vtu", "ro"}) ::chmod(in(part).c_str(), 0555);
    return false;
  };
  const auto without_rights = [] {
    if (::geteuid() == 0 && ::setuid(65534) != 0) ::_exit(2);  // no permission stops the superuser
  };
  const std::string reason = reason_when_hindered(scene, in("ro"), without_rights, shut);
  EXPECT_NE(reason.find("Permission denied"), reason.npos) << reason;
  EXPECT_GE(read_checkpoint(find_checkpoint(in("ro")), scene).outcome.state.totals.steps, 6);
  for (const char* part : {"ro", "ro/vtu"}) fs::permissions(in(part), fs::perms::owner_all);
  EXPECT_TRUE(resume_in_folder(scene, in("ro"), {}, stop_after(1)).facts.stopped);
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
  write_summary_of(scene, in("whole"), run_in_folder(scene, in("whole")));
  auto outcome = run_in_folder(scene, in("parts"), {}, stop_after(10));
  for (const Index steps : {8, 16}) {
    ASSERT_TRUE(outcome.facts.stopped);
    EXPECT_EQ(read_checkpoint(find_checkpoint(in("parts")), scene).outcome.state.totals.steps, steps);
    outcome = resume_in_folder(scene, in("parts"), {}, stop_after(9));
  }
  write_summary_of(scene, in("parts"), resume_in_folder(scene, in("parts")));
  expect_same_results(in("parts"), in("whole"));
}

TEST_F(Resume, a_checkpoint_by_the_clock_in_a_static_stage_changes_no_bit) {
  scene = static_stage();
  scene.accuracy.temperature_tolerance = 1e-6;  // many steps of the integrator
  scene.accuracy.max_step = 0.05;
  write_summary_of(scene, in("whole"), run_in_folder(scene, in("whole")));
  scene.output.checkpoint_interval = 1e-9;
  ASSERT_TRUE(run_in_folder(scene, in("parts"), {}, stop_after(36)).facts.stopped);
  const Index steps = read_checkpoint(find_checkpoint(in("parts")), scene).outcome.state.totals.steps;
  EXPECT_GT(steps, 0);
  EXPECT_LT(steps, 36);
  write_summary_of(scene, in("parts"), resume_in_folder(scene, in("parts")));
  expect_same_results(in("parts"), in("whole"));
}

TEST_F(Resume, a_folder_without_a_checkpoint_is_refused) {
  try {
    resume_in_folder(scene, in("nothing"));
    FAIL() << "nothing was thrown";
  } catch (const core::CaseError& error) {
    EXPECT_EQ(std::string(error.what()), in("nothing") +
                                             ": no checkpoint was found, allowed is the result folder of a run "
                                             "that has begun");
  }
}

}  // namespace
}  // namespace parison::forming
