// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/accuracy_control.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "forming/scene/accuracy.hpp"

namespace parison::forming {
namespace {

/// Edges and steps of the first run in those of draft. It costs little beside the last one. Much coarser runs are
/// hardly worse any more, and their differences show too little.
constexpr double first_factor = 4;
/// How much finer the second run is; any other within the limits, after a failed one by the least.
constexpr double refinement = 1.8, least_refinement = 1.4, most_refinement = 2.3;
constexpr double aim = 0.95;  ///< of the target
constexpr std::size_t most_runs = 8;
constexpr double most_coarser = 4;  ///< of a run whose difference takes part in the error bars, where two others do
constexpr std::size_t least_coarser = 2;

// The errors of single runs scatter about c h^order by some 40 %, so neither an order that three runs show nor the
// difference of two of them can be trusted: the order is given, c is a mean over all pairs of runs, and the scatter is
// part of what their difference is expected to be. A pair of runs that are near each other shows little but scatter,
// which Richardson's estimate alone would multiply. Chosen by replaying stored runs of 17 scenes of tests/bars, 20
// factors of two programs each, at six targets from seven first runs, and by runs of these scenes; eleven others and
// random containers were left out of every choice. Other limits, orders and weights, a second run where the error
// asked for is expected and an order by its likelihood differ by no more than luck: what is left is the choice of the
// safety, which buys 2 % of the targets for each tenth of the cost.
constexpr double order = 1.5, scatter = 0.4;
constexpr double coarser_weight = 0.2;  ///< of a pair for each run that lies between its coarser one and the last
/// The estimate is larger by how little is known of the scatter: with two runs, three, or more of them.
constexpr std::array safety{2.4, 1.5, 1.3};

/// By how much a check exceeds what it may be where `target` is asked for; up to 1 it does not speak against the run.
double excess(const Check& check, double target) {
  const bool is_error = check.kind == CheckKind::error;
  const double allowed = is_error ? std::min(std::max(check.limit, target), check.severe_limit) : check.severe_limit;
  return std::isnan(check.value) ? std::numeric_limits<double>::infinity() : check.value / allowed;
}

double safe(std::size_t runs) {
  return safety[std::min(runs, safety.size() + 1) - 2];
}

}  // namespace

double difference_of_runs(const Quantities& run, const Quantities& reference) {
  const double wall = compare_profiles(run.profile, reference.profile).mean, heat = heat_difference(run, reference);
  if (std::isfinite(wall) || std::isfinite(heat)) return std::fmax(wall, heat);
  double largest = std::numeric_limits<double>::quiet_NaN();
  for (const Quantity& quantity : reference.values)
    if (const Quantity* other = run.find(quantity.name))
      largest = std::fmax(largest, std::abs(other->value - quantity.value) / quantity.scale);
  return largest;
}

AccuracyControl::AccuracyControl(double target) : record_{target, {}}, factor_(first_factor) {}

std::string AccuracyControl::accuracy() const {
  return fmt::format("draft coarser {:.4g}", factor_);
}

double AccuracyControl::likely_error() const {
  double squares = 0, weights = 0;
  for (auto fine = completed_.begin(); fine != completed_.end(); ++fine)
    for (auto coarse = completed_.begin(); coarse != fine; ++coarse) {
      const double larger = std::pow(coarse->factor, order), smaller = std::pow(fine->factor, order);
      const double law = larger - smaller, luck = scatter * std::hypot(larger, smaller);
      const double difference = difference_of_runs(coarse->quantities, fine->quantities);
      const double weight = std::pow(coarser_weight, double(completed_.end() - coarse - 2));
      squares += weight * difference * difference / (law * law + luck * luck);
      weights += weight;
    }
  return std::sqrt((1 + scatter * scatter) * squares / weights) * std::pow(completed_.back().factor, order);
}

bool AccuracyControl::mends(const Check& check, double now) const {
  if (check.kind == CheckKind::scene) return false;
  const auto before = excesses_.find(check.name);
  if (before == excesses_.end()) return true;
  const double finer = completed_.back().factor / factor_;
  const double order_seen = std::log(before->second / now) / std::log(finer);
  const std::size_t left = most_runs - std::min(most_runs, record_.runs.size());
  const double reach = std::min(std::pow(most_refinement, double(left)), factor_ / min_coarsening);
  return now <= std::pow(reach, order_seen);
}

void AccuracyControl::judge(const Checks& checks) {
  std::map<std::string, double> excesses;
  excess_ = 0;
  record_.not_mended.clear();
  for (const Check& check : checks)
    if (const double found = excess(check, record_.target); found > 1) {
      record_.runs.back().condemned_by.push_back(value_and_limit(check));
      if (!mends(check, found)) record_.not_mended.push_back(check.name);
      excesses[check.name] = found;
      excess_ = std::max(excess_, found);
    }
  excesses_ = std::move(excesses);
}

void AccuracyControl::add(const std::optional<Quantities>& run, double cpu_seconds, const Checks& checks) {
  record_.runs.push_back({factor_, cpu_seconds, run.has_value()});
  double next = factor_ / least_refinement;
  if (run) {
    judge(checks);
    completed_.push_back({factor_, *run, cpu_seconds});
    const std::size_t runs = completed_.size();
    if (runs == 1) next = factor_ / refinement;
    if (const double error = runs > 1 ? likely_error() : std::numeric_limits<double>::quiet_NaN();
        std::isfinite(error)) {
      record_.runs.back().estimate = safe(runs) * error;
      const double finer = std::max(safe(runs + 1) * error / (aim * record_.target), excess_);
      next = factor_ / std::clamp(std::pow(finer, 1 / order), least_refinement, most_refinement);
    }
  }
  if (!finished()) factor_ = std::max(next, min_coarsening);
}

std::vector<CoarserRun> AccuracyControl::coarser() const {
  std::vector<CoarserRun> runs;
  if (completed_.empty()) return runs;
  const double last = completed_.back().factor;
  for (std::size_t i = completed_.size() - 1; i-- > 0;)
    if (CoarserRun run = completed_[i]; runs.size() < least_coarser || run.factor <= most_coarser * last) {
      run.factor /= last;
      runs.push_back(std::move(run));
    }
  return runs;
}

bool AccuracyControl::finished() const {
  const bool near_enough = !record_.runs.empty() && record_.runs.back().estimate <= record_.target;
  return record_.reached() || (near_enough && !record_.not_mended.empty()) || record_.runs.size() >= most_runs ||
         (!record_.runs.empty() && factor_ / least_refinement < min_coarsening);
}

}  // namespace parison::forming
