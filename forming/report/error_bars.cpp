// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/error_bars.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "forming/scene/accuracy.hpp"
#include "forming/scene/calibration.hpp"

namespace parison::forming {
namespace {

/// Half width of the interval that contains 90 % of a normal distribution, in standard deviations.
constexpr double scatter = 1.64;
/// No bar is narrower: share of size_of_kind.
constexpr double resolution = 1e-4;
constexpr double neighbourhood = 0.1;  ///< of the arc
constexpr double spacing = 1.0 / (profile_points - 1);

/// From the difference of both runs to the error of the finer one, by the order that the convergence study of the
/// presets showed.
double richardson(double factor) {
  return 1 / (std::pow(factor, calibration().error_law.thickness.order) - 1);
}

bool is_heat(const Quantity& quantity) {
  return quantity.name.rfind("heat_", 0) == 0;
}

bool is_time(const Quantity& quantity) {
  return quantity.name.rfind("time_", 0) == 0;
}

/// What a quantity is alike with: the first word of its name.
std::string kind(const Quantity& quantity) {
  return quantity.name.substr(0, quantity.name.find('_'));
}

bool is_min_thickness(const Quantity& quantity) {
  return quantity.name.rfind("thickness_min", 0) == 0;
}

/// The differences of a kind are alike as shares of this. Heats: between its own, of which the mesh and the steps get a
/// share wrong, and all of it, as what one tool gets too much another lacks.
double size_of_kind(const Quantities& run, const Quantity& quantity) {
  if (!is_heat(quantity)) return quantity.scale;
  double whole = 0;
  for (const Quantity& other : run.values)
    if (is_heat(other)) whole += other.scale;
  return std::sqrt(quantity.scale * whole);
}

/// The scatter of differences, as shares: from three on by their median, so that one that stands out does not widen all
/// bars; of two the larger, as the other may have vanished by chance.
struct Usual {
  std::vector<double> sizes;
  double scatter() const {
    constexpr double of_median = 1.48;  // of a normal scatter
    const std::size_t count = sizes.size();
    if (count < 3) return *std::max_element(sizes.begin(), sizes.end());
    std::vector<double> sorted = sizes;
    std::sort(sorted.begin(), sorted.end());
    return of_median * 0.5 * (sorted[(count - 1) / 2] + sorted[count / 2]);
  }
};

/// Differences of each kind, as shares.
std::map<std::string, Usual> usual_differences(const Quantities& run, const Quantities& coarse_run) {
  std::map<std::string, Usual> usual;
  for (const Quantity& quantity : run.values)
    if (const Quantity* other = coarse_run.find(quantity.name); other && !is_min_thickness(quantity))
      usual[kind(quantity)].sizes.push_back(std::abs(other->value - quantity.value) / size_of_kind(run, quantity));
  return usual;
}

/// How far the mean of the profile may be off: its difference wavers, and each wave adds by chance.
double chance_of_mean(const Quantities& run, const Quantities& coarse_run) {
  double square = 0, last = 0;
  int count = 0, waves = 1;
  for (std::size_t i = 0; i < run.profile.size() && i < coarse_run.profile.size(); ++i) {
    const double difference = coarse_run.profile[i] - run.profile[i];
    if (!std::isfinite(difference)) continue;
    waves += last * difference < 0;
    if (difference != 0) last = difference;
    square += difference * difference;
    ++count;
  }
  return count ? std::sqrt(square / count / waves) : 0;
}

/// A wall ends at one node or at the next: change of the mean by one point more or less at each end of a part, mm.
double step_of_mean(const Quantities& run, double mean) {
  double square = 0;
  int count = 0;
  for (std::size_t i = 0; i + 1 < run.profile.size(); ++i) {
    const double here = run.profile[i], next = run.profile[i + 1];
    count += std::isfinite(here);
    if (std::isfinite(here) != std::isfinite(next)) square += std::pow((std::isfinite(here) ? here : next) - mean, 2);
  }
  return count ? std::sqrt(square) / count : 0;
}

/// Usual error of the wall thickness near a point of the profile, mm.
double usual_near(const std::vector<double>& profile, const std::vector<double>& other, int at) {
  const int reach = static_cast<int>(std::lround(neighbourhood / spacing));
  double square = 0;
  int count = 0;
  for (int i = std::max(0, at - reach); i <= std::min(profile_points - 1, at + reach); ++i)
    if (const double difference = profile[i] - other[i]; std::isfinite(difference))
      square += difference * difference, ++count;
  return count ? std::sqrt(square / count) : 0;
}

/// The thinnest wall and its position, uncertain over the points that are as thin to within the error of the thickness.
void add_min_thickness(Quantities& run, const Quantities& coarse_run, double remainder) {
  double error = 0;
  for (Quantity& quantity : run.values) {
    if (!is_min_thickness(quantity) || coarse_run.profile.empty()) continue;
    if (quantity.name == "thickness_min") {
      const int at = static_cast<int>(std::lround(run.find("thickness_min_at")->value / spacing));
      const Quantity* other = coarse_run.find(quantity.name);
      const double own = other ? std::abs(other->value - quantity.value) : 0;
      error = remainder * std::max(own, usual_near(run.profile, coarse_run.profile, at));
      quantity.error = error = std::max(error, resolution * quantity.scale);
      continue;
    }
    const int at = static_cast<int>(std::lround(quantity.value / spacing));
    int farthest = 0;
    for (int i = 0; i < profile_points; ++i)
      if (run.profile[i] <= run.profile[at] + error) farthest = std::max(farthest, std::abs(i - at));
    quantity.error = (farthest + 1) * spacing;
  }
}

}  // namespace

ErrorBars error_bars(const Quantities& run, const Quantities& coarse_run, const ExpectedErrors& expected,
                     double factor) {
  ErrorBars bars{run, 0, 0, 0, 0, factor, {}};
  const double remainder = richardson(factor);
  auto usual = usual_differences(run, coarse_run);
  for (Quantity& quantity : bars.quantities.values) {
    const Quantity* other = coarse_run.find(quantity.name);
    if (!other || is_min_thickness(quantity)) continue;
    const double size = size_of_kind(run, quantity);
    const Usual& alike = usual[kind(quantity)];
    // What is usual bounds a chance agreement of two runs; it is scatter, which a finer run has less of but not by the
    // order.
    const double chance = quantity.name == "thickness_mean" ? remainder * std::hypot(chance_of_mean(run, coarse_run),
                                                                                     step_of_mean(run, quantity.value))
                                                            : alike.scatter() * size;
    quantity.error = std::max({remainder * std::abs(other->value - quantity.value), chance, resolution * size});
    if (is_heat(quantity))
      quantity.error = std::max(quantity.error, scatter * expected.heat / double(alike.sizes.size()) * size);
    if (is_time(quantity))
      quantity.error = std::max(quantity.error, calibration().error_bars.chance_in_time * expected.thickness * size);
  }
  add_min_thickness(bars.quantities, coarse_run, remainder);
  const ProfileDifference profile = compare_profiles(coarse_run.profile, run.profile);
  // Not a number where there is no wall, or no tool receives heat.
  bars.profile_mean =
      std::max({remainder * profile.mean, calibration().error_bars.chance_in_mean * expected.thickness, resolution});
  bars.profile_max =
      std::max({remainder * profile.max, calibration().error_bars.chance_at_worst * expected.thickness, resolution});
  bars.heat = std::max({remainder * heat_difference(coarse_run, run), scatter * expected.heat, resolution});
  return bars;
}

}  // namespace parison::forming
