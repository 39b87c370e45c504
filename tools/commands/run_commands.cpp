// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>
#include <string>

#include "tools/commands/command_options.hpp"
#include "tools/commands/run/run_command.hpp"
#include "tools/commands/study/cycle.hpp"
#include "tools/new_container/new_case.hpp"

namespace parison::tools {
namespace {

void add_case_options(CLI::App& command, RunRequest& request) {
  command.add_option("case", request.case_path, what_a_case_is)->required()->transform(case_of);
  command.add_option("--accuracy", request.accuracy, "draft, standard, fine, or an error such as 0.5%")
      ->capture_default_str();
  command.add_option("--set", request.overrides, "KEY=VALUE that replaces the value in the case file; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
}

int run_given(const RunRequest& given) {
  RunRequest request = given;
  if (request.to_cold) request.overrides.insert(request.overrides.begin(), "cooling=standard");
  return request.later_counts ? run(request) : with_keys_once<RunRequest, run>(request);
}

void add_run(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<RunRequest>();
  auto* command = add_command(app, "run", "run a case", chosen, request, run_given);
  add_case_options(*command, *request);
  command->add_option("--output", request->output, "new folder for the results [results/NAME]");
  command->add_flag("--keep-going", request->keep_going,
                    "exit code 0 also where a check is far beyond its limit: results not trustworthy");
  command->add_flag("--later-counts", request->later_counts, "of several --set of one value the last one counts")
      ->group("");  // for runs that other commands start
  command->add_flag("--to-cold", request->to_cold,
                    "go on after the last stage: dead plate, conveyor, lehr and cold end, to the cold container");
  command->add_flag("-v,--verbose", request->verbose, "first say all that `parison check` says");
  command->add_flag("--error-bars", request->error_bars, "estimate the error of each result by two coarser runs");
}

void add_resume(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<RunRequest>();
  auto* command = add_command(app, "resume", "continue a run from its last checkpoint", chosen, request, resume);
  command->add_option("results", request->output, "folder with the results of the run")->required();
  command->add_option("--case", request->case_path, "the case, where it has moved or a corrected one is wanted")
      ->transform(case_of);
  command->add_option("--after", request->after, "name of a stage: from its end instead of the last checkpoint");
  command
      ->add_option("--set", request->overrides, "KEY=VALUE as for run, in stages that are still to come or in output")
      ->take_all()
      ->allow_extra_args(false);
  command->add_flag("--keep-going", request->keep_going,
                    "exit code 0 also where a check is far beyond its limit: results not trustworthy");
  command->add_flag("--error-bars", request->error_bars, "as for run; also for a run that has completed");
}

void add_check(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<RunRequest>();
  auto* command = add_command(app, "check", "read a case and say what it needs", chosen, request,
                              with_keys_once<RunRequest, check>);
  add_case_options(*command, *request);
  command->add_option("--picture", request->picture,
                      "SVG file for the section with tools, glass and axis; FILE_timing.svg gets the timing");
}

void add_new(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<NewRequest>();
  auto* command =
      add_command(app, "new", "begin a case like a bundled one, or by its process", chosen, request, new_case);
  command->add_option("folder", request->folder, "new folder; its name is that of the case")->required();
  auto* like = command->add_option("--like", request->like, "name of a bundled case")->capture_default_str();
  auto* process = command
                      ->add_option("--process", request->wish.process,
                                   fmt::format("of {}: a first gob and tools of ordinary proportions "
                                               "for the weight, capacity and height that are given",
                                               processes))
                      ->excludes(like);
  const auto add = [&](const char* name, std::string& text, const char* help, bool needed) {
    auto* option = command->add_option(name, text, help)->needs(process);
    if (needed) process->needs(option);
  };
  add("--weight", request->wish.weight, "of the glass, \"180 g\"", true);
  add("--capacity", request->wish.capacity, "to the rim, \"330 ml\"", true);
  add("--height", request->wish.height, "of the container, \"220 mm\"", true);
  add("--finish", request->wish.finish,
      "outer diameter of the finish, of the rim of pressed ware or the stem of an ampoule [that of the template]",
      false);
}

void add_cycle(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<CycleRequest>();
  auto* command = add_command(app, "cycle", "find the tool temperatures to which production settles, and its container",
                              chosen, request, cycle);
  command->add_option("case", request->case_path, what_a_case_is)->required()->transform(case_of);
  command->add_option("--accuracy", request->accuracy, "of all runs")->capture_default_str();
  command->add_option("--cycle-time", request->cycle_time,
                      "time from one container to the next, \"12 s\" [that of the case's timing]");
  command->add_option("--sets", request->sets, "TOOL=N: of that tool so many sets take turns, each with a longer cycle")
      ->take_all()
      ->allow_extra_args(false);
  command
      ->add_option("--want", request->wanted,
                   "TOOL=TEMPERATURE: mean that the tool's surface is to settle to, \"blank=450 degC\"; the h of its "
                   "cooled boundary is found; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  command
      ->add_option("--tolerance", request->tolerance,
                   "by which no tool surface may differ from the settled one, nor change in a plain cycle")
      ->capture_default_str();
  command->add_option("--max-runs", request->max_runs, "forming runs of the search at most")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  command->add_flag("--error-bars", request->error_bars,
                    "say which differences of the settled container from the first gob's are real, by coarser runs");
  command->add_option("--jobs", request->jobs, "runs of --error-bars at once, one thread each")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  command->add_option("--output", request->output, "new folder for the results [results/cycle_NAME]");
  const auto* variant =
      command
          ->add_option("--variant",
                       "name of a change with settled production of its own; the --set behind it belong to it")
          ->type_name("NAME")
          ->take_all()
          ->allow_extra_args(false);
  const auto* set = command->add_option("--set", "KEY=VALUE; before any --variant for every run")
                        ->take_all()
                        ->allow_extra_args(false);
  command->callback([&chosen, request, command, variant, set] {
    GivenSets given = given_sets(*command, variant, set);
    request->overrides = std::move(given.before);
    request->variants = std::move(given.variants);
    chosen = [request] { return with_keys_once<CycleRequest, cycle>(*request); };
  });
}

}  // namespace

void add_run_commands(CLI::App& app, Command& chosen) {
  add_run(app, chosen);
  add_resume(app, chosen);
  add_check(app, chosen);
  add_new(app, chosen);
  add_cycle(app, chosen);
}

}  // namespace parison::tools
