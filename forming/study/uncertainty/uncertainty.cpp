// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/uncertainty/uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <numeric>

#include "core/case/case_error.hpp"
#include "core/math/numbers.hpp"
#include "forming/report/error_bars.hpp"
#include "forming/report/model_bars.hpp"
#include "forming/report/wall/solid_quantities.hpp"
#include "forming/study/comparison/finished_run.hpp"
#include "forming/study/sweep/sweep_table.hpp"

namespace parison::forming {
namespace {

using Status = SweepState::Status;

constexpr std::size_t wall_stride = 5;  // of the points of a profile

SweepTable read_table(const SweepPlan& plan) {
  std::vector<SweepState> states;
  for (const SweepRun& run : plan.runs) states.push_back(state_of(plan, run));
  return read_results(plan, states);
}

/// Mean square of the noise of a quantity.
struct Noise {
  double variance = 0;
  double at_least = 0;  ///< lower end of its interval of 95 % on one side
};

Noise noise_of(std::vector<double> values) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); }),
               values.end());
  if (values.size() < 2) return {};
  const double count = double(values.size()), mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return {sum / (count - 1), sum / quantile(boost::math::chi_squared(count - 1), 0.95)};
}

/// Values that are the same but for round-off become the same, so that no tolerance is said to make their scatter.
std::vector<double> without_round_off(std::vector<double> values, const Quantity& at_mean) {
  const double bar = std::isfinite(at_mean.error) ? at_mean.error : 0;
  const double negligible = core::round_off * std::max(std::abs(at_mean.value), bar);
  const bool same = std::all_of(values.begin(), values.end(), [&](double value) {
    return !std::isfinite(value) || std::abs(value - at_mean.value) <= negligible;
  });
  if (!same) return values;
  for (double& value : values)
    if (std::isfinite(value)) value = at_mean.value;
  return values;
}

/// What the analysis of a quantity rests on.
struct Study {
  const UncertaintyPlan& plan;
  std::vector<StandardScatter> scatters;
  ChaosBasis basis;
};

/// Nothing where too few runs have the quantity.
std::optional<Effects> effects_of(const Study& study, const std::vector<double>& values, double noise) {
  std::vector<Eigen::Index> runs;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i])) runs.push_back(Eigen::Index(i));
  if (runs.size() < study.scatters.size() + 6 || 5 * runs.size() < 4 * values.size()) return {};
  Eigen::VectorXd some{Eigen::Index(runs.size())};
  for (std::size_t i = 0; i < runs.size(); ++i) some[Eigen::Index(i)] = values[std::size_t(runs[i])];
  return find_effects(study.basis, study.scatters, runs, some, noise, study.plan.study.seed + 1);
}

/// Values of the runs that are done.
std::vector<double> of_done(const std::vector<double>& values, const std::vector<std::size_t>& done) {
  std::vector<double> some;
  some.reserve(done.size());
  for (const std::size_t run : done) some.push_back(values[run]);
  return some;
}

std::vector<double> place_values(const SweepTable& table, std::size_t point) {
  std::vector<double> values;
  for (const std::vector<double>& profile : table.profiles)
    values.push_back(profile.empty() ? core::none : profile[point]);
  return values;
}

const QuantityColumn* find_column(const SweepTable& table, const std::string& name) {
  for (const QuantityColumn& column : table.quantities)
    if (column.name == name) return &column;
  return nullptr;
}

/// The bar of the wall at a point, by the coarser runs, as that of a quantity.
double numerical_bar(const FinishedRun& mean, std::size_t point) {
  std::vector<ValueOfRun> values{{1, mean.quantities.profile[point]}};
  for (const FinishedRun& coarser : mean.coarser)
    if (const std::vector<double>& other = coarser.quantities.profile; !other.empty())
      values.push_back({coarser.factor, other[point]});
  return bar_of_values(values);
}

/// The runs that are read, and which of those that were drawn are done.
struct Runs {
  FinishedRun mean;
  SweepTable noise, drawn;
  std::vector<std::size_t> done;
};

void add_quantities(const Study& study, const Runs& runs, UncertaintyResult& result) {
  for (const Quantity& quantity : runs.mean.quantities.values) {
    const QuantityColumn* column = find_column(runs.drawn, quantity.name);
    const QuantityColumn* same = find_column(runs.noise, quantity.name);
    std::vector<double> unchanged = same ? same->values : std::vector<double>{};
    unchanged.push_back(quantity.value);
    const Noise noise = noise_of(unchanged);
    const auto effects =
        column ? effects_of(study, without_round_off(of_done(column->values, runs.done), quantity), noise.at_least)
               : std::nullopt;
    if (effects)
      result.quantities.push_back({quantity.name, quantity.unit, quantity.value, quantity.error,
                                   std::sqrt(noise.variance), *effects, quantity.model});
    else
      result.left_out.push_back(quantity.name);
  }
}

