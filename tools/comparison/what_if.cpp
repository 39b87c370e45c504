// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/comparison/what_if/what_if.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "core/case/case_error.hpp"
#include "core/case/text/case_text.hpp"
#include "core/io/files.hpp"
#include "core/io/json_read.hpp"
#include "core/io/written_files.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/scene/describe/unusual.hpp"
#include "forming/scene/materials/material_library.hpp"
#include "forming/study/comparison/comparison.hpp"
#include "forming/study/comparison/what_if/finished_base.hpp"
#include "forming/study/setting_error.hpp"
#include "tools/comparison/compare.hpp"
#include "tools/comparison/run_queue.hpp"
#include "tools/program/exit_codes.hpp"
#include "tools/program/stop_request.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;
using forming::Comparison;
using forming::WhatIf;

struct Round {
  bool stopped = false;
  std::string base_failed;  ///< why; empty where the base completed
  std::optional<Comparison> comparison;
  double cpu_seconds = 0;  ///< of its runs
};

/// Of the runs of a round: as measured where all were made now, else as their summaries have it.
double cpu_of(const std::vector<QueuedRun>& runs, double measured) {
  if (std::all_of(runs.begin(), runs.end(), [](const QueuedRun& run) { return run.child != 0; })) return measured;
  double seconds = 0;
  for (const QueuedRun& run : runs)
    if (const auto summary = core::read_json_file(run.plan.directory + "/summary.json"))
      seconds += summary->number_of("cpu_seconds");
  return seconds;
}

/// An accuracy with what its factor means: one below 1 makes edges and steps finer.
std::string accuracy_text(const std::string& accuracy) {
  const double factor = forming::read_accuracy(accuracy).coarsening_factor;
  if (factor == 1) return accuracy + " accuracy";
  const std::string preset = accuracy.substr(0, accuracy.find(' '));
  return fmt::format("{} accuracy ({:.2g} times {} than {})", accuracy, std::max(factor, 1 / factor),
                     factor < 1 ? "finer" : "coarser", preset);
}

/// The comparison of the variants; one without results is a row with its reason.
Comparison compare_variants(const WhatIf& asked, const std::vector<QueuedRun>& runs) {
  const auto folder = [&](const std::string& name) { return asked.directory + '/' + name; };
  const auto run_of = [&](const std::string& name) {
    return std::find_if(runs.begin(), runs.end(),
                        [&](const QueuedRun& run) { return run.plan.directory == folder(name); });
  };
  // A folder may have twins from an earlier question with --twice.
  const auto repeats = asked.twice ? forming::Repeats::averaged : forming::Repeats::ignored;
  Comparison comparison = forming::compare_folders(folder(forming::base_name), {});
  for (const auto& variant : asked.variants) {
    const auto run = run_of(variant.name);
    if (run == runs.end()) {
      comparison.others.push_back({variant.name, {}, forming::nothing_changed(asked, variant), {}, {}, true});
    } else if (run->status == QueuedRun::Status::done) {
      Comparison one = forming::compare_folders(folder(forming::base_name), {folder(variant.name)}, repeats);
      comparison.others.push_back(std::move(one.others.front()));
    } else {
      comparison.others.push_back({variant.name, forming::settings_of(asked, variant), run->reason, {}});
    }
  }
  return comparison;
}

/// What is unusual in the base, and in each variant beyond that; and which variants change nothing.
void print_notes(const WhatIf& asked) {
  const auto unusual = [&](std::vector<std::string> overrides) {
    overrides.insert(overrides.begin(), asked.overrides.begin(), asked.overrides.end());
    return forming::unusual_values(forming::read_scene(asked.case_path, asked.accuracy, overrides));
  };
  const std::vector<std::string> in_base = unusual({});
  for (const std::string& note : in_base) fmt::print("unusual in the base, is it meant? {}\n", note);
  for (const forming::WhatIfVariant& variant : asked.variants) {
    for (const std::string& note : unusual(variant.overrides))
      if (std::find(in_base.begin(), in_base.end(), note) == in_base.end())
        fmt::print("unusual in variant {}, is it meant? {}\n", variant.name, note);
    for (const std::string& note : forming::settled_replaced(asked, variant)) fmt::print("{}\n", note);
    if (const std::string nothing = forming::nothing_changed(asked, variant); !nothing.empty())
      fmt::print("{}; it is not run\n", nothing);
  }
}

/// The folder of the runs of one accuracy, before the first of them.
void claim(const WhatIf& asked) {
  std::set<std::string> names = forming::comparison_files();
  const auto add = [&](const std::string& name) { names.insert({name, name + ".log"}); };
  add(forming::base_name);
  for (const auto& variant : asked.variants) add(variant.name);
  core::claim_folder(asked.directory, "what-if", names);
}

