// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/comparison/run_queue.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/json_read.hpp"
#include "core/io/written_files.hpp"
#include "core/process/build_id.hpp"
#include "core/process/gmsh_module.hpp"
#include "core/process/run_error.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/study/coarse_run.hpp"
#include "forming/study/comparison/what_if/finished_base.hpp"
#include "tools/program/child_process.hpp"
#include "tools/program/exit_codes.hpp"
#include "tools/program/stop_request.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;
using forming::PlannedRun;
using Status = QueuedRun::Status;

std::string summary_path(const PlannedRun& plan) {
  return plan.directory + "/summary.json";
}

std::string log_path(const PlannedRun& plan) {
  return plan.directory + ".log";
}

void require_accuracy(const std::string& found, const PlannedRun& plan) {
  if (found == plan.accuracy) return;
  throw core::CaseError(
      fmt::format("{}: a run at \"{}\" accuracy was found, where \"{}\" is asked for; allowed are the accuracy of the "
                  "runs that are there, or another --output",
                  plan.directory, found, plan.accuracy));
}

[[noreturn]] void refuse_other_settings(const PlannedRun& plan) {
  throw core::CaseError(
      fmt::format("{}: a run of another case or with other settings was found, allowed is a name of its own for each "
                  "variant, or another --output",
                  plan.directory));
}

/// A summary made with other settings says that the folder belongs to something else.
void require_same(const core::JsonValue& summary, const PlannedRun& plan, const std::string& case_path) {
  const forming::Scene scene = forming::read_scene(case_path, plan.accuracy, plan.overrides);
  if (summary.text_of("program_build") != core::build_id())
    throw core::CaseError(
        fmt::format("{}: a run by another build of the program was found, which may differ from this one in its "
                    "numbers; allowed is another --output",
                    plan.directory));
  require_accuracy(summary.text_of("accuracy"), plan);
  if (summary.text_of("case_fingerprint") != core::fingerprint_text(scene.fingerprint)) refuse_other_settings(plan);
}

/// The same of a run that has not ended: it has the assignments of the planned one, or the first of them where it was
/// branched off and has not begun.
void require_same_origin(const PlannedRun& plan) {
  const forming::CaseOrigin origin = forming::read_origin(forming::find_checkpoint(plan.directory));
  require_accuracy(origin.accuracy, plan);
  const auto &found = origin.overrides, &planned = plan.overrides;
  if (found.size() > planned.size() || !std::equal(found.begin(), found.end(), planned.begin()))
    refuse_other_settings(plan);
}