/// A point of the profile, without its thickness.
UncertainPlace place_of(const UncertaintyPlan& plan, std::size_t point, std::size_t points) {
  const double along = double(point) / double(points - 1);
  const auto place = plan.sector ? meridian_place(point) : std::nullopt;
  if (!place) return {along, along, core::none, {}};
  return {along, place->share, 0.5 * place->meridian * *plan.sector * 180 / M_PI, {}};
}

void add_wall(const Study& study, const Runs& runs, UncertaintyResult& result) {
  const std::vector<double>& wall = runs.mean.quantities.profile;
  std::vector<Effects> all;
  for (std::size_t point = 0; point < wall.size(); point += wall_stride) {
    if (!std::isfinite(wall[point])) continue;
    std::vector<double> unchanged = place_values(runs.noise, point);
    unchanged.push_back(wall[point]);
    const Noise noise = noise_of(unchanged);
    const auto effects = effects_of(study, of_done(place_values(runs.drawn, point), runs.done), noise.at_least);
    if (!effects) continue;
    result.wall.push_back(place_of(study.plan, point, wall.size()));
    result.wall.back().thickness = {
        "wall", "mm", wall[point], numerical_bar(runs.mean, point), std::sqrt(noise.variance), *effects};
    // Draws are the same only where the same runs were used.
    if (effects->runs == runs.done.size()) all.push_back(*effects);
  }
  if (!all.empty()) result.wall_effects = sum_of(all);
}

void count_runs(const UncertaintyPlan& plan, Runs& runs, UncertaintyResult& result) {
  for (std::size_t i = 0; i < runs.drawn.states.size(); ++i) {
    const SweepState& state = runs.drawn.states[i];
    if (state.status == Status::done) runs.done.push_back(i);
    result.waiting += state.status == Status::waiting;
    if (state.status == Status::failed) result.failures.push_back(plan.drawn.runs[i].name + ": " + state.reason);
  }
  result.done = runs.done.size();
  result.failed = result.failures.size();
}

}  // namespace

double UncertainQuantity::bar() const {
  return std::isfinite(numerical) ? std::hypot(numerical, tolerance_bar()) : tolerance_bar();
}

std::string UncertainQuantity::model_text() const {
  return forming::model_text(model);
}

UncertaintyResult analyse_uncertainty(const UncertaintyPlan& plan) {
  const SweepState mean = state_of(plan.mean, plan.mean.runs.front());
  const std::string folder = plan.mean.folder(plan.mean.runs.front());
  if (mean.status != Status::done)
    throw core::CaseError(
        fmt::format("{}: the run with all values at their means has no results{}, allowed are "
                    "tolerances about a case that comes to its end",
                    folder, mean.reason.empty() ? "" : " (" + mean.reason + ")"));
  Runs runs{read_finished_run(folder), read_table(plan.noise), read_table(plan.drawn), {}};
  UncertaintyResult result;
  count_runs(plan, runs, result);
  const std::size_t least = plan.tolerances.size() + 6;
  if (result.done < least)
    throw core::CaseError(fmt::format("{}: {} of {} runs came to their end, allowed are {} at least{}",
                                      plan.drawn.output, result.done, plan.drawn.runs.size(), least,
                                      result.failures.empty() ? "" : "; " + result.failures.front()));
  Eigen::MatrixXd places(Eigen::Index(runs.done.size()), plan.places.cols());
  for (std::size_t i = 0; i < runs.done.size(); ++i)
    places.row(Eigen::Index(i)) = plan.places.row(Eigen::Index(runs.done[i]));
  Study study{plan, {}, {}};
  for (const ToleranceRange& range : plan.ranges) study.scatters.push_back(range.scatter);
  study.basis = chaos_basis(study.scatters, places);
  add_quantities(study, runs, result);
  add_wall(study, runs, result);
  return result;
}

Ranking measure_first(const UncertaintyPlan& plan, const UncertaintyResult& result) {
  Ranking ranking;
  const std::size_t count = plan.tolerances.size();
  if (result.wall_effects) {
    ranking.indices = sobol_indices(*result.wall_effects);
    ranking.of = "the wall";
  } else {
    ranking.indices = {std::vector<Interval>(count), std::vector<Interval>(count)};
    ranking.of = "the quantities (mean)";
    std::vector<SobolIndices> all;
    for (const UncertainQuantity& quantity : result.quantities)
      if (has_effect(quantity.effects)) all.push_back(sobol_indices(quantity.effects));
    const auto add = [&](Interval& sum, const Interval& one) {
      const double share = 1 / double(all.size());
      sum = {sum.value + share * one.value, sum.low + share * one.low, sum.high + share * one.high};
    };
    for (const SobolIndices& one : all)
      for (std::size_t i = 0; i < count; ++i) {
        add(ranking.indices.first[i], one.first[i]);
        add(ranking.indices.total[i], one.total[i]);
      }
  }
  ranking.order.resize(count);
  std::iota(ranking.order.begin(), ranking.order.end(), std::size_t{0});
  std::stable_sort(ranking.order.begin(), ranking.order.end(), [&](std::size_t a, std::size_t b) {
    return ranking.indices.total[a].value > ranking.indices.total[b].value;
  });
  return ranking;
}

}  // namespace parison::forming