/// Plans, runs and compares at one accuracy.
Round run_round(const WhatIf& asked, int jobs, bool is_first = true) {
  std::vector<QueuedRun> runs;
  for (auto& plan : forming::plan_runs(asked)) runs.push_back({std::move(plan)});
  claim(asked);
  if (is_first) print_notes(asked);
  const auto variants =
      std::count_if(runs.begin() + 1, runs.end(), [](const QueuedRun& run) { return run.plan.inside.empty(); });
  fmt::print("{} at {}: {} variant{}, {} run{} in {}\n", asked.case_path, accuracy_text(asked.accuracy), variants,
             variants == 1 ? "" : "s", runs.size(), runs.size() == 1 ? "" : "s", asked.directory);
  std::fflush(stdout);
  Round round;
  const double before = cpu_of_children();
  round.stopped = !run_all(runs, asked.case_path, jobs);
  if (round.stopped) return round;
  round.cpu_seconds = cpu_of(runs, cpu_of_children() - before);
  if (runs.front().status == QueuedRun::Status::failed)
    round.base_failed = runs.front().reason;
  else
    round.comparison = compare_variants(asked, runs);
  return round;
}

std::string folder_name(std::string accuracy) {
  std::replace(accuracy.begin(), accuracy.end(), ' ', '_');
  return "at_" + accuracy;
}

/// Says on stderr where a run has not made the quantity that was asked for.
bool has_quantity(const forming::FinishedRun& run, const std::string& quantity) {
  if (run.quantities.values.empty()) return true;
  const std::string problem = forming::unknown_quantity(quantity, run.quantities.values);
  if (!problem.empty()) fmt::print(stderr, "parison: the run of the base has no such result: {}\n", problem);
  return problem.empty();
}

int report(const Comparison& comparison, const WhatIfRequest& request, const std::string& output) {
  const std::string quantity = request.quantity.empty() ? forming::ranked_quantity(comparison) : request.quantity;
  fmt::print("{}{}", forming::comparison_tables(comparison), forming::ranking_table(comparison, quantity));
  fmt::print("\n  {}; {:.1f} s of CPU time\n", forming::write_comparison(comparison, output), cpu_of_children());
  const bool all = std::all_of(comparison.others.begin(), comparison.others.end(),
                               [](const forming::ComparedRun& other) { return other.result || other.unchanged; });
  return all && has_quantity(comparison.base, quantity) ? 0 : run_failed;
}

int failed(const Round& round) {
  if (round.stopped)
    fmt::print(stderr, "parison: stopped on request; the same command goes on with it\n");
  else
    fmt::print(stderr, "parison: the case itself stopped: {}\n", round.base_failed);
  return run_failed;
}

/// Which variants have no bar in the last round, as the end of a sentence; empty where all have.
std::string without_bar(const forming::ResolutionControl& control) {
  const auto& names = control.without_bar();
  if (names.empty()) return {};
  return fmt::format("; {} without a bar: a run of it, or a coarser one, stopped, or has no such result",
                     fmt::join(names, ", "));
}

void print_bars(const forming::ResolutionControl& control) {
  const std::string label = control.label();
  if (std::isfinite(control.bar()))
    fmt::print("  the error bars of {} are up to {:.3g} {}, wanted is {:.3g}{}\n", label, control.bar(), control.unit(),
               control.target(), without_bar(control));
  else
    fmt::print("  no variant has an error bar of {} yet, wanted is {:.3g} {}\n", label, control.target(),
               control.unit());
  std::fflush(stdout);
}

std::string duration_text(double seconds) {
  constexpr double minute = 60, hour = 3600;
  if (seconds < 2 * minute) return fmt::format("{:.2g} s", std::max(1.0, seconds));
  return seconds < 2 * hour ? fmt::format("{:.0f} min", seconds / minute) : fmt::format("{:.1f} h", seconds / hour);
}

/// What the next round is and costs, before it begins.
void print_next(const forming::ResolutionControl& control) {
  fmt::print("  next: {}; about {} of CPU time, by that of this round", accuracy_text(control.accuracy()),
             duration_text(control.expected_cpu()));
  if (std::isfinite(control.expected_bar()))
    fmt::print("; bars of up to {:.3g} {} are expected", control.expected_bar(), control.unit());
  fmt::print("\n");
  std::fflush(stdout);
}

