// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/run/run_command.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/written_files.hpp"
#include "forming/report/files/case_copy.hpp"
#include "forming/report/files/solid_files.hpp"
#include "forming/report/summary.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/run/stage.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/scene/describe/unusual.hpp"
#include "forming/scene/scene.hpp"
#include "forming/study/coarse_run.hpp"
#include "tools/commands/command_options.hpp"
#include "tools/commands/run/console.hpp"
#include "tools/commands/run/controlled_run.hpp"
#include "tools/pictures/pictures.hpp"
#include "tools/program/exit_codes.hpp"
#include "tools/program/stop_request.hpp"

namespace parison::tools {
namespace {

using forming::RunOutcome;
using forming::Scene;

/// Ends the coarser runs of the error bars that have not ended yet; false where one was stopped.
bool finish_coarser_runs(const std::vector<forming::CoarseCase>& cases) {
  for (const forming::CoarseCase& coarse : cases) {
    if (forming::has_ended(coarse)) continue;
    fmt::print("\na coarser run for the error bars, in {}\n", coarse.directory);
    std::fflush(stdout);
    Console console;
    if (!forming::finish(coarse, {&console}, stop_requested)) return false;
  }
  return true;
}

/// Prints the error bars of a run that has completed, or why it has none, after running its coarser runs where they
/// have not run yet; false where one of those was stopped on request.
bool report_errors(const Scene& scene, const RunOutcome& outcome, const std::string& output, CoarseRuns& beside,
                   forming::Summary& summary) {
  beside.wait();
  if (beside.cases().empty()) {
    fmt::print(stderr,
               "parison: no error bars: at {} accuracy a run {:g} times coarser would be coarser than \"draft coarser "
               "{:g}\", the coarsest allowed; a finer --accuracy has them\n",
               scene.accuracy_name, forming::coarser_factors.front(), forming::max_coarsening);
    return true;
  }
  if (!finish_coarser_runs(beside.cases())) {
    fmt::print(stderr, "parison: a coarser run has not ended; `parison resume {} --error-bars` continues it\n", output);
    return false;
  }
  const forming::ErrorBars bars = forming::estimate_errors(summary.quantities, beside.cases());
  const std::vector<std::string> failed = forming::failed_coarse_runs(beside.cases());
  if (bars.coarser.empty()) {
    fmt::print(stderr,
               "parison: no error bars: all coarser runs of {} stopped before their end: {}; a finer --accuracy, whose "
               "coarser runs are finer too, may have them\n",
               scene.name, fmt::join(failed, "; "));
    return true;
  }
  for (const std::string& reason : failed)
    fmt::print("  the error bars rest on one coarser run alone, {:g} times as wide for that: {}\n",
               forming::single_run_factor, reason);
  add_error_bars(output, scene, outcome.state, bars, summary);
  fmt::print("{}", error_table(bars));
  return true;
}

/// Writes the summary of a run and prints how it ended; its coarser runs are null where no error bars are wanted.
int report(const Scene& scene, const RunOutcome& outcome, const RunRequest& request, const std::string& output,
           CoarseRuns* coarser) {
  const auto& facts = outcome.facts;
  if (!facts.completed) fmt::print(stderr, "parison: the run stopped in {}\n", facts.reason);
  auto summary = forming::write_summary(output, scene, outcome);
  fmt::print("\n{}", summary_table(scene, outcome.state, summary));
  if (outcome.solid) fmt::print("{}", forming::solid_table(scene, *outcome.solid, forming::solid_wall(*outcome.solid)));
  if (facts.completed && !coarser)
    fmt::print("  {:<22}not estimated; --error-bars runs the case twice more, coarser, for about half its CPU time\n",
               "errors");
  const bool stopped = facts.completed && coarser && !report_errors(scene, outcome, output, *coarser, summary);
  fmt::print("{}", verdict_line(summary));
  std::fflush(stdout);
  if (!facts.completed && !facts.stopped && coarser)
    fmt::print(stderr, "parison: no error bars: only a run that has completed can have them\n");
  if (facts.stopped || facts.interrupted) fmt::print(stderr, "parison: `parison resume {}` continues it\n", output);
  return facts.completed && !stopped ? code_of(facts, request.keep_going) : run_failed;
}

}  // namespace

std::string opening(const RunRequest& request, const Scene& scene) {
  return request.verbose ? forming::describe_scene(scene)
                         : forming::describe_scene_briefly(scene) + forming::describe_unusual(scene);
}

int code_of(const forming::RunFacts& facts, bool keep_going) {
  return forming::trustworthy(facts.checks) || keep_going ? 0 : not_trustworthy;
}

int check(const RunRequest& request) {
  const Scene scene = forming::read_scene(request.case_path, request.accuracy, request.overrides);
  if (!request.picture.empty()) {
    if (std::filesystem::path(request.picture).extension() != ".svg")
      throw core::CaseError(fmt::format("--picture: \"{}\" was found, allowed is a file named .svg", request.picture));
    const std::string timing = request.picture.substr(0, request.picture.size() - 4) + "_timing.svg";
    for (const std::string& path : {request.picture, timing}) core::require_own(path);
    core::replace_file(request.picture, section_picture(scene));
    core::replace_file(timing, timing_picture(scene));
  }
  fmt::print("{}", forming::describe_scene(scene));
  std::fflush(stdout);
  const std::string reason = forming::first_stage_failure(scene);
  if (reason.empty()) return 0;
  fmt::print(stderr, "{}: stage {} cannot begin: {}\n", request.case_path, scene.stages.front().name, reason);
  return case_wrong;
}

int run(const RunRequest& request) {
  if (const auto target = forming::read_accuracy(request.accuracy).target) return run_to_accuracy(request, *target);
  const Scene scene = forming::read_scene(request.case_path, request.accuracy, request.overrides);
  const std::string output = request.output.empty() ? "results/" + scene.name : request.output;
  fmt::print("{}\n", opening(request, scene));
  std::fflush(stdout);
  catch_signals();
  Console console;
  CoarseRuns coarser(forming::coarse_cases(scene, output));
  forming::Observers observers{&console};
  if (request.error_bars) observers.push_back(&coarser);
  const RunOutcome outcome = forming::run_in_folder(scene, output, observers, stop_requested);
  return report(scene, outcome, request, output, request.error_bars ? &coarser : nullptr);
}

namespace {

/// The case that a run is taken up with where none is given: the one it was made of, or the copy in its folder where
/// that one starts from results that are gone, which the copy keeps.
std::string case_to_resume(const std::string& output, const forming::CaseOrigin& origin) {
  try {
    forming::read_scene(origin.file, origin.accuracy, origin.overrides);
  } catch (const core::CaseError&) {
    const std::string copy = forming::case_copy_folder(output), text = copy + "/case.toml";
    if (!std::filesystem::exists(text) || core::read_text(text) != core::read_text(origin.file)) throw;
    if (forming::read_scene(copy, origin.accuracy, origin.overrides).fingerprint == origin.fingerprint) return copy;
    throw;
  }
  return origin.file;
}

}  // namespace

int resume(const RunRequest& request) {
  const std::string& output = request.output;
  const std::string checkpoint =
      request.after.empty() ? forming::find_checkpoint(output) : forming::find_stage_end(output, request.after);
  forming::CaseOrigin origin = forming::read_origin(checkpoint);
  if (request.case_path.empty() && !std::filesystem::exists(origin.file))
    throw core::CaseError(
        fmt::format("{}: its case \"{}\" no longer exists, give its new location with --case", output, origin.file));
  const std::string case_path = request.case_path.empty() ? case_to_resume(output, origin) : request.case_path;
  require_keys_once(case_path, origin.overrides, request.overrides);
  origin.overrides.insert(origin.overrides.end(), request.overrides.begin(), request.overrides.end());
  const Scene scene = forming::read_scene(case_path, origin.accuracy, origin.overrides);
  forming::require_unchanged_copy(output, scene);
  forming::require_own_checkpoints(output);
  forming::read_checkpoint(checkpoint, scene);  // refuses a changed case before anything is given up
  if (!request.after.empty()) forming::return_to_stage_end(output, request.after);
  if (const std::string damage = forming::damage_of_last_checkpoint(output); !damage.empty())
    fmt::print("{}; the run is taken up from the checkpoint before it, and the damaged one is kept as .damaged\n",
               damage);
  fmt::print("{} at {} accuracy, from {} in {}\n", scene.name, scene.accuracy_name,
             request.after.empty() ? "the last checkpoint" : "the end of stage " + request.after, output);
  std::fflush(stdout);
  catch_signals();
  Console console;
  CoarseRuns coarser(forming::coarse_cases(scene, output));
  const RunOutcome outcome = forming::resume_in_folder(scene, output, {&console}, stop_requested);
  return report(scene, outcome, request, output, request.error_bars ? &coarser : nullptr);
}

}  // namespace parison::tools
