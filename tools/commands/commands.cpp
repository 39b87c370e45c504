// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/commands.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>

#include "core/case/case_error.hpp"
#include "core/case/case_file.hpp"
#include "tools/camera/camera.hpp"
#include "tools/commands/export_container.hpp"
#include "tools/commands/new_case.hpp"
#include "tools/commands/run/run_command.hpp"
#include "tools/commands/study/audit.hpp"
#include "tools/commands/study/cycle.hpp"
#include "tools/commands/study/fit_law.hpp"
#include "tools/comparison/compare.hpp"
#include "tools/materials/materials.hpp"
#include "tools/program/bundled_cases.hpp"
#include "tools/report/report.hpp"
#include "tools/report/watch.hpp"
#include "tools/search/calibrate.hpp"
#include "tools/search/optimise.hpp"
#include "tools/sweep/sweep.hpp"
#include "tools/tradeoff/tradeoff.hpp"
#include "tools/uncertainty/uncertainty.hpp"

namespace parison::tools {
namespace {

constexpr const char* what_a_case_is = "folder that holds a case.toml, a case file, or the name of a bundled case";

/// Adds a command whose options fill a request, with what is to be done with that.
template <typename Request>
CLI::App* add_command(CLI::App& app, const char* name, const char* what, Command& chosen,
                      const std::shared_ptr<Request>& request, int (*work)(const Request&)) {
  auto* command = app.add_subcommand(name, what);
  command->callback([&chosen, request, work] { chosen = [request, work] { return work(*request); }; });
  return command;
}

void add_case_options(CLI::App& command, RunRequest& request) {
  command.add_option("case", request.case_path, what_a_case_is)->required()->transform(find_case);
  command.add_option("--accuracy", request.accuracy, "draft, standard, fine, or an error such as 0.5%")
      ->capture_default_str();
  command.add_option("--set", request.overrides, "KEY=VALUE that replaces the value in the case file; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
}

void add_run(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<RunRequest>();
  auto* command = add_command(app, "run", "run a case", chosen, request, run);
  add_case_options(*command, *request);
  command->add_option("--output", request->output, "new folder for the results [results/NAME]");
  command->add_flag("--keep-going", request->keep_going,
                    "exit code 0 also where a check is far beyond its limit: results not trustworthy");
  command->add_flag("-v,--verbose", request->verbose, "first say all that `parison check` says");
  command->add_flag("--error-bars", request->error_bars, "estimate the error of each result by two coarser runs");
}

void add_resume(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<RunRequest>();
  auto* command = add_command(app, "resume", "continue a run from its last checkpoint", chosen, request, resume);
  command->add_option("results", request->output, "folder with the results of the run")->required();
  command->add_option("--case", request->case_path, "the case, where it has moved or a corrected one is wanted")
      ->transform(find_case);
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
  auto* command = add_command(app, "check", "read a case and say what it needs", chosen, request, check);
  add_case_options(*command, *request);
  command->add_option("--picture", request->picture,
                      "SVG file for the section with tools, glass and axis; FILE_timing.svg gets the timing");
}

void add_new(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<NewRequest>();
  auto* command = add_command(app, "new", "begin a case like a bundled one", chosen, request, new_case);
  command->add_option("folder", request->folder, "new folder; its name is that of the case")->required();
  command->add_option("--like", request->like, "name of a bundled case")->capture_default_str();
}

void add_audit(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<AuditRequest>();
  auto* command =
      add_command(app, "audit", "run a case coarsely with each part of its model in and out", chosen, request, audit);
  command->add_option("case", request->case_path, what_a_case_is)->required()->transform(find_case);
  command->add_option("--accuracy", request->accuracy, "of all runs; coarse ones take seconds")->capture_default_str();
  command->add_option("--set", request->overrides, "KEY=VALUE for every run")->take_all()->allow_extra_args(false);
}

void add_cycle(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<CycleRequest>();
  auto* command = add_command(app, "cycle", "find the tool temperatures to which production settles, and its container",
                              chosen, request, cycle);
  command->add_option("case", request->case_path, what_a_case_is)->required()->transform(find_case);
  command->add_option("--accuracy", request->accuracy, "of all runs")->capture_default_str();
  command->add_option("--cycle-time", request->cycle_time,
                      "time from one container to the next with the same tools, \"12 s\" [that of the case's timing]");
  command
      ->add_option("--tolerance", request->tolerance,
                   "by which no tool surface may differ from the settled one, nor change in a plain cycle")
      ->capture_default_str();
  command->add_option("--max-runs", request->max_runs, "forming runs of the search at most")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  command->add_option("--output", request->output, "new folder for the results [results/cycle_NAME]");
  command->add_option("--set", request->overrides, "KEY=VALUE for every run")->take_all()->allow_extra_args(false);
}

void add_tradeoff(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<TradeoffRequest>();
  TradeoffRequest& trade = *request;
  auto* command =
      add_command(app, "tradeoff", "run a convergence study of settings and model parts: error against CPU time",
                  chosen, request, tradeoff);
  command->add_option("case", trade.case_path, what_a_case_is)->required()->transform(find_case);
  command->add_option("--output", trade.output,
                      "folder of the study; variants that have run there are not run again [results/tradeoff_NAME]");
  command->add_option("--reference", trade.reference,
                      "accuracy of the reference that the others are compared with [fine; \"fine coarser 0.5\" where "
                      "the case maps its mesh]");
  command->add_option("--base", trade.base, "accuracy at which one setting at a time is changed")
      ->capture_default_str();
  command->add_option("--study", trade.study, "TOML file of [[variant]] tables that replaces the standard study");
  command->add_option("--only", trade.groups, "groups to run: accuracy, mesh, time, coupling, order, model")
      ->delimiter(',');
  command->add_option("--set", trade.overrides, "KEY=VALUE for every variant")->take_all()->allow_extra_args(false);
  command->add_option("--jobs", trade.jobs, "runs at once, one thread each")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  command->add_option("--timings", trade.timings, "runs of a variant below a minute of CPU time; the least time counts")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  command->add_flag("--list", trade.list, "name the variants and run none");
}

void add_compare(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<CompareRequest>();
  auto* command = add_command(app, "compare", "compare finished runs of a case: differences with their error bars",
                              chosen, request, compare);
  command->add_option("base", request->base, "result folder that the others are compared with")->required();
  command->add_option("others", request->others, "result folders of the same case with other settings")->required();
  command->add_option("--quantity", request->quantity, "by which the last table ranks the runs [thickness_min]");
  command->add_option("--output", request->output, "folder for comparison.csv and .json, profiles.csv and .svg");
}

/// The variants in the order of the command line: a --set belongs to the --variant before it, one before all of them is
/// a variant of its own.
std::vector<forming::WhatIfVariant> variants_of(const CLI::App& command, const CLI::Option* variant,
                                                const CLI::Option* set) {
  std::vector<forming::WhatIfVariant> variants;
  std::size_t names = 0, sets = 0;
  for (const CLI::Option* option : command.parse_order()) {
    if (option == variant) variants.push_back({variant->results().at(names++), {}});
    if (option != set) continue;
    const std::string& assignment = set->results().at(sets++);
    if (names == 0)
      variants.push_back(forming::variant_of(assignment));
    else
      variants.back().overrides.push_back(assignment);
  }
  return variants;
}

void add_what_if(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<WhatIfRequest>();
  WhatIfRequest& asked = *request;
  auto* command = app.add_subcommand("what-if", "run a case and changes of it, and say which differences are real");
  command->add_option("case", asked.case_path, what_a_case_is)->required()->transform(find_case);
  const auto* variant = command->add_option("--variant", "name of a variant; the --set behind it belong to it")
                            ->type_name("NAME")
                            ->take_all()
                            ->allow_extra_args(false);
  const auto* set = command->add_option("--set", "what is changed; without --variant each is one of its own")
                        ->type_name("KEY=VALUE")
                        ->take_all()
                        ->allow_extra_args(false);
  command->add_option("--base", asked.overrides, "KEY=VALUE for all runs, the base too")
      ->take_all()
      ->allow_extra_args(false);
  auto* accuracy = command->add_option("--accuracy", asked.accuracy, "of all runs")->capture_default_str();
  command
      ->add_option("--resolve", asked.resolve,
                   "choose the accuracy that lets a difference of this size be seen: 0.02mm of the thinnest wall, or "
                   "QUANTITY=SIZE")
      ->excludes(accuracy);
  command->add_option("--quantity", asked.quantity, "by which the last table ranks the variants [thickness_min]");
  command->add_option("--output", asked.output,
                      "folder of the runs; those already there are used [results/what_if_NAME]");
  command->add_option("--jobs", asked.jobs, "runs at once, one thread each")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  command->callback([&chosen, request, command, variant, set] {
    request->variants = variants_of(*command, variant, set);
    chosen = [request] { return what_if(*request); };
  });
}

void add_engine_options(CLI::App& command, const std::shared_ptr<SweepRequest>& request) {
  command.add_option("--engine", request->engine, "local: the cores of this machine; slurm: tasks of job arrays")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  const auto add = [&](const char* name, const std::string& prefix, const char* help) {
    const auto keep = [request, prefix](const std::vector<std::string>& given) {
      for (const std::string& value : given) request->slurm_options.push_back(prefix + value);
    };
    command.add_option_function<std::vector<std::string>>(name, keep, help)->take_all()->allow_extra_args(false);
  };
  add("--partition", "--partition=", "of Slurm");
  add("--time", "--time=", "that Slurm gives a run, as for sbatch");
  add("--slurm-option", "", "further option of sbatch, such as --slurm-option=--mem=2G; may be repeated");
}

void add_sweep(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<SweepRequest>();
  auto* command = add_command(app, "sweep", "run a case with many values of its keys: table of the results", chosen,
                              request, sweep);
  command->add_option("file", request->file, "TOML file with the case, the design and [[variable]] tables")->required();
  command->add_option("--output", request->output,
                      "folder of the runs; those already there are used [results/sweep_FILE]");
  command
      ->add_option("--jobs", request->jobs,
                   "runs at once, one thread each [as many as there are cores, or as Slurm lets]")
      ->check(CLI::Range(1, 100000));
  command->add_flag("--list", request->list, "read and check all runs, print them and run none");
  add_engine_options(*command, request);
  command
      ->add_option("--row", request->row, "makes this row alone, of a sweep that was begun: what a task of Slurm does")
      ->check(CLI::Range(1, 100000));
}

void add_optimise(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<OptimiseRequest>();
  auto* command = add_command(app, "optimise", "search for the dimensions and settings that a goal wants", chosen,
                              request, optimise);
  command->add_option("file", request->file, "TOML file with the case, [[variable]] tables, [goal] and limits")
      ->required();
  command->add_option("--output", request->output,
                      "folder of the runs; those already there are used [results/optimise_FILE]");
  command->add_option("--jobs", request->jobs, "runs at once, one thread each [as many as there are cores]")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--check", request->check, "read and check the goal and the corners of the bounds, run nothing");
}

void add_calibrate(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<CalibrateRequest>();
  auto* command =
      add_command(app, "calibrate", "fit constants of a case to measured temperatures, strokes, forces and walls",
                  chosen, request, calibrate);
  command->add_option("case", request->case_path, what_a_case_is)->required()->transform(find_case);
  command
      ->add_option("data", request->data,
                   "CSV files: time_s and PROBE_degC, TOOL_position_mm, TOOL_force_N; thickness_mm and arc_mm or z_mm")
      ->required();
  command->add_option("--vary", request->varied, "\"KEY=FROM to TO\": a constant and its bounds; may be repeated")
      ->required()
      ->take_all()
      ->allow_extra_args(false);
  command->add_option("--temperature-noise", request->temperature_noise, "standard deviation of the thermocouples")
      ->capture_default_str();
  command->add_option("--thickness-noise", request->thickness_noise, "standard deviation of the walls")
      ->capture_default_str();
  command->add_option("--position-noise", request->position_noise, "standard deviation of the strokes of tools")
      ->capture_default_str();
  command->add_option("--force-noise", request->force_noise, "standard deviation of the forces on tools")
      ->capture_default_str();
  command->add_option("--accuracy", request->accuracy, "draft, standard or fine")->capture_default_str();
  command->add_option("--set", request->overrides, "KEY=VALUE for every run")->take_all()->allow_extra_args(false);
  command->add_option("--runs", request->runs, "of the fit at most")
      ->capture_default_str()
      ->check(CLI::Range(3, 10000));
  command->add_option("--output", request->output,
                      "folder of the runs; those already there are used [results/calibrate_DATA]");
  command->add_option("--jobs", request->jobs, "runs at once, one thread each [as many as there are cores]")
      ->check(CLI::Range(1, 1024));
}

void add_uncertainty(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<UncertaintyRequest>();
  auto* command =
      add_command(app, "uncertainty", "run a case with values drawn from its tolerances: bars, Sobol indices", chosen,
                  request, uncertainty);
  command->add_option("case", request->case_path, what_a_case_is)->required()->transform(find_case);
  command->add_option("--accuracy", request->accuracy, "draft, standard or fine")->capture_default_str();
  command->add_option("--set", request->overrides, "KEY=VALUE, also with a tolerance; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  command->add_option("--runs", request->runs, "with drawn values [eight a tolerance, 32 at least]")
      ->check(CLI::Range(1, 100000));
  command->add_option("--seed", request->seed, "of the drawn values")->capture_default_str();
  command->add_option("--output", request->output,
                      "folder of the runs; those already there are used [results/uncertainty_NAME]");
  command->add_option("--jobs", request->jobs, "runs at once, one thread each [as many as there are cores]")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--list", request->list, "read and check all runs, print them and run none");
}

void add_fit_law(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<FitLawRequest>();
  auto* command =
      add_command(app, "fit-law", "fit the pressure-viscosity law to measurements", chosen, request, fit_law);
  command->add_option("data", request->data, "CSV file: p and h, or q, T_glass and T_tool; eta or T_glass")->required();
  command->add_option("--fix", request->fixed, "NAME=VALUE: do not fit this constant [p_ref=\"0.2 MPa\"]")
      ->take_all()
      ->allow_extra_args(false);
  command->add_option("--case", request->case_path, "case whose glass gives the viscosity at T_glass")
      ->transform(find_case);
  command->add_flag("--relative", request->relative,
                    "weigh residuals as shares: for scatter that grows with the value");
}

void add_materials(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<MaterialsRequest>();
  auto* command = add_command(app, "materials", "list the bundled materials, or show some", chosen, request, materials);
  command->add_option("name", request->names, "bundled materials to show with values and sources");
  command->add_option("--picture", request->picture, "SVG file for a plot of the viscosities");
}

void add_export(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<ExportRequest>();
  auto* command = add_command(app, "export", "write the container of a result folder for CAD and structural programs",
                              chosen, request, export_container);
  command->add_option("results", request->results, "folder with the results of a run")->required();
  command->add_option("--step", request->step, "STEP file (.step): one solid of revolution, mm");
  command->add_option("--stl", request->stl, "STL file (.stl): its surface as triangles, mm");
  command->add_option("--shell", request->shell,
                      "input file for CalculiX or Abaqus (.inp): the middle of the wall as shells with its thickness");
}

void add_camera(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<CameraRequest>();
  auto* command = add_command(app, "camera", "show the hot container as an infrared camera beside it sees it", chosen,
                              request, camera);
  command->add_option("results", request->results, "folder with the results of a run")->required();
  command->add_option("--band", request->bands, "FROM TO: wavelengths; may be repeated [3 um 5 um, 0.9 um 1.1 um]")
      ->type_size(2)
      ->take_all()
      ->allow_extra_args(false);
  command->add_option("--time", request->time, "of the output, the nearest one [the end]");
  command->add_option("--surroundings", request->surroundings, "temperature behind the glass [ambient of the stage]");
  command->add_option("--pixel", request->pixel, "size of a pixel on the container")->capture_default_str();
  command->add_option("--output", request->output, "name of the files without ending [camera in the folder]");
}

void add_report(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<ReportRequest>();
  auto* command =
      add_command(app, "report", "write one HTML page on the runs of some result folders", chosen, request, report);
  command->add_option("results", request->folders, "folders with the results of runs, shown over each other")
      ->required();
  command->add_option("--output", request->output, "HTML file for the page [report.html in the first folder]");
}

void add_watch(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<WatchRequest>();
  auto* command = add_command(app, "watch", "show that page in a browser on this machine while a run goes on", chosen,
                              request, watch);
  command->add_option("results", request->folder, "folder with the results of a run, also one that is still to come")
      ->required();
  command->add_option("--port", request->port, "port of the page, or the next free one")
      ->capture_default_str()
      ->check(CLI::Range(1024, 65535));
}

void add_cases(CLI::App& app, Command& chosen) {
  app.add_subcommand("cases", "list the bundled cases")->callback([&chosen] {
    chosen = [] {
      fmt::print("{}", bundled_cases_table());
      return 0;
    };
  });
}

}  // namespace

void add_commands(CLI::App& app, Command& chosen) {
  app.require_subcommand(1);
  add_run(app, chosen);
  add_resume(app, chosen);
  add_check(app, chosen);
  add_new(app, chosen);
  add_audit(app, chosen);
  add_cycle(app, chosen);
  add_tradeoff(app, chosen);
  add_compare(app, chosen);
  add_what_if(app, chosen);
  add_sweep(app, chosen);
  add_optimise(app, chosen);
  add_calibrate(app, chosen);
  add_uncertainty(app, chosen);
  add_fit_law(app, chosen);
  add_export(app, chosen);
  add_camera(app, chosen);
  add_report(app, chosen);
  add_watch(app, chosen);
  add_cases(app, chosen);
  add_materials(app, chosen);
}

void check_command(const CLI::App& app, int argc, const char* const* argv) {
  const std::string word = argc > 1 ? argv[1] : "";
  if (word.empty() || word[0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), word) != names.end()) return;
  throw core::CaseError(fmt::format("parison: no command \"{}\" was found{}, allowed are {}", word,
                                    core::did_you_mean(word, names), fmt::join(names, ", ")));
}

}  // namespace parison::tools
