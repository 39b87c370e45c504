// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/uncertainty/effects.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace parison::forming {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::size_t bootstrap_draws = 400;
constexpr double tail = 0.025;  // on each side of an interval of 95 %

/// What takes a surrogate's coefficients apart.
struct Parts {
  const ChaosBasis& basis;
  const std::vector<StandardScatter>& scatters;
  const Surrogate& surrogate;
  VectorXd noise_gain;                                ///< of each coefficient
  std::vector<std::vector<double>> half_change = {};  ///< of each variable's polynomials over the two deviations
};

Parts parts_of(const ChaosBasis& basis, const std::vector<StandardScatter>& scatters, const Surrogate& surrogate) {
  Parts parts{basis, scatters, surrogate, VectorXd(surrogate.coefficients.size())};
  for (Index i = 0; i < parts.noise_gain.size(); ++i) parts.noise_gain[i] = surrogate.noise_gain(std::size_t(i));
  for (std::size_t i = 0; i < scatters.size(); ++i) {
    const std::vector<double> low = basis.polynomials[i](std::max(-1.0, scatters[i].low)),
                              high = basis.polynomials[i](std::min(1.0, scatters[i].high));
    std::vector<double> change;
    for (std::size_t degree = 0; degree < low.size(); ++degree) change.push_back(0.5 * (high[degree] - low[degree]));
    parts.half_change.push_back(std::move(change));
  }
  return parts;
}

/// Sums of squared coefficients; `times` the variance of what is left is in each by chance and is taken out.
VarianceParts take_apart(const Parts& parts, const VectorXd& coefficients, double times) {
  const auto variables = Index(parts.scatters.size());
  VarianceParts found{0, VectorXd::Zero(variables), VectorXd::Zero(variables), VectorXd::Zero(variables)};
  for (Index i = 1; i < coefficients.size(); ++i) {
    const ChaosTerm& term = parts.basis.terms[parts.surrogate.terms[std::size_t(i)]];
    const double square = coefficients[i] * coefficients[i] - times * parts.noise_gain[i] * parts.surrogate.variance;
    const bool alone = std::count_if(term.begin(), term.end(), [](int degree) { return degree > 0; }) == 1;
    found.whole += square;
    for (Index j = 0; j < variables; ++j) {
      const int degree = term[std::size_t(j)];
      if (degree == 0) continue;
      found.total[j] += square;
      if (!alone) continue;
      found.first[j] += square;
      found.main_effect[j] += coefficients[i] * parts.half_change[std::size_t(j)][std::size_t(degree)];
    }
  }
  return found;
}

/// The value that a share of a sample lies below.
double share_below(std::vector<double> sample, double share) {
  const double at = share * double(sample.size() - 1);
  const auto below = std::size_t(at);
  std::sort(sample.begin(), sample.end());
  return below + 1 < sample.size() ? sample[below] + (at - double(below)) * (sample[below + 1] - sample[below])
                                   : sample.back();
}

using Measure = std::function<double(const VarianceParts&)>;

Interval interval_of(const Effects& effects, const Measure& measure) {
  std::vector<double> sample;
  for (const VarianceParts& parts : effects.resampled) sample.push_back(measure(parts));
  const double value = measure(effects.found);
  return {value, std::min(value, share_below(sample, tail)), std::max(value, share_below(sample, 1 - tail))};
}

/// A share of the whole variance, 0 to 1.
Interval share_of(const Effects& effects, VectorXd VarianceParts::*part, Index variable) {
  if (!has_effect(effects)) return {std::nan(""), 0, 1};
  const Interval share = interval_of(effects, [&](const VarianceParts& parts) {
    return parts.whole > 0 ? std::clamp((parts.*part)[variable] / parts.whole, 0.0, 1.0) : 0;
  });
  const double missing = effects.unexplained / (effects.unexplained + effects.found.whole);
  return {share.value, (1 - missing) * share.low, std::min(1.0, (1 - missing) * share.high + missing)};
}

VarianceParts& operator+=(VarianceParts& sum, const VarianceParts& other) {
  sum.whole += other.whole;
  sum.first += other.first, sum.total += other.total, sum.main_effect += other.main_effect;
  return sum;
}

}  // namespace

bool has_effect(const Effects& effects) {
  return effects.found.whole > 0 && effects.q2() > effects.by_chance;
}

Effects find_effects(const ChaosBasis& basis, const std::vector<StandardScatter>& scatters,
                     const std::vector<Index>& runs, const VectorXd& values, double noise, std::uint64_t seed) {
  const Surrogate surrogate = fit_surrogate(basis, runs, values);
  const Parts parts = parts_of(basis, scatters, surrogate);
  Effects effects{take_apart(parts, surrogate.coefficients, 1), {}, surrogate.coefficients[0]};
  effects.unexplained = std::max(0.0, surrogate.unseen - noise);
  effects.unseen = surrogate.unseen;
  effects.variance = (values.array() - values.mean()).square().mean();
  effects.by_chance = 2 * std::log(double(basis.terms.size())) / double(runs.size());
  effects.runs = runs.size();
  std::mt19937_64 engine(seed);
  const VectorXd residuals = surrogate.residuals.array() - surrogate.residuals.mean();
  VectorXd drawn(residuals.size());
  for (std::size_t draw = 0; draw < bootstrap_draws; ++draw) {
    for (double& one : drawn) one = residuals[Index(engine() % std::uint64_t(residuals.size()))];
    effects.resampled.push_back(take_apart(parts, surrogate.coefficients + surrogate.solution * drawn, 2));
  }
  return effects;
}

Effects sum_of(const std::vector<Effects>& all) {
  Effects sum = all.front();
  for (std::size_t i = 1; i < all.size(); ++i) {
    sum.found += all[i].found;
    for (std::size_t draw = 0; draw < sum.resampled.size(); ++draw) sum.resampled[draw] += all[i].resampled[draw];
    sum.mean += all[i].mean;
    sum.unexplained += all[i].unexplained;
    sum.unseen += all[i].unseen, sum.variance += all[i].variance;
    sum.runs = std::min(sum.runs, all[i].runs);
  }
  return sum;
}

SobolIndices sobol_indices(const Effects& effects) {
  SobolIndices indices;
  for (Index i = 0; i < effects.found.first.size(); ++i) {
    indices.first.push_back(share_of(effects, &VarianceParts::first, i));
    indices.total.push_back(share_of(effects, &VarianceParts::total, i));
  }
  return indices;
}

Interval deviation(const Effects& effects) {
  const auto root = [](double variance) { return std::sqrt(std::max(0.0, variance)); };
  const Interval explained = interval_of(effects, [](const VarianceParts& parts) { return parts.whole; });
  if (!has_effect(effects))
    return {root(effects.unexplained), 0, root(std::max(0.0, explained.high) + effects.unexplained)};
  return {root(explained.value + effects.unexplained), root(explained.low),
          root(std::max(0.0, explained.high) + effects.unexplained)};
}

std::vector<Interval> main_effects(const Effects& effects) {
  const double most = deviation(effects).high;
  const auto reach = [&](double effect) {
    return std::hypot(effect, std::sqrt(effects.unexplained)) - std::abs(effect);
  };
  std::vector<Interval> all;
  for (Index i = 0; i < effects.found.main_effect.size(); ++i) {
    const Interval found = interval_of(effects, [i](const VarianceParts& parts) { return parts.main_effect[i]; });
    if (has_effect(effects))
      all.push_back({found.value, found.low - reach(found.low), found.high + reach(found.high)});
    else
      all.push_back({std::nan(""), -most, most});
  }
  return all;
}

}  // namespace parison::forming
