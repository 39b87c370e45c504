// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <functional>
#include <optional>

#include "core/math/numbers.hpp"
#include "forming/report/error_bars.hpp"
#include "forming/study/coarse_run.hpp"
#include "forming/study/comparison/comparison.hpp"

namespace parison::forming {
namespace {

constexpr double confidence = 0.9;
/// A bar of the profile is that of the places around it, so many to each side.
constexpr int neighbours = 8;

/// A number of a run, where it has it.
using Value = std::function<std::optional<double>(const Quantities&)>;

/// Base and other once: themselves, or a twin of each that left its run at the same stage.
struct Pair {
  const Quantities *base, *other;
};

/// Coarser runs of both, and by how much they are coarser.
struct Partners {
  std::vector<Pair> pairs;
  double factor;
};

/// A run and its twin, `factor` times coarser than the runs that are compared.
struct TwinPair {
  const Quantities *run, *twin;
  double factor;
};

struct Evidence {
  const FinishedRun &base, &other;
  std::vector<Pair> pairs;  ///< whose mean difference counts
  std::vector<Partners> partners;
  std::vector<TwinPair> twins;
};

Value quantity_named(const std::string& name) {
  return [name](const Quantities& run) -> std::optional<double> {
    const Quantity* found = run.find(name);
    return found ? std::optional(found->value) : std::nullopt;
  };
}

Value wall_at(std::size_t place) {
  return [place](const Quantities& run) -> std::optional<double> {
    if (place >= run.profile.size() || !std::isfinite(run.profile[place])) return std::nullopt;
    return run.profile[place];
  };
}

std::optional<double> difference_of(const Value& value, const Quantities& base, const Quantities& other) {
  const auto a = value(base), b = value(other);
  return a && b ? std::optional(*b - *a) : std::nullopt;
}

/// The mean of base and of other over the pairs that have both; nothing where none has.
std::optional<std::pair<double, double>> means_of(const Value& value, const std::vector<Pair>& pairs) {
  double base = 0, other = 0;
  int count = 0;
  for (const Pair& pair : pairs) {
    const auto a = value(*pair.base), b = value(*pair.other);
    if (!a || !b) continue;
    base += *a, other += *b, ++count;
  }
  return count > 0 ? std::optional(std::pair(base / count, other / count)) : std::nullopt;
}

/// The mean difference of the pairs.
std::optional<double> difference_of(const Value& value, const std::vector<Pair>& pairs) {
  const auto means = means_of(value, pairs);
  return means ? std::optional(means->second - means->first) : std::nullopt;
}

/// The twin that left its run last, but not after the runs that are compared left each other.
const Twin* twin_for(const FinishedRun& run, std::size_t in_common) {
  const Twin* chosen = nullptr;
  for (const Twin& twin : run.twins)
    if (twin.stages <= in_common && (!chosen || twin.stages > chosen->stages)) chosen = &twin;
  return chosen;
}

/// How far two runs may be compared: the stages in which they are the same, and whether twins make a second pair.
struct Common {
  std::size_t stages;
  Repeats repeats;
};

/// The twins of both runs that make a second pair; null where both have none from the same stage on.
std::pair<const Twin*, const Twin*> second_pair(const FinishedRun& base, const FinishedRun& other,
                                                const Common& common) {
  const Twin *a = twin_for(base, common.stages), *b = twin_for(other, common.stages);
  const bool are_repeats = common.repeats == Repeats::averaged && a && b && a->stages == b->stages;
  return are_repeats ? std::pair(a, b) : std::pair<const Twin*, const Twin*>();
}

/// Two runs, and their twins where these make a second pair.
std::vector<Pair> pairs_of(const FinishedRun& base, const FinishedRun& other, const Common& common) {
  std::vector<Pair> pairs{{&base.quantities, &other.quantities}};
  if (const auto [a, b] = second_pair(base, other, common); a) pairs.push_back({&a->quantities, &b->quantities});
  return pairs;
}

/// What the second pair has otherwise, in words.
std::string repeated_with(const FinishedRun& base, const FinishedRun& other, const Common& common) {
  const Twin* twin = second_pair(base, other, common).first;
  if (!twin) return {};
  return fmt::format("{} {:g} K warmer from {}", twin->warmer_gob ? "the gob" : "all tools", twin_warmer,
                     twin->stages == 0 ? "the start" : "the end of stage " + base.stages[twin->stages - 1].name);
}

Evidence evidence_of(const FinishedRun& base, const FinishedRun& other, const Common& common) {
  const std::size_t in_common = common.stages;
  Evidence evidence{base, other, pairs_of(base, other, common), {}, {}};
  const auto add_twin = [&](const FinishedRun& run) {
    if (const Twin* twin = twin_for(run, in_common))
      evidence.twins.push_back({&run.quantities, &twin->quantities, run.factor});
  };
  for (const FinishedRun* run : {&base, &other}) {
    add_twin(*run);
    for (const FinishedRun& coarser : run->coarser) add_twin(coarser);
  }
  if (base.accuracy != other.accuracy) return evidence;  // their errors do not cancel
  for (const FinishedRun& coarser : base.coarser)
    if (const FinishedRun* same = coarser_by(other, coarser.factor))
      evidence.partners.push_back({pairs_of(coarser, *same, common), coarser.factor});
  // Runs so coarse tell too little by themselves.
  const auto is_near = [](const Partners& one) { return one.factor <= partner_factors.front(); };
  if (std::none_of(evidence.partners.begin(), evidence.partners.end(), is_near)) evidence.partners.clear();
  // Where some are as sure as the difference itself, those that are less sure would only add their scatter.
  const auto is_sure = [&](const Partners& one) { return one.pairs.size() >= evidence.pairs.size(); };
  auto& all = evidence.partners;
  if (std::any_of(all.begin(), all.end(), is_sure))
    all.erase(std::remove_if(all.begin(), all.end(), [&](const Partners& one) { return !is_sure(one); }), all.end());
  return evidence;
}

/// Half width of the interval in which the mean difference scatters, by the twins; NaN where none has it. Those of
/// coarser runs scatter more: with the order that the error bars have, and that the jar shows from draft to standard.
double scatter_by_twins(const Evidence& evidence, const Value& value) {
  double squares = 0;
  int count = 0;
  for (const auto& [run, twin, factor] : evidence.twins)
    if (const auto found = difference_of(value, *run, *twin)) {
      const double finer = *found / std::pow(factor, difference_order);
      squares += finer * finer;
      ++count;
    }
  if (count == 0) return core::none;
  const double t = boost::math::quantile(boost::math::students_t(count), 0.5 * (1 + confidence));
  return t * std::sqrt(squares / count / double(evidence.pairs.size()));
}

/// Richardson's estimate of the error of a difference by the differences of the coarser runs; NaN without one.
double error_by_partners(const Evidence& evidence, const Value& value, double difference) {
  double error = core::none;
  for (const Partners& partners : evidence.partners)
    if (const auto coarse = difference_of(value, partners.pairs))
      error = std::fmax(error, richardson_estimate(*coarse - difference, 1, partners.factor, difference_order));
  return error;
}

/// The place of the thinnest wall jumps from one place to another as thin: nothing cancels in that.
bool jumps(const std::string& name) {
  return name == "thickness_min_at";
}

Difference compare_quantity(const Evidence& evidence, const Quantity& base, const Quantity& other,
                            const RunComparison& comparison) {
  const Value value = quantity_named(base.name);
  const auto [mean_base, mean_other] = *means_of(value, evidence.pairs);
  Difference result{base.name, base.unit, mean_base, mean_other, mean_other - mean_base, base.scale};
  const double by_twins = scatter_by_twins(evidence, value);
  result.scatter =
      std::isfinite(by_twins) ? by_twins : stated_scatter(base.name) * size_of_kind(evidence.base.quantities, base);
  result.added = base.error + other.error;
  result.model = std::isnan(other.model) ? other.model : std::max(base.model, other.model);
  const double error = comparison.bars == BarSource::differences && !jumps(base.name)
                           ? error_by_partners(evidence, value, result.difference)
                           : result.added;
  if (std::isfinite(error)) result.bar = std::max({error, result.scatter, least_bar * base.scale});
  return result;
}

/// Each bar or the root mean square of those around it, whichever is larger: at one place alone runs may agree by
/// chance.
std::vector<double> with_neighbours(const std::vector<double>& bars) {
  std::vector<double> wide(bars.size(), core::none);
  const int size = static_cast<int>(bars.size());
  for (int i = 0; i < size; ++i) {
    if (!std::isfinite(bars[i])) continue;
    double squares = 0;
    int count = 0;
    for (int k = std::max(0, i - neighbours); k <= std::min(size - 1, i + neighbours); ++k)
      if (std::isfinite(bars[k])) {
        squares += bars[k] * bars[k];
        ++count;
      }
    wide[i] = std::max(bars[i], std::sqrt(squares / count));
  }
  return wide;
}

ProfileComparison compare_walls(const Evidence& evidence, const RunComparison& comparison) {
  ProfileComparison walls;
  const auto &base = evidence.base.quantities.profile, &other = evidence.other.quantities.profile;
  if (base.empty() || base.size() != other.size()) return walls;
  walls = {base, other, std::vector(base.size(), core::none), std::vector(base.size(), core::none)};
  for (std::size_t i = 0; i < base.size(); ++i) {
    const Value value = wall_at(i);
    const auto means = means_of(value, evidence.pairs);
    if (!means) continue;
    const double difference = means->second - means->first;
    walls.base[i] = means->first, walls.other[i] = means->second, walls.difference[i] = difference;
    if (comparison.bars != BarSource::differences) continue;
    const double by_twins = scatter_by_twins(evidence, value);
    const double scatter = std::isfinite(by_twins) ? by_twins : stated_scatter("thickness_profile") * base[i];
    const double error = error_by_partners(evidence, value, difference);
    if (std::isfinite(error)) walls.bar[i] = std::max({error, scatter, least_bar * base[i]});
  }
  walls.bar = with_neighbours(walls.bar);
  return walls;
}

bool has_bars(const Quantities& run) {
  return std::any_of(run.values.begin(), run.values.end(), [](const Quantity& q) { return std::isfinite(q.error); });
}

}  // namespace

double stated_scatter(const std::string& quantity) {
  // 1.65 times the largest root mean square of twins of cup, vial, tumbler and jar at draft (tests/difference_bars); of
  // the wall place by place that of tools/bench noise.
  static const std::vector<std::pair<std::string, double>> measured{
      {"thickness_profile", 0.015}, {"thickness_min_at", 0}, {"thickness", 0.0073}, {"heat", 0.0029}, {"glass", 0.0005},
      {"extent", 0.0011},           {"peak_force", 0.04},    {"time", 0.0045}};
  double largest = 0;
  for (const auto& [name, scatter] : measured) {
    if (quantity.rfind(name, 0) == 0) return scatter;
    largest = std::max(largest, scatter);
  }
  return largest;
}

const char* name_of(Significance significance) {
  constexpr std::array names{"real", "within its error", "no error bar"};
  return names[static_cast<std::size_t>(significance)];
}

Significance Difference::significance() const {
  if (!std::isfinite(bar)) return Significance::unknown;
  return std::abs(difference) > bar ? Significance::real : Significance::within_error;
}

RunComparison compare_runs(const FinishedRun& base, const FinishedRun& other, std::size_t may_agree, Repeats repeats) {
  RunComparison result;
  result.in_common = std::min(may_agree, stages_in_common(base, other));
  const Common common{result.in_common, repeats};
  const Evidence evidence = evidence_of(base, other, common);
  result.repeated = repeated_with(base, other, common);
  result.twins = evidence.twins.size();
  result.pairs = evidence.pairs.size();
  result.scatter = result.twins > 0 ? ScatterSource::twins : ScatterSource::stated;
  if (!evidence.partners.empty())
    result.bars = BarSource::differences;
  else if (has_bars(base.quantities) && has_bars(other.quantities))
    result.bars = BarSource::both_bars;
  for (const Quantity& quantity : base.quantities.values)
    if (const Quantity* same = other.quantities.find(quantity.name))
      result.quantities.push_back(compare_quantity(evidence, quantity, *same, result));
  result.profile = compare_walls(evidence, result);
  return result;
}

}  // namespace parison::forming
