// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/error_bars.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/math/numbers.hpp"

namespace parison::forming {
namespace {

/// Share of the usual bar of its kind that a temperature or a heat gets at least.
constexpr double of_usual = 0.7;
/// No bar is narrower: share of size_of_kind.
constexpr double resolution = 1e-4;
constexpr double spacing = 1.0 / (profile_points - 1);
bool is_heat(const Quantity& quantity) {
  return quantity.name.rfind("heat_", 0) == 0;
}

/// Quantities that one balance of heat ties together share their errors; empty for others.
std::string balance(const Quantity& quantity) {
  const std::string kind = quantity.name.substr(0, quantity.name.find('_'));
  return kind == "heat" || kind == "glass" ? kind : "";
}

/// The bar of a quantity by the runs that have it; NaN where the run itself is the only one.
double bar_of(const Quantity& quantity, const std::vector<CoarserRun>& coarser) {
  std::vector<ValueOfRun> values{{1, quantity.value}};
  for (const CoarserRun& run : coarser)
    if (const Quantity* other = run.quantities.find(quantity.name)) values.push_back({run.factor, other->value});
  return bar_of_values(values);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

/// The usual bars of temperatures and of heats, as shares of the size of their kind.
std::map<std::string, double> usual_bars(const Quantities& run) {
  std::map<std::string, std::vector<double>> shares;
  for (const Quantity& quantity : run.values)
    if (!balance(quantity).empty() && std::isfinite(quantity.error))
      shares[balance(quantity)].push_back(quantity.error / size_of_kind(run, quantity));
  std::map<std::string, double> usual;
  for (const auto& [kind, values] : shares) usual[kind] = median(values);
  return usual;
}

/// The place of the thinnest wall is uncertain over the points that are as thin to within the bar of the thickness.
void widen_place_of_min(Quantities& run) {
  const Quantity* thickness = run.find("thickness_min");
  if (!thickness || !std::isfinite(thickness->error)) return;
  for (Quantity& quantity : run.values) {
    if (quantity.name != "thickness_min_at") continue;
    const int at = static_cast<int>(std::lround(quantity.value / spacing));
    int farthest = 0;
    for (int i = 0; i < profile_points; ++i)
      if (run.profile[i] <= thickness->value + thickness->error) farthest = std::max(farthest, std::abs(i - at));
    quantity.error = std::max(quantity.error, (farthest + 1) * spacing);
  }
}

/// The largest of the estimates by the coarser runs, wider where only one is finite; NaN where none is.
double largest(const std::vector<double>& estimates) {
  double bar = core::none;
  for (const double estimate : estimates) bar = std::fmax(bar, estimate);
  const auto finite = std::count_if(estimates.begin(), estimates.end(), [](double e) { return std::isfinite(e); });
  return finite == 1 ? single_run_factor * bar : bar;
}

/// The bar of a measure of difference; NaN where no coarser run has it.
template <typename Difference>
double bar_by(const Quantities& run, const std::vector<CoarserRun>& coarser, const Difference& difference) {
  std::vector<double> estimates;
  for (const CoarserRun& one : coarser)
    estimates.push_back(richardson_estimate(difference(one.quantities, run), 1, one.factor));
  const double bar = largest(estimates);
  return std::isfinite(bar) ? std::max(bar, resolution) : core::none;
}

}  // namespace

double richardson_estimate(double difference, double fine, double coarse, double order) {
  return std::abs(difference / (std::pow(coarse, order) - std::pow(fine, order)));
}

double bar_of_values(const std::vector<ValueOfRun>& values) {
  std::vector<double> estimates;
  for (std::size_t i = 1; i < values.size(); ++i)
    estimates.push_back(
        richardson_estimate(values[i].value - values.front().value, values.front().factor, values[i].factor));
  double bar = largest(estimates);
  for (std::size_t i = 2; i < values.size(); ++i) {
    const ValueOfRun& one = values[i];
    const ValueOfRun &before = values[i - 1], &earlier = values[i - 2];
    const bool turns = (one.value - before.value) * (before.value - earlier.value) < 0;
    if (turns) bar = std::fmax(bar, richardson_estimate(one.value - before.value, before.factor, one.factor));
  }
  return bar;
}

double size_of_kind(const Quantities& run, const Quantity& quantity) {
  if (!is_heat(quantity)) return quantity.scale;
  double whole = 0;
  for (const Quantity& other : run.values)
    if (is_heat(other)) whole += other.scale;
  return std::sqrt(quantity.scale * whole);
}

ErrorBars error_bars(const Quantities& run, std::vector<CoarserRun> coarser) {
  ErrorBars bars{run, 0, 0, 0, std::move(coarser), {}};
  for (Quantity& quantity : bars.quantities.values) quantity.error = bar_of(quantity, bars.coarser);
  const auto usual = usual_bars(bars.quantities);
  for (Quantity& quantity : bars.quantities.values) {
    const double size = size_of_kind(run, quantity);
    const auto alike = usual.find(balance(quantity));
    if (std::isfinite(quantity.error))
      quantity.error =
          std::max({quantity.error, resolution * size, alike == usual.end() ? 0 : of_usual * alike->second * size});
  }
  widen_place_of_min(bars.quantities);
  bars.profile_mean = bar_by(run, bars.coarser, [](const Quantities& a, const Quantities& b) {
    return compare_profiles(a.profile, b.profile).mean;
  });
  bars.profile_max = bar_by(run, bars.coarser, [](const Quantities& a, const Quantities& b) {
    return compare_profiles(a.profile, b.profile).max;
  });
  bars.heat = bar_by(run, bars.coarser, heat_difference);
  return bars;
}

}  // namespace parison::forming
