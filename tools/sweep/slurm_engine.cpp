// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/sweep/slurm_engine.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>

#include "core/case/case_error.hpp"
#include "core/case/given_file.hpp"
#include "core/case/number.hpp"
#include "core/io/files.hpp"
#include "core/io/written_files.hpp"
#include "core/process/clock.hpp"
#include "core/process/run_error.hpp"
#include "tools/program/child_process.hpp"
#include "tools/program/stop_request.hpp"
#include "tools/sweep/run_pool.hpp"

namespace parison::tools {

namespace {

constexpr int no_such_program = 127;

/// The last line of what Slurm said, without the name of its command.
std::string sentence(const std::string& text) {
  std::string_view last;
  core::Lines lines(text);
  for (std::string_view line; lines.next(line);)
    if (!core::trimmed(line).empty()) last = line;
  for (const std::string_view mark : {"error: ", "fatal: "})
    if (const auto at = last.rfind(mark); at != last.npos) last.remove_prefix(at + mark.size());
  return last.empty() ? "it said nothing" : std::string(last);
}

std::vector<std::string> sbatch(const SlurmJobs& jobs, const std::vector<std::string>& own) {
  std::vector<std::string> words{"sbatch"};
  words.insert(words.end(), jobs.options.begin(), jobs.options.end());
  words.insert(words.end(), {"--ntasks=1", "--cpus-per-task=1", "--no-requeue", "--job-name=" + jobs.name,
                             "--open-mode=append", "--output=" + jobs.messages});
  words.insert(words.end(), own.begin(), own.end());
  return words;
}

}  // namespace

std::string index_ranges(const std::vector<std::size_t>& indices) {
  std::string text;
  for (std::size_t i = 0; i < indices.size();) {
    std::size_t end = i;
    while (end + 1 < indices.size() && indices[end + 1] == indices[end] + 1) ++end;
    text += fmt::format("{}{}", text.empty() ? "" : ",", indices[i]);
    if (end > i) text += fmt::format("-{}", indices[end]);
    i = end + 1;
  }
  return text;
}

void require_slurm(SlurmJobs& jobs) {
  const ProgramOutput config = output_of_program({"scontrol", "show", "config"});
  if (config.code == no_such_program)
    throw core::CaseError(
        "--engine slurm: no Slurm was found here (scontrol), allowed is a machine that has it, or --engine local");
  if (config.code != 0)
    throw core::CaseError(fmt::format("--engine slurm: Slurm does not answer: {}", sentence(config.text)));
  core::Lines lines(config.text);
  for (std::string_view line; lines.next(line);)
    if (line.rfind("MaxArraySize", 0) == 0)
      if (const auto size = core::parse_number<std::size_t>(core::trimmed(line.substr(line.find('=') + 1)));
          size && *size > 1)
        jobs.array_size = *size;
  const ProgramOutput tried = output_of_program(sbatch(jobs, {"--test-only", "--wrap=true"}));
  if (tried.code != 0) throw core::CaseError(fmt::format("--engine slurm: Slurm refuses: {}", sentence(tried.text)));
}

std::optional<std::set<std::size_t>> rows_in_queue(const SlurmJobs& jobs) {
  const ProgramOutput queue =
      output_of_program({"squeue", "--noheader", "--array", "--name=" + jobs.name, "--format=%k|%K"});
  if (queue.code != 0) return std::nullopt;
  std::set<std::size_t> rows;
  core::Lines lines(queue.text);
  for (std::string_view line; lines.next(line);) {
    const auto bar = std::min(line.find('|'), line.size() - 1);
    const auto first = core::parse_number<std::size_t>(line.substr(0, bar)),
               index = core::parse_number<std::size_t>(core::trimmed(line.substr(bar + 1)));
    if (first && index) rows.insert(*first + *index);
  }
  return rows;
}

std::string submit(const SlurmJobs& jobs, std::vector<std::size_t>& rows) {
  while (!rows.empty()) {
    const std::size_t first = rows.front() / jobs.array_size * jobs.array_size;
    std::vector<std::size_t> indices;
    for (const std::size_t row : rows)
      if (row < first + jobs.array_size) indices.push_back(row - first);
    const std::string at_once = jobs.at_once > 0 ? fmt::format("%{}", jobs.at_once) : "";
    const ProgramOutput done =
        output_of_program(sbatch(jobs, {fmt::format("--array={}{}", index_ranges(indices), at_once),
                                        fmt::format("--comment={}", first), jobs.script, fmt::format("{}", first)}));
    if (done.code != 0) return sentence(done.text);
    rows.erase(rows.begin(), rows.begin() + static_cast<long>(indices.size()));
  }
  return {};
}

namespace {

namespace fs = std::filesystem;
using forming::SweepPlan;
using forming::SweepState;
using Status = SweepState::Status;

constexpr double shortest_poll = 1.0;   ///< s between two looks at the queue
constexpr double poll_share = 0.1;      ///< of the time that may go into looking
constexpr double files_are_late = 5.0;  ///< s that another machine's files may take to be seen here
constexpr int most_attempts = 5;        ///< with a task, in one call

/// What Slurm has in hand.
struct Tasks {
  Progress progress;
  const SlurmJobs& jobs;
  std::set<std::size_t> in_hand = {};        ///< rows with a task
  std::map<std::size_t, double> gone = {};   ///< rows whose task has left the queue without a result, since when
  std::map<std::size_t, int> attempts = {};  ///< tasks that were handed in for a row
  std::string refusal = {};                  ///< what Slurm said last
};

std::string in_quotes(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string absolute(const std::string& path) {
  return fs::absolute(path).lexically_normal().string();
}

void write_script(const SweepPlan& plan, const SlurmJobs& jobs) {
  core::note_growing(jobs.messages);
  for (std::size_t row = 0; row < plan.runs.size(); ++row)  // by the tasks, on whichever machines
    for (const std::string& path : {log_path(plan, row), plan.folder(plan.runs[row]) + ".lock"})
      core::note_growing(path);
  const std::string output = absolute(plan.output), program = fs::read_symlink("/proc/self/exe").string();
  core::replace_file(jobs.script, fmt::format(R"(#!/bin/sh
# A task of `parison sweep --engine slurm`: $1 is the row of array index 0, rows counted from 0. Written anew by each call.
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
row=$(($1 + SLURM_ARRAY_TASK_ID + 1))
exec {} sweep {} --output {} --row "$row" >{}/"$(printf 'run_%04d' "$row").log" 2>&1
)",
                                              in_quotes(program), in_quotes(absolute(plan.sweep.file)),
                                              in_quotes(output), in_quotes(output)));
}

void say(const std::string& sentence) {
  fmt::print("{}\n", sentence);
  std::fflush(stdout);
}

/// A run whose task has left the queue: it has ended, or the task was lost and is handed in again.
void settle(Tasks& tasks, std::size_t row) {
  Progress& progress = tasks.progress;
  const SweepState state = forming::state_of(progress.plan, progress.plan.runs[row]);
  const double now = core::wall_seconds();
  if (state.status == Status::waiting && now - tasks.gone.emplace(row, now).first->second < files_are_late) return;
  tasks.gone.erase(row);
  tasks.in_hand.erase(row);
  const std::string words = last_words(log_path(progress.plan, row));
  if (state.status != Status::waiting) {
    end_run(progress, row, state);
  } else if (tasks.attempts[row] < most_attempts) {
    say(fmt::format("{}: its task was lost{}; it is handed in again", progress.plan.runs[row].name,
                    words.empty() ? "" : " (" + words + ")"));
    progress.ready.push_back(row);
  } else {
    end_run(progress, row,
            {Status::failed, fmt::format("its task was lost {} times{}", most_attempts,
                                         words.empty() ? ", see slurm_messages.txt" : ": " + words)});
  }
}

/// Hands in what is ready and not in the queue already. Where Slurm takes no more, as beyond a limit of jobs, the rest
/// waits for what it has.
void hand_in(Tasks& tasks, const std::set<std::size_t>& queued) {
  std::vector<std::size_t> rows;
  for (const std::size_t row : tasks.progress.ready)
    if (queued.count(row))
      tasks.in_hand.insert(row);
    else
      rows.push_back(row);
  tasks.progress.ready.clear();
  std::sort(rows.begin(), rows.end());
  const std::vector<std::size_t> all = rows;
  const std::string refusal = submit(tasks.jobs, rows);
  for (const std::size_t row : all)
    if (!std::binary_search(rows.begin(), rows.end(), row)) {
      tasks.in_hand.insert(row);
      ++tasks.attempts[row];
    }
  tasks.progress.ready.assign(rows.begin(), rows.end());
  if (!refusal.empty() && tasks.in_hand.empty())
    throw core::RunError(fmt::format("Slurm refuses: {}; the same command goes on with the sweep", refusal));
  if (!refusal.empty() && refusal != tasks.refusal) say("Slurm takes no more for now: " + refusal);
  tasks.refusal = refusal;
}

void wait_for(double seconds) {
  constexpr double part = 0.1;
  for (double waited = 0; waited < seconds && !stop_requested(); waited += part)
    usleep(static_cast<useconds_t>(1e6 * part));
}

}  // namespace

SlurmJobs slurm_jobs(const SweepPlan& plan, std::vector<std::string> options, int at_once) {
  const std::string output = absolute(plan.output);
  SlurmJobs jobs;
  jobs.name = "parison_" + core::fingerprint_text(core::fingerprint(output));
  jobs.script = output + "/slurm_task.sh";
  jobs.messages = output + "/slurm_messages.txt";
  jobs.options = std::move(options);
  jobs.at_once = at_once;
  return jobs;
}

bool run_sweep_by_slurm(const SweepPlan& plan, std::vector<SweepState>& states, const SlurmJobs& jobs) {
  write_script(plan, jobs);
  Tasks tasks{open_progress(plan, states, Report::progress), jobs};
  bool opened = false, answered = true;
  while (tasks.progress.ended < plan.runs.size()) {
    const double begin = core::wall_seconds();
    if (const auto queued = rows_in_queue(jobs)) {
      answered = true;
      if (!std::exchange(opened, true) && !queued->empty())
        say(fmt::format("  {} tasks are in the queue of Slurm from before", queued->size()));
      std::vector<std::size_t> left;
      std::set_difference(tasks.in_hand.begin(), tasks.in_hand.end(), queued->begin(), queued->end(),
                          std::back_inserter(left));
      for (const std::size_t row : left) settle(tasks, row);
      if (!tasks.progress.ready.empty()) hand_in(tasks, *queued);
    } else if (std::exchange(answered, false)) {
      say("Slurm does not answer; its tasks go on, and this waits for it");
    }
    if (stop_requested()) {
      say(fmt::format("the tasks go on in Slurm: the same command waits for them again, `scancel --name={}` ends them",
                      jobs.name));
      return false;
    }
    if (tasks.progress.ended < plan.runs.size())
      wait_for(std::max(shortest_poll, (core::wall_seconds() - begin) / poll_share));
  }
  return true;
}

}  // namespace parison::tools
