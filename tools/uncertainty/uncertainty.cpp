// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/uncertainty/uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "core/io/written_files.hpp"
#include "forming/study/uncertainty/uncertainty.hpp"
#include "tools/program/exit_codes.hpp"
#include "tools/program/folder_lock.hpp"
#include "tools/program/stop_request.hpp"
#include "tools/sweep/run_pool.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;
using forming::Effects;
using forming::Interval;
using forming::UncertainQuantity;
using forming::UncertaintyPlan;
using forming::UncertaintyResult;

void print_tolerances(const UncertaintyPlan& plan) {
  fmt::print("{} at {} accuracy: {} tolerances, {} runs with values drawn from them, in {}\n", plan.study.case_path,
             plan.study.accuracy, plan.tolerances.size(), plan.drawn.runs.size(), plan.study.output);
  for (std::size_t i = 0; i < plan.tolerances.size(); ++i) {
    const core::Tolerance& tolerance = plan.tolerances[i];
    const forming::ToleranceRange& range = plan.ranges[i];
    fmt::print("  {:<36} {}\n", tolerance.key, tolerance.given);
    for (const auto& [end, reason] : {std::pair{range.scatter.low, range.below}, {range.scatter.high, range.above}})
      if (!reason.empty())
        fmt::print("  {:<36} ends at {}: {}\n", "", tolerance.value_text(forming::value_at(tolerance, end)), reason);
  }
  for (const forming::RefusedRow& row : plan.refused)
    fmt::print("  left out, as the case does not take it: {}: {}\n", fmt::join(row.values, ", "), row.reason);
  std::fflush(stdout);
}

void print_list(const UncertaintyPlan& plan) {
  for (const forming::SweepRun& run : plan.drawn.runs) {
    std::string line = run.name;
    for (std::size_t i = 0; i < run.values.size(); ++i)
      line += fmt::format("  {}={}", plan.tolerances[i].key, run.values[i]);
    fmt::print("{}\n", line);
  }
}

/// Makes the runs of a part that are not done; false where stopped.
bool make_part(const forming::SweepPlan& plan, const char* what, int jobs) {
  forming::claim_sweep(plan);
  forming::write_manifest(plan);
  std::vector<forming::SweepState> states;
  states.reserve(plan.runs.size());
  for (const forming::SweepRun& run : plan.runs) states.push_back(forming::state_of(plan, run));
  const auto waiting = std::count_if(states.begin(), states.end(), [](const forming::SweepState& state) {
    return state.status == forming::SweepState::Status::waiting;
  });
  fmt::print("{}: {} of {} runs to make\n", what, waiting, plan.runs.size());
  std::fflush(stdout);
  return run_sweep(plan, states, jobs);
}

std::string bar_text(double bar) {
  return std::isfinite(bar) ? fmt::format("{:.2g}", bar) : "-";
}

std::string share_text(const Interval& share) {
  if (std::isnan(share.value)) return fmt::format("unknown ({:.2f} to {:.2f})", share.low, share.high);
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", share.value, share.low, share.high);
}

/// The tolerance that makes the most of a quantity's scatter.
std::string most_of(const UncertaintyPlan& plan, const Effects& effects) {
  if (effects.found.whole == 0 && effects.unexplained == 0) return "none: it is the same in all runs";
  if (!has_effect(effects)) return "no effect above the noise of the runs";
  const forming::SobolIndices indices = forming::sobol_indices(effects);
  const auto most = std::max_element(indices.total.begin(), indices.total.end(),
                                     [](const Interval& a, const Interval& b) { return a.value < b.value; });
  return fmt::format("{} {}{}", plan.tolerances[std::size_t(most - indices.total.begin())].key, share_text(*most),
                     effects.q2() < forming::good_q2 ? ", surrogate poor" : "");
}

