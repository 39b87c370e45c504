// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/accuracy_control.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "forming/scene/accuracy.hpp"

namespace parison::forming {
namespace {

// These were chosen on model errors c h^q, with q from 1.2 to 2.6, c over a factor of twenty, scatter, and chance above
// 4 %, not on scenes: 90 % reached the target, at 2.8 times the cost of the cheapest run in the median.

/// The search expects this error at draft, and its first run is this much coarser than where it expects to end.
constexpr double usual_error = 0.005, first_coarser = 3;
constexpr double refinement = 2;  ///< from the first run to the second, and after a failed one
constexpr double usual_order = 1.6, min_order = 1, max_order = 2.5;
constexpr double aim = 0.75;  ///< of the target
constexpr double most_refinement = 2.5, least_refinement = 1.2;
constexpr std::size_t most_runs = 7;
constexpr double most_coarser = 4;  ///< of a run whose difference takes part in the error bars

/// The share of the error that a refinement from `coarse` to `fine` leaves over what it takes.
double left_over_taken(double coarse, double fine, double order) {
  return 1 / (std::pow(coarse / fine, order) - 1);
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

AccuracyControl::AccuracyControl(double target)
    : record_{target, {}},
      factor_(std::clamp(first_coarser * std::pow(target / usual_error, 1 / usual_order), min_coarsening,
                         max_coarsening)) {}

std::string AccuracyControl::accuracy() const {
  return fmt::format("draft coarser {:.4g}", factor_);
}

/// The order that the last three runs show.
double AccuracyControl::order() const {
  if (!(before_difference_ > 0)) return usual_order;
  const double ratio = before_difference_ / record_.runs.back().difference;
  const auto shown = [&](double order) {
    return (std::pow(before_factor_, order) - std::pow(partner_factor_, order)) /
           (std::pow(partner_factor_, order) - std::pow(last_factor_, order));
  };
  double low = min_order, high = max_order;
  if (!(ratio > shown(low))) return low;
  if (ratio > shown(high)) return high;
  for (int i = 0; i < 40; ++i) (shown(0.5 * (low + high)) < ratio ? low : high) = 0.5 * (low + high);
  return low;
}

void AccuracyControl::add(const std::optional<Quantities>& run, double cpu_seconds) {
  record_.runs.push_back({factor_, cpu_seconds, run.has_value()});
  ControlledRun& now = record_.runs.back();
  double finer = refinement;
  if (run) {
    completed_.push_back({factor_, *run, cpu_seconds});
    before_factor_ = std::exchange(partner_factor_, std::exchange(last_factor_, factor_));
    partner_ = std::exchange(last_, run);
    if (partner_) {
      now.difference = difference_of_runs(*partner_, *last_);
      const double p = order();
      now.estimate = now.difference * left_over_taken(partner_factor_, last_factor_, p);
      finer = std::clamp(std::pow(now.estimate / (aim * record_.target), 1 / p), least_refinement, most_refinement);
      before_difference_ = now.difference;
    }
  }
  if (!finished()) factor_ /= finer;
}

std::vector<CoarserRun> AccuracyControl::coarser() const {
  std::vector<CoarserRun> runs;
  if (completed_.empty()) return runs;
  const double last = completed_.back().factor;
  for (std::size_t i = completed_.size() - 1; i-- > 0;)
    if (CoarserRun run = completed_[i]; runs.empty() || run.factor <= most_coarser * last) {
      run.factor /= last;
      runs.push_back(std::move(run));
    }
  return runs;
}

bool AccuracyControl::finished() const {
  return record_.reached() || record_.runs.size() >= most_runs ||
         (!record_.runs.empty() && factor_ / least_refinement < min_coarsening);
}

}  // namespace parison::forming