/// Finer and finer until the error bars let a difference of the size asked for be seen.
int what_if_to_resolve(const WhatIfRequest& request, WhatIf asked, const std::string& output,
                       forming::ResolutionControl control) {
  for (;;) {
    asked.accuracy = control.accuracy();
    asked.directory = output + '/' + folder_name(asked.accuracy);
    if (control.rounds() == 0) {
      forming::plan_runs(asked);  // what is refused leaves no folder
      core::claim_folder(output, "what-if", forming::comparison_files());
    }
    const Round round = run_round(asked, request.jobs, control.rounds() == 0);
    if (!round.comparison) return failed(round);
    control.add(*round.comparison, round.cpu_seconds);
    forming::write_comparison(*round.comparison, asked.directory);  // also says that the round has come to its end
    print_bars(control);
    if (!control.finished()) {
      print_next(control);
      continue;
    }
    WhatIfRequest shown = request;
    if (shown.quantity.empty()) shown.quantity = control.quantity();
    const int code = report(*round.comparison, shown, output);
    if (control.reached()) return code;
    if (const std::string problem = control.too_small(); !problem.empty()) {
      fmt::print(stderr, "parison: --resolve: {}; the runs so far are in {}\n", problem, asked.directory);
      return run_failed;
    }
    if (const std::string why = control.gives_up(); !why.empty()) {
      fmt::print(stderr,
                 "parison: differences of {} are not resolved, those of {:.3g} {} are: {}. The last round is in {}; "
                 "--accuracy \"{}\" makes a finer one all the same\n",
                 request.resolve, control.bar(), control.unit(), why, asked.directory, control.accuracy());
      return run_failed;
    }
    fmt::print(stderr, "parison: differences of {} are not resolved after {} rounds{}; the last is in {}\n",
               request.resolve, control.rounds(), without_bar(control), asked.directory);
    return run_failed;
  }
}

WhatIf asked_of_case(const WhatIfRequest& request) {
  const std::string accuracy = request.accuracy.empty() ? "standard" : request.accuracy;
  if (forming::read_accuracy(accuracy).target)
    throw core::CaseError(fmt::format(
        "--accuracy: {} was found, allowed are draft, standard, fine, coarser or finer ones; --resolve chooses one",
        accuracy));
  return {request.case_path, accuracy, "", request.overrides, request.variants};
}

/// The case of all runs; a mistake in what --base sets is told as one of that option.
forming::Scene read_base(const WhatIf& asked) {
  try {
    if (const auto repeated = core::repeated_key(forming::read_case(asked.case_path, asked.overrides), asked.overrides);
        asked.base_results.empty() && !repeated.empty())
      throw core::CaseError(fmt::format("--base: {}; allowed is one of them", repeated));
    return forming::read_scene(asked.case_path, "draft", asked.overrides);
  } catch (const core::CaseError& error) {
    throw core::CaseError(forming::refusal_text(error, "--base", asked.overrides));
  }
}

/// The run that is there says the case and the accuracy.
WhatIf asked_of_results(const WhatIfRequest& request) {
  const std::string& folder = request.case_path;
  const forming::FinishedBase base = forming::read_finished_base(folder);
  const bool same_accuracy = request.accuracy.empty() || request.accuracy == base.accuracy;
  if (!request.overrides.empty() || !request.resolve.empty() || !same_accuracy)
    throw core::CaseError(fmt::format(
        "{}: a finished run at {} accuracy was found, which is the base as it is: {} is not allowed with it; "
        "allowed is the case \"{}\" in its place, which is then run",
        folder, base.accuracy,
        !same_accuracy            ? "another --accuracy"
        : request.resolve.empty() ? "--base"
                                  : "--resolve",
        base.case_path));
  return {base.case_path, base.accuracy, "", base.overrides, request.variants, false, folder};
}

}  // namespace

int what_if(const WhatIfRequest& request) {
  catch_signals();
  WhatIf asked = forming::is_result_folder(request.case_path) ? asked_of_results(request) : asked_of_case(request);
  const forming::Scene scene = read_base(asked);
  const std::string output = request.output.empty() ? "results/what_if_" + scene.name : request.output;
  asked.directory = output;
  asked.twice = request.twice;
  const std::vector<forming::Quantity> possible = forming::possible_quantities(scene);
  if (!request.quantity.empty()) forming::require_quantity(request.quantity, possible);
  if (!request.resolve.empty()) return what_if_to_resolve(request, asked, output, {request.resolve, possible});
  const Round round = run_round(asked, request.jobs);
  return round.comparison ? report(*round.comparison, request, output) : failed(round);
}

}  // namespace parison::tools
