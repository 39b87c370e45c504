// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/uncertainty/uncertainty_plan.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/case/case_error.hpp"
#include "forming/study/audit.hpp"
#include "forming/study/comparison/what_if/tool_overlap.hpp"
#include "forming/study/setting_error.hpp"
#include "forming/study/sweep/design.hpp"

namespace parison::forming {

namespace {

/// The last value between the mean and an end that is taken, and why the next one is not.
double find_end(const core::Tolerance& tolerance, double end, const Refusal& refusal, std::string& reason) {
  constexpr int halvings = 16;
  reason = refusal(value_at(tolerance, end));
  if (reason.empty()) return end;
  double taken = 0, refused = end;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (taken + refused);
    const std::string found = refusal(value_at(tolerance, middle));
    if (!found.empty()) reason = found;
    (found.empty() ? taken : refused) = middle;
  }
  return taken;
}

}  // namespace

double value_at(const core::Tolerance& tolerance, double deviations) {
  return tolerance.mean + deviations * tolerance.deviation();
}

ToleranceRange allowed_range(const core::Tolerance& tolerance, const Refusal& refusal) {
  if (const std::string reason = refusal(tolerance.mean); !reason.empty()) throw core::CaseError(reason);
  ToleranceRange range{full_range(tolerance.distribution), "", ""};
  range.scatter.low = find_end(tolerance, range.scatter.low, refusal, range.below);
  range.scatter.high = find_end(tolerance, range.scatter.high, refusal, range.above);
  return range;
}

namespace {

/// The case with some of its values replaced; why it is refused, empty where it is not.
std::string refusal_of(const UncertaintyStudy& study, const Scene& base, const std::vector<std::string>& settings) {
  std::vector<std::string> overrides = study.overrides;
  overrides.insert(overrides.end(), settings.begin(), settings.end());
  try {
    return new_tool_overlap(base, read_scene(study.case_path, study.accuracy, overrides));
  } catch (const core::CaseError& error) {
    return refusal_text(error);
  }
}

std::string assignment(const core::Tolerance& tolerance, const std::string& value) {
  return tolerance.key + '=' + value;
}

std::vector<ToleranceRange> find_ranges(const UncertaintyPlan& plan, const Scene& base) {
  std::vector<ToleranceRange> ranges;
  for (const core::Tolerance& tolerance : plan.tolerances)
    ranges.push_back(allowed_range(tolerance, [&](double value) {
      return refusal_of(plan.study, base, {assignment(tolerance, tolerance.value_text(value))});
    }));
  return ranges;
}

/// A sweep over a list of rows.
Sweep list_of(const UncertaintyStudy& study, const std::string& name, std::size_t runs) {
  Sweep sweep;
  sweep.file = study.case_path;
  sweep.name = name;
  sweep.case_path = study.case_path;
  sweep.accuracy = study.accuracy;
  sweep.overrides = study.overrides;
  sweep.design = Design::list;
  sweep.runs = runs;
  sweep.keep = Keep::summary;
  return sweep;
}

/// The case with changes that mean nothing.
Sweep noise_sweep(const UncertaintyStudy& study, const Scene& base) {
  constexpr int changes[] = {-3, -2, -1, 1, 2, 3};
  SweepVariable variable;
  for (const int change : changes) {
    const std::string setting = harmless_change(base, change);
    const std::size_t equals = setting.find('=');
    variable.key = setting.substr(0, equals);
    variable.values.push_back(setting.substr(equals + 1));
  }
  Sweep sweep = list_of(study, "noise", std::size(changes));
  sweep.variables.push_back(std::move(variable));
  return sweep;
}

/// Draws rows until so many are taken by the case.
Sweep drawn_sweep(UncertaintyPlan& plan, const Scene& base) {
  const std::size_t variables = plan.tolerances.size(), runs = plan.study.runs;
  Sweep sweep = list_of(plan.study, "drawn", runs);
  for (const core::Tolerance& tolerance : plan.tolerances) sweep.variables.push_back({tolerance.key, {}, 0, 0, ""});
  plan.places.resize(Eigen::Index(runs), Eigen::Index(variables));
  Eigen::Index row = 0;
  for (const std::vector<double>& point : sobol_sequence(variables, 2 * runs, plan.study.seed)) {
    std::vector<std::string> values, settings;
    for (std::size_t i = 0; i < variables; ++i) {
      const core::Tolerance& tolerance = plan.tolerances[i];
      const double place = quantile(plan.ranges[i].scatter, point[i]);
      plan.places(row, Eigen::Index(i)) = place;
      values.push_back(tolerance.value_text(value_at(tolerance, place)));
      settings.push_back(assignment(tolerance, values.back()));
    }
    if (const std::string reason = refusal_of(plan.study, base, settings); !reason.empty()) {
      plan.refused.push_back({values, reason});
      continue;
    }
    for (std::size_t i = 0; i < variables; ++i) sweep.variables[i].values.push_back(values[i]);
    if (++row == Eigen::Index(runs)) return sweep;
  }
  throw core::CaseError(
      fmt::format("{}: more than half of the values drawn from the tolerances are refused, allowed are "
                  "tolerances that the case takes together, unlike: {}",
                  plan.study.case_path, plan.refused.back().reason));
}

void require_runs(const UncertaintyStudy& study, std::size_t tolerances) {
  const std::size_t least = tolerances + 10;
  if (study.runs < least || study.runs > max_sweep_runs)
    throw core::CaseError(fmt::format("--runs: {} runs were found, allowed are {} to {} with {} tolerances", study.runs,
                                      least, max_sweep_runs, tolerances));
}

}  // namespace

std::size_t usual_runs(std::size_t tolerances) {
  return std::max<std::size_t>(32, 8 * tolerances);
}

UncertaintyPlan plan_uncertainty(const UncertaintyStudy& study) {
  const Scene base = read_scene(study.case_path, study.accuracy, study.overrides);
  UncertaintyPlan plan{study, base.tolerances, {}, {}, {}, {}, {}, {}, {}};
  if (base.solid) plan.sector = base.solid->sector;
  if (plan.tolerances.empty())
    throw core::CaseError(
        fmt::format("{}: no tolerance was found, allowed is at least one value such as \"460 +- 10 "
                    "degC\", in the case or by --set",
                    base.file));
  if (plan.tolerances.size() > max_sobol_dimensions)
    throw core::CaseError(fmt::format("{}: {} tolerances were found, allowed are up to {}", base.file,
                                      plan.tolerances.size(), max_sobol_dimensions));
  if (plan.study.runs == 0) plan.study.runs = usual_runs(plan.tolerances.size());
  require_runs(plan.study, plan.tolerances.size());
  plan.ranges = find_ranges(plan, base);
  Sweep mean = list_of(study, "mean", 1);
  mean.error_bars = true;
  plan.mean = plan_sweep(mean, study.output + "/mean");
  plan.noise = plan_sweep(noise_sweep(study, base), study.output + "/noise");
  plan.drawn = plan_sweep(drawn_sweep(plan, base), study.output + "/drawn");
  return plan;
}

}  // namespace parison::forming
