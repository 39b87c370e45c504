// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that are killed, meet each other or run out of room.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <regex>
#include <thread>

#include "core/io/files.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/folder_run.hpp"
#include "resume_run.hpp"

namespace parison::forming {
namespace {

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
  write_summary(in("whole"), scene, whole);
  const long steps = whole.state.totals.steps;
  ASSERT_TRUE(kill_at(start_process([&] { return run_in_folder(scene, in("killed")).facts.completed; }), in("killed"),
                      steps / 5));
  for (const long lines : {2 * steps / 5, 4 * steps / 5})
    ASSERT_TRUE(kill_at(start_process([&] { return resume_in_folder(scene, in("killed")).facts.completed; }),
                        in("killed"), lines));
  write_summary(in("killed"), scene, resume_in_folder(scene, in("killed")));
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

/// Runs in a process where `hinder` has been called, and writes the summary if that can be; why the run ended.
std::string reason_when_hindered(const Scene& scene, const std::string& folder, const std::function<void()>& hinder,
                                 const StopRequest& each_step = {}) {
  const pid_t process = start_process([&] {
    hinder();
    const auto outcome = run_in_folder(scene, folder, {}, each_step);
    core::write_text(folder + ".reason", outcome.facts.reason);
    write_summary(folder, scene, outcome);
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
    const rlimit room{begun + 3000, begun + 3000};  // a checkpoint of later stages is larger
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
  write_summary(in("full"), scene, resume_in_folder(scene, in("full")));
  write_summary(in("whole"), scene, run_in_folder(scene, in("whole")));
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

}  // namespace
}  // namespace parison::forming
