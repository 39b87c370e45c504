// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "core/case/case_error.hpp"
#include "core/linear/blas_threads.hpp"
#include "forming/report/summary.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/run.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/scene/scene.hpp"
#include "forming/study/coarse_run.hpp"
#include "tools/bundled_cases.hpp"
#include "tools/coarse_run.hpp"
#include "tools/fit_law.hpp"
#include "tools/stop_request.hpp"
#include "tools/tradeoff.hpp"

namespace {

constexpr int run_failed = 1, case_wrong = 2;
constexpr const char* what_a_case_is = "folder that holds a case.toml, a case file, or the name of a bundled case";

using Overrides = std::vector<std::string>;

int check(const std::string& path, const std::string& accuracy, const Overrides& overrides) {
  fmt::print("{}", parison::forming::describe_scene(parison::forming::read_scene(path, accuracy, overrides)));
  return 0;
}

/// Tells what the coarse run of a run that has completed says, and runs it where it has not run.
int report_errors(const parison::forming::Scene& scene, const parison::forming::RunOutcome& outcome,
                  const std::string& output, parison::tools::CoarseRun& coarse_run,
                  parison::forming::Summary& summary) {
  coarse_run.wait();
  const auto bars =
      parison::forming::estimate_errors(scene, summary.quantities, output, parison::tools::stop_requested);
  if (!bars) {
    fmt::print(stderr, "parison: the coarse run has not completed; `parison resume {} --error-bars` continues it\n",
               output);
    return run_failed;
  }
  add_error_bars(output, scene, outcome.state, *bars, summary);
  fmt::print("{}", error_table(scene, *bars));
  return 0;
}

/// Writes the summary of a run and tells how it ended; its coarse run is null where no error bars are wanted.
int report(const parison::forming::Scene& scene, const parison::forming::RunOutcome& outcome, const std::string& output,
           parison::tools::CoarseRun* coarse_run) {
  const auto& facts = outcome.facts;
  if (!facts.completed) fmt::print(stderr, "parison: the run stopped in {}\n", facts.reason);
  auto summary = parison::forming::write_summary(output, scene, outcome.state, facts);
  fmt::print("\n{}", summary_table(scene, outcome.state, summary));
  std::fflush(stdout);
  if (facts.stopped) fmt::print(stderr, "parison: `parison resume {}` continues it\n", output);
  if (!facts.completed) return run_failed;
  return coarse_run ? report_errors(scene, outcome, output, *coarse_run, summary) : 0;
}

int run(const std::string& path, const std::string& accuracy, const Overrides& overrides, std::string output,
        bool error_bars) {
  using namespace parison::forming;
  const Scene scene = read_scene(path, accuracy, overrides);
  if (output.empty()) output = "results/" + scene.name;
  fmt::print("{}\n", describe_scene(scene));
  std::fflush(stdout);
  parison::tools::catch_signals();
  parison::tools::CoarseRun coarse_run(scene, output);
  const auto stop = [&] {  // asked after each step, when the folder is there
    if (error_bars) coarse_run.start();
    return parison::tools::stop_requested();
  };
  return report(scene, parison::forming::run(scene, output, stop), output, error_bars ? &coarse_run : nullptr);
}

int resume(const std::string& output, const std::string& path, bool error_bars) {
  using namespace parison::forming;
  const CaseOrigin origin = read_origin(find_checkpoint(output));
  if (path.empty() && !std::filesystem::exists(origin.file))
    throw parison::core::CaseError(
        fmt::format("{}: its case \"{}\" is no longer there, allowed is --case with the place it has moved to", output,
                    origin.file));
  const Scene scene = read_scene(path.empty() ? origin.file : path, origin.accuracy, origin.overrides);
  fmt::print("{} at {} accuracy, from the last checkpoint in {}\n", scene.name, scene.accuracy_name, output);
  std::fflush(stdout);
  parison::tools::catch_signals();
  parison::tools::CoarseRun coarse_run(scene, output);
  return report(scene, parison::forming::resume(scene, output, parison::tools::stop_requested), output,
                error_bars ? &coarse_run : nullptr);
}

int list_cases() {
  fmt::print("{}", parison::tools::bundled_cases_table());
  return 0;
}

CLI::App* add_tradeoff(CLI::App& app, parison::tools::TradeoffRequest& trade) {
  auto* command =
      app.add_subcommand("tradeoff", "run a convergence study of settings and model parts: error against CPU time");
  command->add_option("case", trade.case_path, what_a_case_is)->required()->transform(parison::tools::find_case);
  command->add_option("--output", trade.output,
                      "folder of the study; what has run there is not run again [results/tradeoff_NAME]");
  command->add_option(
      "--reference", trade.reference,
      "accuracy that the others are held against [fine; \"fine coarser 0.5\" where the case maps its mesh]");
  command->add_option("--base", trade.base, "accuracy at which one thing at a time is changed")->capture_default_str();
  command->add_option("--study", trade.study, "TOML file of [[variant]] tables in place of the standard study");
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
  return command;
}

CLI::App* add_fit_law(CLI::App& app, parison::tools::FitLawRequest& fit) {
  auto* command = app.add_subcommand("fit-law", "fit the pressure-viscosity law to measurements");
  command->add_option("data", fit.data, "CSV file: p and h, or q, T_glass and T_tool; eta or T_glass")->required();
  command->add_option("--fix", fit.fixed, "NAME=VALUE: do not fit this constant [p_ref=\"0.2 MPa\"]")
      ->take_all()
      ->allow_extra_args(false);
  command->add_option("--case", fit.case_path, "case whose glass gives the viscosity at T_glass")
      ->transform(parison::tools::find_case);
  command->add_flag("--relative", fit.relative, "weigh residuals as shares: for scatter that grows with the value");
  return command;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Parison: forming of glass containers, from the gob to the take-out.");
  app.require_subcommand(1);
  app.set_version_flag("--version", PARISON_VERSION);
  std::string path, accuracy = "standard", output;
  Overrides overrides;
  bool error_bars = false;
  const auto with_case = [&](const char* name, const char* what) {
    auto* command = app.add_subcommand(name, what);
    command->add_option("case", path, what_a_case_is)->required()->transform(parison::tools::find_case);
    command->add_option("--accuracy", accuracy, "draft, standard, fine, or an error such as 0.5%")
        ->capture_default_str();
    command->add_option("--set", overrides, "KEY=VALUE in place of the case file's value; may be repeated")
        ->take_all()
        ->allow_extra_args(false);
    return command;
  };
  auto* run_command = with_case("run", "run a case");
  run_command->add_option("--output", output, "new folder for the results [results/NAME]");
  run_command->add_flag("--error-bars", error_bars, "estimate the error of each result by a coarse run");
  auto* resume_command = app.add_subcommand("resume", "continue a run from its last checkpoint");
  resume_command->add_option("results", output, "folder with the results of the run")->required();
  resume_command->add_option("--case", path, "the case, where it has moved")->transform(parison::tools::find_case);
  resume_command->add_flag("--error-bars", error_bars, "as for run; on a run that has completed too");
  auto* check_command = with_case("check", "read a case and say what it needs");
  parison::tools::TradeoffRequest trade;
  auto* trade_command = add_tradeoff(app, trade);
  parison::tools::FitLawRequest fit;
  auto* fit_command = add_fit_law(app, fit);
  auto* cases_command = app.add_subcommand("cases", "list the bundled cases");
  parison::core::use_one_blas_thread();
  try {
    app.parse(argc, argv);
    if (cases_command->parsed()) return list_cases();
    if (fit_command->parsed()) return parison::tools::fit_law(fit);
    if (trade_command->parsed()) return parison::tools::tradeoff(trade);
    if (resume_command->parsed()) return resume(output, path, error_bars);
    return check_command->parsed() ? check(path, accuracy, overrides)
                                   : run(path, accuracy, overrides, output, error_bars);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : case_wrong;
  } catch (const parison::core::CaseError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return case_wrong;
  } catch (const std::exception& error) {
    fmt::print(stderr, "parison: {}\n", error.what());
    return run_failed;
  }
}