std::string last_line(const std::string& path) {
  std::error_code unreadable;
  if (!fs::exists(path, unreadable)) return "no output";
  std::string text = core::read_text(path);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

struct Queue {
  std::vector<QueuedRun>& runs;
  const std::string case_path;
  std::size_t ended = 0;

  void say(const QueuedRun& run, const std::string& what) const {
    fmt::print("[{:2}/{}] {:<40} {}\n", ended, runs.size(), run.plan.label, what);
    std::fflush(stdout);
  }
  void end(QueuedRun& run, Status status, const std::string& what) {
    run.status = status;
    if (status == Status::failed) run.reason = what;
    ++ended;
    say(run, status == Status::failed ? "no results: " + what : what);
  }
};

const QueuedRun* run_in(const Queue& queue, const std::string& directory) {
  for (const QueuedRun& run : queue.runs)
    if (run.plan.directory == directory) return &run;
  return nullptr;
}

/// What the summary of a run says; false where it was stopped and has to go on.
bool end_by_summary(Queue& queue, QueuedRun& run, const std::string& remark) {
  const auto summary = core::read_json_file(summary_path(run.plan));
  if (!summary || summary->flag_of("stopped")) return false;
  if (summary->flag_of("completed"))
    queue.end(run, Status::done, fmt::format("done{}", remark));
  else
    queue.end(run, Status::failed, summary->text_of("reason"));
  return true;
}

/// Whether what a run needs is there; a run whose need will never be there fails.
bool is_ready(Queue& queue, QueuedRun& run) {
  if (const auto& branch = run.plan.branch) {
    const QueuedRun* source = run_in(queue, branch->directory);
    if (source && source->status == Status::failed) {
      queue.end(run, Status::failed, fmt::format("{} stopped", source->plan.label));
      return false;
    }
    if (source && source->status != Status::done) return false;
  }
  if (run.plan.inside.empty()) return true;
  const QueuedRun* outer = run_in(queue, run.plan.inside);
  if (outer && outer->status == Status::failed) {
    queue.end(run, Status::failed, fmt::format("{} stopped", outer->plan.label));
    return false;
  }
  return fs::exists(run.plan.inside + "/history.csv");
}

void start_child(Queue& queue, QueuedRun& run, const std::vector<std::string>& arguments, const std::string& what) {
  run.child = start_self(arguments, log_path(run.plan));
  run.status = Status::running;
  queue.say(run, what);
}

/// Resumes from the last checkpoint of the folder, with the assignments that the run there does not have yet.
void resume(Queue& queue, QueuedRun& run, const std::string& what) {
  const std::size_t known = forming::read_origin(forming::find_checkpoint(run.plan.directory)).overrides.size();
  std::vector<std::string> arguments{"resume", run.plan.directory, "--keep-going", "--case", queue.case_path};
  for (std::size_t i = known; i < run.plan.overrides.size(); ++i)
    arguments.insert(arguments.end(), {"--set", run.plan.overrides[i]});
  start_child(queue, run, arguments, what);
}

/// Makes or continues a run whose results only the comparison reads: without fields. Returns an exit code.
int make_partner(const PlannedRun& plan, const std::string& case_path) {
  forming::RunFiles files;
  files.fields = false;
  try {
    const forming::CoarseCase run{case_path, plan.accuracy, plan.directory, plan.overrides, 1};
    return forming::finish(run, {}, stop_requested, files) ? 0 : run_failed;
  } catch (const std::exception& error) {  // its last words in the log
    fmt::print("{}\n", error.what());
    return run_failed;
  }
}

/// In a copy of this process, which need not be started and have its modules loaded again.
void start_partner(Queue& queue, QueuedRun& run, const std::string& what) {
  core::open_gmsh_module();
  run.child = start_work([&] { return make_partner(run.plan, queue.case_path); }, log_path(run.plan));
  run.status = Status::running;
  queue.say(run, what);
}

/// What is in the folder of a planned run may be that run, whole or in part, and nothing else.
void require_folder_for(const PlannedRun& plan, const std::string& case_path) {
  const auto summary = core::read_json_file(summary_path(plan));
  const bool is_begun = forming::has_checkpoint(plan.directory), is_over = summary && !summary->flag_of("stopped");
  if (summary) require_same(*summary, plan, case_path);
  if (!summary && is_begun) require_same_origin(plan);
  if (!is_begun && !is_over) core::require_own(plan.directory);  // it is removed
  core::require_own(log_path(plan));
}

void start(Queue& queue, QueuedRun& run) {
  const PlannedRun& plan = run.plan;
  const bool is_copied = !plan.copy_of.empty() && !core::read_json_file(summary_path(plan));
  if (is_copied) forming::copy_results(plan);
  require_folder_for(plan, queue.case_path);
  if (end_by_summary(queue, run, is_copied ? ", from " + plan.copy_of : ", from before")) return;
  const bool is_partner = !plan.inside.empty();
  if (forming::has_checkpoint(plan.directory))
    return is_partner ? start_partner(queue, run, "goes on") : resume(queue, run, "goes on");
  core::remove_own(plan.directory);  // what was killed before its first checkpoint
  core::remove_own(log_path(plan));
  if (plan.branch) {
    forming::make_branch(plan, queue.case_path);
    const std::string how = fmt::format("starts after {}", plan.branch->stage);
    return is_partner ? start_partner(queue, run, how) : resume(queue, run, how);
  }
  if (is_partner) return start_partner(queue, run, "starts");
  fs::create_directories(fs::path(plan.directory).parent_path());
  std::vector<std::string> arguments{"run",      queue.case_path, "--accuracy",   plan.accuracy,
                                     "--output", plan.directory,  "--keep-going", "--later-counts"};
  for (const std::string& assignment : plan.overrides) arguments.insert(arguments.end(), {"--set", assignment});
  start_child(queue, run, arguments, "starts");
}

/// Starts what is ready; what is refused or cannot be started now, after others have run, is a run without results.
void start_or_fail(Queue& queue, QueuedRun& run) {
  try {
    start(queue, run);
  } catch (const core::CaseError& error) {
    queue.end(run, Status::failed, error.what());
  } catch (const core::RunError& error) {
    queue.end(run, Status::failed, error.what());
  }
}

/// Why a run that can go on has not come to its end, by its summary or its last words.
std::string why_it_stopped(const PlannedRun& plan) {
  const auto summary = core::read_json_file(summary_path(plan));
  return (summary ? "it was interrupted in " + summary->text_of("reason") : last_line(log_path(plan))) +
         "; the same command goes on with it";
}

void collect_ended(Queue& queue) {
  for (QueuedRun& run : queue.runs) {
    if (run.status != Status::running || !has_ended(run.child)) continue;
    run.status = Status::waiting;
    if (end_by_summary(queue, run, "") || stop_requested()) continue;
    queue.end(run, Status::failed, why_it_stopped(run.plan));
  }
}

int count(const Queue& queue, Status status) {
  return static_cast<int>(
      std::count_if(queue.runs.begin(), queue.runs.end(), [&](const QueuedRun& run) { return run.status == status; }));
}

}  // namespace

bool run_all(std::vector<QueuedRun>& runs, const std::string& case_path, int jobs) {
  Queue queue{runs, case_path};
  for (const QueuedRun& run : runs) require_folder_for(run.plan, case_path);
  bool requested = false;
  for (;;) {
    for (QueuedRun& run : runs)
      if (!stop_requested() && count(queue, Status::running) < jobs && run.status == Status::waiting &&
          is_ready(queue, run))
        start_or_fail(queue, run);
    if (stop_requested() && !std::exchange(requested, true))
      for (const QueuedRun& run : runs)
        if (run.status == Status::running) request_stop(run.child);
    if (count(queue, Status::running) == 0 && (stop_requested() || count(queue, Status::waiting) == 0))
      return !stop_requested();
    usleep(poll_microseconds);
    collect_ended(queue);
  }
}

double cpu_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace parison::tools
