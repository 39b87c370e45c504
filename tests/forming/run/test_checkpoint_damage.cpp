// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <random>

#include "../scene_text.hpp"
#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/hdf5.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/state/fingerprint.hpp"
#include "forming/state/initial_state.hpp"

namespace parison::forming {
namespace {

void write_at(const std::string& folder, const Scene& scene, double time) {
  State state = initial_state(scene);
  state.time = time;
  write_checkpoint(folder, scene, {{state, {}}, {}});
}

double time_of_last(const std::string& folder, const Scene& scene) {
  return read_checkpoint(find_checkpoint(folder), scene).outcome.state.time;
}

void flip(std::string& bytes, std::size_t bit) {
  bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
}

/// PARISON_FLIPS in the environment, or enough for a quick test.
int flips() {
  const char* wanted = std::getenv("PARISON_FLIPS");
  return wanted ? std::atoi(wanted) : 300;
}

TEST(CheckpointDamage, after_any_flipped_bit_the_checkpoint_before_is_taken_and_is_whole) {
  const Scene scene = scene_of(small_scene);
  const std::string folder = tests::new_folder(), last = folder + "/checkpoint.h5";
  for (const double time : {0.25, 0.5}) write_at(folder, scene, time);
  EXPECT_EQ(damage_of_last_checkpoint(folder), "");
  const std::string bytes = core::read_text(last);
  const auto before = fingerprint(read_checkpoint(folder + "/checkpoint_before.h5", scene).outcome.state);
  std::mt19937_64 draw(1);
  for (int i = 0; i < flips(); ++i) {
    const std::size_t bit = draw() % (8 * bytes.size());
    std::string damaged = bytes;
    flip(damaged, bit);
    core::write_text(last, damaged);
    const std::string found = find_checkpoint(folder);
    ASSERT_EQ(found, folder + "/checkpoint_before.h5") << bit;
    ASSERT_EQ(fingerprint(read_checkpoint(found, scene).outcome.state), before);
    ASSERT_THROW(read_checkpoint(last, scene), std::runtime_error) << bit;
  }
  EXPECT_EQ(damage_of_last_checkpoint(folder),
            last + " is damaged or of an earlier version: its digest is missing or does not fit its content");
}

TEST(CheckpointDamage, where_both_are_damaged_both_are_named) {
  const Scene scene = scene_of(small_scene);
  const std::string folder = tests::new_folder();
  for (const double time : {0.25, 0.5}) write_at(folder, scene, time);
  for (const char* name : {"/checkpoint.h5", "/checkpoint_before.h5"}) core::write_text(folder + name, "");
  try {
    find_checkpoint(folder);
    FAIL() << "nothing was thrown";
  } catch (const core::CaseError& error) {
    const std::string said = error.what(), sentence = " is damaged or of an earlier version: its digest is missing";
    EXPECT_EQ(said.rfind(folder + "/checkpoint.h5" + sentence, 0), 0u) << said;
    EXPECT_NE(said.find(folder + "/checkpoint_before.h5" + sentence), said.npos) << said;
    EXPECT_NE(said.find("; no other checkpoint is left, the run must begin anew"), said.npos) << said;
  }
  EXPECT_FALSE(has_checkpoint(folder));
}

TEST(CheckpointDamage, a_damaged_checkpoint_never_takes_the_place_of_the_good_one_before) {
  const Scene scene = scene_of(small_scene);
  const std::string folder = tests::new_folder();
  for (const double time : {0.25, 0.5}) write_at(folder, scene, time);
  core::write_text(folder + "/checkpoint.h5", "damaged");
  write_at(folder, scene, 0.75);
  EXPECT_EQ(time_of_last(folder, scene), 0.75);
  std::filesystem::remove(folder + "/checkpoint.h5");
  EXPECT_EQ(time_of_last(folder, scene), 0.25);
}

TEST(CheckpointDamage, a_file_of_the_user_under_the_name_of_a_checkpoint_is_refused_and_a_damaged_one_is_not) {
  const Scene scene = scene_of(small_scene);
  const std::string folder = tests::new_folder();
  for (const double time : {0.25, 0.5}) write_at(folder, scene, time);
  for (const char* name : {"/checkpoint.h5", "/checkpoint_before.h5", "/checkpoint_after_press.h5"}) {
    const std::string path = folder + name;
    core::write_text(path, "of the user");
    try {
      require_own_checkpoints(folder);
      ADD_FAILURE() << name;
    } catch (const core::CaseError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(path + ": this was not written by parison", 0), 0u) << error.what();
    }
    EXPECT_THROW(resume_in_folder(scene, folder), core::CaseError);
    EXPECT_EQ(core::read_text(path), "of the user");
    std::filesystem::remove(path);
  }
  write_at(folder, scene, 0.25);
  std::string bytes = core::read_text(folder + "/checkpoint.h5");
  flip(bytes, 0);
  core::write_text(folder + "/checkpoint.h5", bytes);
  EXPECT_NO_THROW(require_own_checkpoints(folder));
}

TEST(CheckpointDamage, an_assignment_with_a_line_break_comes_back_whole) {
  const std::string broken = "stage.0.tools=[\n\"plate\"]";
  const Scene scene = read_scene(write_scene(small_scene), "draft", {broken, "stage.0.duration=2 s"});
  const std::string folder = tests::new_folder();
  write_checkpoint(folder, scene, {{initial_state(scene), {}}, {}});
  EXPECT_EQ(read_origin(find_checkpoint(folder)).overrides, (std::vector<std::string>{broken, "stage.0.duration=2 s"}));
}

}  // namespace
}  // namespace parison::forming
