// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "core/case/case_error.hpp"
#include "forming/study/comparison/what_if/finished_base.hpp"
#include "tools/commands/command_options.hpp"
#include "tools/comparison/compare.hpp"
#include "tools/search/calibrate.hpp"
#include "tools/search/optimise.hpp"
#include "tools/sweep/sweep.hpp"
#include "tools/tradeoff/tradeoff.hpp"
#include "tools/uncertainty/uncertainty.hpp"

namespace parison::tools {
namespace {

/// Lets an option that chooses another kind of work stand beside those named alone.
void keep_alone(CLI::App& command, CLI::Option& option, const std::vector<std::string>& beside) {
  const auto is_excluded = [&](const CLI::Option* other) {
    return other != &option && other != command.get_help_ptr() &&
           std::none_of(beside.begin(), beside.end(), [&](const std::string& name) { return other->check_name(name); });
  };
  for (CLI::Option* other : command.get_options(is_excluded)) option.excludes(other);
}

int trade_given(const TradeoffRequest& given) {
  TradeoffRequest request = given;
  if (request.base.empty()) request.base = request.parts ? "draft coarser 2" : "draft";
  require_keys_once(request.case_path, {}, request.overrides);
  return request.parts ? model_parts(request) : tradeoff(request);
}

int calibrate_given(const CalibrateRequest& request) {
  if (!request.law.empty()) return calibrate_law(request);
  for (const auto& [name, is_missing] : {std::pair{"case", request.case_path.empty()},
                                         {"data", request.data.empty()},
                                         {"--vary", request.varied.empty()}})
    if (is_missing) throw CLI::RequiredError(name);
  require_keys_once(request.case_path, {}, request.overrides);
  return calibrate(request);
}

void add_tradeoff(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<TradeoffRequest>();
  TradeoffRequest& trade = *request;
  auto* command =
      add_command(app, "tradeoff", "run a convergence study of settings and model parts: error against CPU time",
                  chosen, request, trade_given);
  command->add_option("case", trade.case_path, what_a_case_is)->required()->transform(case_of);
  command->add_option("--output", trade.output,
                      "folder of the study; variants that have run there are not run again [results/tradeoff_NAME]");
  command->add_option("--reference", trade.reference,
                      "accuracy of the reference that the others are compared with [fine; \"fine coarser 0.5\" where "
                      "the case maps its mesh]");
  command->add_option("--base", trade.base,
                      "accuracy at which one setting at a time is changed [draft; with --parts draft coarser 2]");
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
  auto* parts = command->add_flag("--parts", trade.parts,
                                  "in seconds, and without files: what each part of the model changes, and the noise");
  keep_alone(*command, *parts, {"case", "--base", "--set"});
}

void add_compare(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<CompareRequest>();
  auto* command = add_command(app, "compare", "compare finished runs of a case: differences with their error bars",
                              chosen, request, compare);
  command
      ->add_option("base", request->base,
                   "result folder that the others are compared with; or the folder of a what-if or a cycle alone")
      ->required();
  command->add_option("others", request->others, "result folders of the same case with other settings");
  command->add_option("--quantity", request->quantity, "by which the last table ranks the runs [thickness_min]");
  command->add_option("--output", request->output, "folder for comparison.csv and .json, profiles.csv and .svg");
}

void add_what_if(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<WhatIfRequest>();
  WhatIfRequest& asked = *request;
  auto* command = app.add_subcommand("what-if", "run a case and changes of it, and say which differences are real");
  command
      ->add_option("case", asked.case_path,
                   std::string(what_a_case_is) + "; or the result folder of a finished run, which then is the base")
      ->required()
      ->transform([](const std::string& given) { return forming::is_result_folder(given) ? given : case_of(given); });
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
  auto* accuracy =
      command->add_option("--accuracy", asked.accuracy, "of all runs [standard, or that of the finished run]");
  command
      ->add_option("--resolve", asked.resolve,
                   "choose the accuracy that lets a difference of this size be seen: 0.02mm of the thinnest wall, or "
                   "QUANTITY=SIZE")
      ->excludes(accuracy);
  command->add_option("--quantity", asked.quantity, "by which the last table ranks the variants [thickness_min]");
  command->add_option("--output", asked.output,
                      "folder of the runs; those already there are used [results/what_if_NAME]");
  command->add_flag("--twice", asked.twice,
                    "compare means of two runs of base and variant, which scatter less; costs some two thirds more");
  command->add_option("--jobs", asked.jobs, "runs at once, one thread each")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  command->callback([&chosen, request, command, variant, set] {
    GivenSets given = given_sets(*command, variant, set);
    request->variants.clear();
    for (const std::string& assignment : given.before) request->variants.push_back(forming::variant_of(assignment));
    for (auto& one : given.variants) request->variants.push_back(std::move(one));
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
  auto* command = add_command(app, "calibrate", "fit constants of a case, or a contact law alone, to measurements",
                              chosen, request, calibrate_given);
  command->add_option("case", request->case_path, what_a_case_is)->transform(case_of);
  command->add_option(
      "data", request->data,
      "CSV files: time_s and PROBE_degC, TOOL_position_mm, TOOL_force_N; thickness_mm and arc_mm or z_mm");
  command->add_option("--vary", request->varied, "\"KEY=FROM to TO\": a constant and its bounds; may be repeated")
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
  auto* law = command->add_option("--law", request->law,
                                  "CSV file: p and h, or q, T_glass and T_tool; eta, or T_glass with the glass of the "
                                  "case: fit the pressure-viscosity law to it alone");
  keep_alone(*command, *law, {"case"});
  command->add_option("--fix", request->fixed, "NAME=VALUE: a constant of the law not to fit [p_ref=\"0.2 MPa\"]")
      ->needs(law)
      ->take_all()
      ->allow_extra_args(false);
  command
      ->add_flag("--relative", request->relative,
                 "weigh residuals of the law as shares: for scatter that grows with the value")
      ->needs(law);
}

void add_uncertainty(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<UncertaintyRequest>();
  auto* command =
      add_command(app, "uncertainty", "run a case with values drawn from its tolerances: bars, Sobol indices", chosen,
                  request, with_keys_once<UncertaintyRequest, uncertainty>);
  command->add_option("case", request->case_path, what_a_case_is)->required()->transform(case_of);
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

}  // namespace

void add_study_commands(CLI::App& app, Command& chosen) {
  add_tradeoff(app, chosen);
  add_compare(app, chosen);
  add_what_if(app, chosen);
  add_sweep(app, chosen);
  add_optimise(app, chosen);
  add_calibrate(app, chosen);
  add_uncertainty(app, chosen);
}

}  // namespace parison::tools
