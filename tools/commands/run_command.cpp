// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/run_command.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <filesystem>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "forming/report/summary.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/scene/scene.hpp"
#include "forming/study/coarse_run.hpp"
#include "tools/commands/coarse_run.hpp"
#include "tools/commands/console.hpp"
#include "tools/commands/controlled_run.hpp"
#include "tools/commands/section_picture.hpp"
#include "tools/program/exit_codes.hpp"
#include "tools/program/stop_request.hpp"

namespace parison::tools {
namespace {

using forming::RunOutcome;
using forming::Scene;

/// Prints the error bars of a run that has completed, after running its coarse run where that has not run yet.
int report_errors(const Scene& scene, const RunOutcome& outcome, const std::string& output, CoarseRun& beside,
                  forming::Summary& summary) {
  beside.wait();
  const forming::CoarseCase coarse = forming::coarse_case(scene, output);
  if (!forming::has_completed(coarse)) {
    fmt::print("\nthe coarse run for the error bars, in {}\n", coarse.directory);
    std::fflush(stdout);
    Console console;
    if (!forming::complete(coarse, {&console}, stop_requested)) {
      fmt::print(stderr, "parison: the coarse run has not completed; `parison resume {} --error-bars` continues it\n",
                 output);
      return run_failed;
    }
  }
  const forming::ErrorBars bars = forming::estimate_errors(scene, summary.quantities, coarse);
  add_error_bars(output, scene, outcome.state, bars, summary);
  fmt::print("{}", error_table(bars));
  return 0;
}

/// Writes the summary of a run and prints how it ended; its coarse run is null where no error bars are wanted.
int report(const Scene& scene, const RunOutcome& outcome, const std::string& output, CoarseRun* coarse_run) {
  const auto& facts = outcome.facts;
  if (!facts.completed) fmt::print(stderr, "parison: the run stopped in {}\n", facts.reason);
  auto summary = forming::write_summary(output, scene, outcome.state, facts);
  fmt::print("\n{}", summary_table(scene, outcome.state, summary));
  std::fflush(stdout);
  if (facts.stopped) fmt::print(stderr, "parison: `parison resume {}` continues it\n", output);
  if (!facts.completed) return run_failed;
  return coarse_run ? report_errors(scene, outcome, output, *coarse_run, summary) : 0;
}

}  // namespace

int check(const RunRequest& request) {
  const Scene scene = forming::read_scene(request.case_path, request.accuracy, request.overrides);
  if (!request.picture.empty()) {
    if (std::filesystem::path(request.picture).extension() != ".svg")
      throw core::CaseError(fmt::format("--picture: \"{}\" was found, allowed is a file named .svg", request.picture));
    core::replace_file(request.picture, section_picture(scene));
  }
  fmt::print("{}", forming::describe_scene(scene));
  return 0;
}

int run(const RunRequest& request) {
  if (const auto target = forming::read_accuracy(request.accuracy).target) return run_to_accuracy(request, *target);
  const Scene scene = forming::read_scene(request.case_path, request.accuracy, request.overrides);
  const std::string output = request.output.empty() ? "results/" + scene.name : request.output;
  fmt::print("{}\n", forming::describe_scene(scene));
  std::fflush(stdout);
  catch_signals();
  Console console;
  CoarseRun coarse_run(scene, output);
  forming::Observers observers{&console};
  if (request.error_bars) observers.push_back(&coarse_run);
  const RunOutcome outcome = forming::run_in_folder(scene, output, observers, stop_requested);
  return report(scene, outcome, output, request.error_bars ? &coarse_run : nullptr);
}

int resume(const RunRequest& request) {
  const std::string& output = request.output;
  const forming::CaseOrigin origin = forming::read_origin(forming::find_checkpoint(output));
  if (request.case_path.empty() && !std::filesystem::exists(origin.file))
    throw core::CaseError(
        fmt::format("{}: its case \"{}\" no longer exists, give its new location with --case", output, origin.file));
  const Scene scene = forming::read_scene(request.case_path.empty() ? origin.file : request.case_path, origin.accuracy,
                                          origin.overrides);
  if (const std::string damage = forming::damage_of_last_checkpoint(output); !damage.empty())
    fmt::print("{}; the run is taken up from the checkpoint before it\n", damage);
  fmt::print("{} at {} accuracy, from the last checkpoint in {}\n", scene.name, scene.accuracy_name, output);
  std::fflush(stdout);
  catch_signals();
  Console console;
  CoarseRun coarse_run(scene, output);
  const RunOutcome outcome = forming::resume_in_folder(scene, output, {&console}, stop_requested);
  return report(scene, outcome, output, request.error_bars ? &coarse_run : nullptr);
}

}  // namespace parison::tools
