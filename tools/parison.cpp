// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <signal.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "core/blas_threads.hpp"
#include "core/case_error.hpp"
#include "forming/checkpoint.hpp"
#include "forming/checkup.hpp"
#include "forming/run.hpp"
#include "forming/scene.hpp"
#include "forming/summary.hpp"
#include "tools/fit_law.hpp"

namespace {

constexpr int run_failed = 1, case_wrong = 2;

using Overrides = std::vector<std::string>;

int check(const std::string& path, const std::string& accuracy, const Overrides& overrides) {
  fmt::print("{}", parison::forming::describe_scene(parison::forming::read_scene(path, accuracy, overrides)));
  return 0;
}

volatile std::sig_atomic_t stop_asked = 0;

bool stop() { return stop_asked != 0; }

/// The first Ctrl-C or SIGTERM lets the step end, the second ends the program. A file too large for its limit is an error
/// like a full disk.
void catch_signals() {
  struct sigaction action {};
  action.sa_handler = [](int) { stop_asked = 1; };
  action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

/// Writes the summary of a run and tells how it ended.
int report(const parison::forming::Scene& scene, const parison::forming::RunOutcome& outcome, const std::string& output) {
  const auto& facts = outcome.facts;
  if (!facts.completed) fmt::print(stderr, "parison: the run stopped in {}\n", facts.reason);
  const auto summary = parison::forming::write_summary(output, scene, outcome.state, facts);
  fmt::print("\n{}", summary_table(scene, outcome.state, summary));
  std::fflush(stdout);
  if (facts.stopped) fmt::print(stderr, "parison: `parison resume {}` continues it\n", output);
  return facts.completed ? 0 : run_failed;
}

int run(const std::string& path, const std::string& accuracy, const Overrides& overrides, std::string output) {
  using namespace parison::forming;
  const Scene scene = read_scene(path, accuracy, overrides);
  if (output.empty()) output = "results/" + scene.name;
  fmt::print("{}\n", describe_scene(scene));
  std::fflush(stdout);
  catch_signals();
  return report(scene, parison::forming::run(scene, output, stop), output);
}

int resume(const std::string& output, const std::string& path) {
  using namespace parison::forming;
  const CaseOrigin origin = read_origin(find_checkpoint(output));
  const Scene scene = read_scene(path.empty() ? origin.file : path, origin.accuracy, origin.overrides);
  fmt::print("{} at {} accuracy, from the last checkpoint in {}\n", scene.name, scene.accuracy_name, output);
  std::fflush(stdout);
  catch_signals();
  return report(scene, parison::forming::resume(scene, output, stop), output);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Parison: forming of glass containers, from the gob to the take-out.");
  app.require_subcommand(1);
  std::string path, accuracy = "standard", output;
  Overrides overrides;
  const auto with_case = [&](const char* name, const char* what) {
    auto* command = app.add_subcommand(name, what);
    command->add_option("case", path, "folder that holds a case.toml, or a case file")->required();
    command->add_option("--accuracy", accuracy, "draft, standard or fine")->capture_default_str();
    command->add_option("--set", overrides, "KEY=VALUE in place of the case file's value; may be repeated")
        ->take_all()
        ->allow_extra_args(false);
    return command;
  };
  auto* run_command = with_case("run", "run a case");
  run_command->add_option("--output", output, "new folder for the results [results/NAME]");
  auto* resume_command = app.add_subcommand("resume", "continue a run from its last checkpoint");
  resume_command->add_option("results", output, "folder with the results of the run")->required();
  resume_command->add_option("--case", path, "the case, where it has moved");
  auto* check_command = with_case("check", "read a case and say what it needs");
  parison::tools::FitLawRequest fit;
  auto* fit_command = app.add_subcommand("fit-law", "fit the pressure-viscosity law to measurements");
  fit_command->add_option("data", fit.data, "CSV file: p and h, or q, T_glass and T_tool; eta or T_glass")->required();
  fit_command->add_option("--hold", fit.held, "NAME=VALUE: do not fit this constant [p_ref=\"0.2 MPa\"]")
      ->take_all()
      ->allow_extra_args(false);
  fit_command->add_option("--case", fit.case_path, "case whose glass gives the viscosity at T_glass");
  fit_command->add_flag("--relative", fit.relative, "weigh residuals as shares: for scatter that grows with the value");
  parison::core::use_one_blas_thread();
  try {
    app.parse(argc, argv);
    if (fit_command->parsed()) return parison::tools::fit_law(fit);
    if (resume_command->parsed()) return resume(output, path);
    return check_command->parsed() ? check(path, accuracy, overrides) : run(path, accuracy, overrides, output);
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
