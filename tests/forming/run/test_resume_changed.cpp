// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that go on from the end of a stage, or with a case that has changed.
#include <gtest/gtest.h>

#include <filesystem>

#include "../scene_text.hpp"
#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/folder_run.hpp"
#include "resume_run.hpp"

namespace parison::forming {
namespace {

/// The case file of the test with a text replaced, read anew.
Scene corrected(const fs::path& folder, const std::string& from, const std::string& to) {
  core::write_text(folder / "case.toml", replaced(from, to, core::read_text(folder / "case.toml")));
  return read_scene(folder.string(), "draft");
}

const std::string rest = "name = \"rest\"\nduration = \"0.1 s\"";

TEST_F(Resume, from_the_end_of_a_stage_a_run_goes_on_as_before_to_the_last_bit) {
  const auto whole = run_in_folder(scene, in("whole"));
  write_summary(in("whole"), scene, whole);
  fs::copy(in("whole"), in("back"), fs::copy_options::recursive);
  return_to_stage_end(in("back"), "press");
  EXPECT_FALSE(fs::exists(in("back/checkpoint_after_rest.h5")));
  const Checkpoint checkpoint = read_checkpoint(find_checkpoint(in("back")), scene);
  EXPECT_EQ(checkpoint.outcome.state.stage, 0);
  EXPECT_LT(checkpoint.files.history_size, fs::file_size(in("whole/history.csv")));
  write_summary(in("back"), scene, resume_in_folder(scene, in("back")));
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
  write_summary(in("parts"), scene, run_in_folder(scene, in("parts")));
  return_to_stage_end(in("parts"), "press");
  const Scene now = corrected(folder, rest, "name = \"rest\"\nduration = \"0.05 s\"");
  write_summary(in("parts"), now, resume_in_folder(now, in("parts")));
  write_summary(in("whole"), now, run_in_folder(now, in("whole")));
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
                      "changes of output, of the stages after \"press\" and of tools that only those use"),
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