void print_quantities(const UncertaintyPlan& plan, const UncertaintyResult& result) {
  fmt::print(
      "\n  bars: numerical, of the model, from the tolerances (two standard deviations), numerical and tolerances "
      "both; Q2 at runs not seen\n");
  fmt::print("  {:<24}{:>11}{:>10}{:>9}{:>11}{:>9}  {:<8}{:>6}  {}\n", "quantity", "at means", "numerical", "model",
             "tolerances", "both", "unit", "Q2", "most of it from (total index)");
  for (const UncertainQuantity& quantity : result.quantities)
    fmt::print("  {:<24}{:>11.5g}{:>10}{:>9}{:>11}{:>9}  {:<8}{:>6.2f}  {}\n", quantity.name, quantity.at_mean,
               bar_text(quantity.numerical), quantity.model_text(), bar_text(quantity.tolerance_bar()),
               bar_text(quantity.bar()), quantity.unit, quantity.effects.q2(), most_of(plan, quantity.effects));
  for (const std::string& name : result.left_out) fmt::print("  {:<24} too few runs have it\n", name);
}

void print_ranking(const UncertaintyPlan& plan, const UncertaintyResult& result) {
  const forming::Ranking ranking = forming::measure_first(plan, result);
  fmt::print("\n  measure first: share of the variance of {}, alone and with others (95 % intervals)\n", ranking.of);
  for (const std::size_t i : ranking.order)
    fmt::print("  {:<36} {:<24} {}\n", plan.tolerances[i].key, share_text(ranking.indices.first[i]),
               share_text(ranking.indices.total[i]));
  if (!result.wall_effects) return;
  if (!has_effect(*result.wall_effects))
    fmt::print("  nothing that the tolerances do to the wall shows above the noise of the runs\n");
  else if (const double q2 = result.wall_effects->q2(); q2 < forming::good_q2)
    fmt::print(
        "  the surrogate explains {:.0f} % of the wall's variance in runs that it has not seen: the intervals are "
        "wide for that; more --runs narrow them\n",
        100 * std::max(0.0, q2));
}

int close_study(const UncertaintyPlan& plan) {
  const UncertaintyResult result = forming::analyse_uncertainty(plan);
  forming::write_uncertainty(plan, result);
  print_quantities(plan, result);
  print_ranking(plan, result);
  for (const std::string& failure : result.failures) fmt::print("  no results: {}\n", failure);
  fmt::print("\n  {} runs done, {} failed, {} refused; {}/uncertainty.svg, .json, .csv\n", result.done, result.failed,
             plan.refused.size(), plan.study.output);
  return result.failed > 0 ? run_failed : 0;
}

}  // namespace

int uncertainty(const UncertaintyRequest& request) {
  const std::string name = fs::path(request.case_path).filename() == "case.toml"
                               ? fs::absolute(request.case_path).parent_path().filename().string()
                               : fs::path(request.case_path).stem().string();
  const UncertaintyPlan plan = forming::plan_uncertainty(
      {request.case_path, request.accuracy, request.overrides,
       request.output.empty() ? "results/uncertainty_" + name : request.output, request.runs, request.seed});
  if (request.list) {
    print_tolerances(plan);
    print_list(plan);
    return 0;
  }
  const int jobs = request.jobs > 0 ? request.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  catch_signals();
  core::claim_folder(plan.study.output, "uncertainty",
                     {"uncertainty.json", "uncertainty.csv", "uncertainty.svg", "sobol_indices.csv", "wall.csv", "mean",
                      "noise", "drawn"});
  const FolderLock lock(plan.study.output);
  print_tolerances(plan);
  const bool ended = make_part(plan.mean, "values at their means, with error bars", jobs) &&
                     make_part(plan.noise, "noise, by changes that mean nothing", jobs) &&
                     make_part(plan.drawn, "values drawn from the tolerances", jobs);
  if (ended) return close_study(plan);
  fmt::print(stderr, "parison: stopped on request; the same command goes on with it\n");
  return run_failed;
}

}  // namespace parison::tools
