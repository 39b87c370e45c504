// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/run/controlled_run.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <thread>
#include <utility>

#include "core/io/written_files.hpp"
#include "forming/report/error_bars.hpp"
#include "forming/report/summary.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/study/accuracy_control.hpp"
#include "tools/commands/run/console.hpp"
#include "tools/program/child_process.hpp"
#include "tools/program/exit_codes.hpp"
#include "tools/program/stop_request.hpp"

namespace parison::tools {

CoarseRuns::CoarseRuns(std::vector<forming::CoarseCase> cases) : cases_(std::move(cases)) {}

CoarseRuns::~CoarseRuns() {
  if (has_ended()) return;
  request_stop(child_);
  while (!has_ended()) usleep(poll_microseconds);
}

void CoarseRuns::start_next() {
  const forming::CoarseCase& next = cases_[started_++];
  std::vector<std::string> arguments = {"run",      next.file,      "--accuracy",    next.accuracy,
                                        "--output", next.directory, "--later-counts"};
  for (const std::string& assignment : next.overrides) arguments.insert(arguments.end(), {"--set", assignment});
  child_ = start_self(arguments, next.directory + ".log");
}

void CoarseRuns::step_taken(const forming::RunView&, const forming::State&, const forming::StepReport&) {
  if (started_ < cases_.size() && std::thread::hardware_concurrency() > 1 && has_ended()) start_next();
}

void CoarseRuns::wait() {
  if (started_ == 0) return;
  bool told = false, requested = false;
  for (;;) {
    if (has_ended()) {
      if (started_ == cases_.size() || stop_requested()) return;
      start_next();
    }
    if (!std::exchange(told, true)) {
      fmt::print("\nwaiting for the coarser runs of the error bars, {}.log\n", cases_[started_ - 1].directory);
      std::fflush(stdout);
    }
    if (stop_requested() && !std::exchange(requested, true)) request_stop(child_);
    usleep(poll_microseconds);
  }
}

bool CoarseRuns::has_ended() {
  if (child_ != 0 && tools::has_ended(child_)) child_ = 0;
  return child_ == 0;
}

namespace {

using forming::AccuracyControl;
using forming::RunOutcome;
using forming::Scene;

struct Attempt {
  Scene scene;
  RunOutcome outcome;
  forming::Summary summary;
};

Attempt attempt(const RunRequest& request, const AccuracyControl& control, const std::string& output) {
  Scene scene = forming::read_scene(request.case_path, control.accuracy(), request.overrides);
  Console console;
  RunOutcome outcome = forming::run_in_folder(scene, output, {&console}, stop_requested);
  auto summary = forming::write_summary(output, scene, outcome);
  return {std::move(scene), std::move(outcome), std::move(summary)};
}

std::string heading(const AccuracyControl& control) {
  const auto& runs = control.record().runs;
  std::string text = fmt::format("\nrun {} for {:.3g} %, at accuracy \"{}\"", runs.size() + 1,
                                 100 * control.record().target, control.accuracy());
  if (!runs.empty() && std::isfinite(runs.back().estimate))
    text += fmt::format(": the error of the last one is estimated at {:.2g} %", 100 * runs.back().estimate);
  return text + "\n";
}

int report(const Attempt& last, const AccuracyControl& control, const RunRequest& request, const std::string& output) {
  forming::Summary summary = last.summary;
  fmt::print("\n{}", summary_table(last.scene, last.outcome.state, summary));
  if (!last.outcome.facts.completed) {
    fmt::print("{}", verdict_line(summary));
    fmt::print(stderr, "parison: the run stopped in {}\n", last.outcome.facts.reason);
    return run_failed;
  }
  forming::ErrorBars bars = forming::error_bars(summary.quantities, control.coarser());
  bars.control = control.record();
  add_error_bars(output, last.scene, last.outcome.state, bars, summary);
  fmt::print("{}{}", error_table(bars), verdict_line(summary));
  return bars.control->reached() ? code_of(last.outcome.facts, request.keep_going) : run_failed;
}

}  // namespace

int run_to_accuracy(RunRequest request, double target) {
  const Scene first = forming::read_scene(request.case_path, request.accuracy, request.overrides);
  // The runs go by presets made coarser or finer: the model of radiation stays that of the error asked for.
  if (const auto& choice = first.radiation_choice)
    request.overrides.push_back(
        fmt::format("material.{}.radiation.within={:.12g} %", choice->material, 100 * choice->within));
  const std::string output = request.output.empty() ? "results/" + first.name : request.output;
  fmt::print("{}", opening(request, first));
  catch_signals();
  AccuracyControl control(target);
  for (;;) {
    fmt::print("{}", heading(control));
    std::fflush(stdout);
    const Attempt now = attempt(request, control, output);
    const bool completed = now.outcome.facts.completed;
    if (now.outcome.facts.stopped) return report(now, control, request, output);
    control.add(completed ? std::optional(now.summary.quantities) : std::nullopt, now.outcome.facts.cpu_seconds,
                now.outcome.facts.checks);
    if (control.finished()) return report(now, control, request, output);
    core::remove_own(output);  // made by this command; a finer run takes its place
  }
}

}  // namespace parison::tools
