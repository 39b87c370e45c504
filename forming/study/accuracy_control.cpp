// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/accuracy_control.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "forming/scene/accuracy.hpp"

namespace parison::forming {
namespace {

/// The search expects this error at draft, and its first run is this much coarser than where it expects to end.
/// Coarser than two and a half times draft errors hardly grow any more, and differences of such runs show too little.
constexpr double usual_error = 0.005, first_coarser = 3.2, coarsest = 2.5;
/// From the first run to the second, after a failed one, and at most where an estimate is larger than the one before
/// it: then it shows the scatter of runs that are near each other, which Richardson's estimate multiplies.
constexpr double refinement = 1.4;
constexpr double aim = 0.95;  ///< of the target
constexpr double most_refinement = 3, least_refinement = 1.2;
constexpr std::size_t most_runs = 8;
constexpr double most_coarser = 4;  ///< of a run whose difference takes part in the error bars, where two others do
constexpr std::size_t least_coarser = 2;

// The errors of single runs scatter about error = constant h^order by some 40 %, so neither an order that three runs
// show nor the difference of two of them can be trusted: the order is given, and the constant is a mean over all pairs
// of runs, larger by a part of the share by which those of the pairs scatter. Runs that are nearer to each other than
// the least refinement would show the scatter alone. Chosen by replaying stored runs of 17 scenes of tests/bars, 21
// factors each, at six targets from four first runs: 95 % are reached on the nine scenes on which the rest was chosen
// and 90 % on the others (91 and 87 % without scatter and with a least refinement of 1.1), at 6.2 times the cheapest
// run of a grid of factors in the median (6.1), all runs of the search together. With the whole scatter 99 and 91 %
// were reached, but single searches, run anew, took up to a thousand times the cheapest run (now a hundred). Who knew
// the law of each scene exactly would need 1.5 to 2.3 in the final run alone.
constexpr double order = 1.5;
constexpr double safety = 1.25, scatter_share = 0.35;
/// Two runs, which know nothing of their scatter, suffice where their estimate is within the target with the larger
/// factor of safety of a grid convergence index by two grids (P. J. Roache, Annu. Rev. Fluid Mech. 29 (1997) 123-160).
/// In a replay as above the eleven scenes of tests/bars without a part in the rule then cost 3.2 times the cheapest run
/// (4.7 with a third run in any case), the others the same, and as many reach their targets.
constexpr double safety_of_two = 3;
constexpr double coarser_weight = 0.25;  ///< of a pair for each run that lies between its coarser one and the last
constexpr std::size_t enough_runs = 3;

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
      factor_(std::clamp(first_coarser * std::pow(target / usual_error, 1 / order), min_coarsening, coarsest)) {}

std::string AccuracyControl::accuracy() const {
  return fmt::format("draft coarser {:.4g}", factor_);
}

double AccuracyControl::estimate() const {
  double sum = 0, squares = 0, weights = 0;
  for (auto fine = completed_.begin(); fine != completed_.end(); ++fine)
    for (auto coarse = completed_.begin(); coarse != fine; ++coarse) {
      const double constant = difference_of_runs(coarse->quantities, fine->quantities) /
                              (std::pow(coarse->factor, order) - std::pow(fine->factor, order));
      const double weight = std::pow(coarser_weight, double(completed_.end() - coarse - 2));
      sum += weight * constant;
      squares += weight * constant * constant;
      weights += weight;
    }
  const double mean = sum / weights, square = squares / weights;
  const double scatter = mean > 0 ? std::sqrt(std::max(0.0, square - mean * mean)) / mean : 0;
  return safety * (1 + scatter_share * scatter) * std::sqrt(square) * std::pow(completed_.back().factor, order);
}

void AccuracyControl::add(const std::optional<Quantities>& run, double cpu_seconds) {
  const double before = record_.runs.empty() ? std::numeric_limits<double>::infinity() : record_.runs.back().estimate;
  record_.runs.push_back({factor_, cpu_seconds, run.has_value()});
  ControlledRun& now = record_.runs.back();
  double finer = refinement;
  if (run) {
    completed_.push_back({factor_, *run, cpu_seconds});
    if (completed_.size() > 1) {
      now.estimate = estimate();
      now.confirmed = completed_.size() >= enough_runs || now.estimate * safety_of_two / safety <= record_.target;
      if (std::isfinite(now.estimate))
        finer = std::clamp(std::pow(now.estimate / (aim * record_.target), 1 / order), least_refinement,
                           now.estimate > before ? refinement : most_refinement);
    }
  }
  if (!finished()) factor_ /= finer;
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
  return record_.reached() || record_.runs.size() >= most_runs ||
         (!record_.runs.empty() && factor_ / least_refinement < min_coarsening);
}

}  // namespace parison::forming
