// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/air/air_pocket.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/numbers.hpp"

namespace parison::flow {

namespace {

constexpr double gamma = core::heat_ratio_of_air;
constexpr double least_volume = 1e-4;  ///< of that at the step's start: above it the law itself holds

/// Flow function of the nozzle over the ratio x of the pressures, at most 1.
ValueAndSlope flow_function(double x) {
  constexpr double linear = 1e-3;
  static const double critical = std::pow(2 / (gamma + 1), gamma / (gamma - 1));
  const auto subsonic = [](double ratio) {
    const double a = 2 / gamma, b = (gamma + 1) / gamma, factor = 2 * gamma / (gamma - 1);
    const double value = std::sqrt(factor * (std::pow(ratio, a) - std::pow(ratio, b)));
    return ValueAndSlope{value, factor * (a * std::pow(ratio, a - 1) - b * std::pow(ratio, b - 1)) / (2 * value)};
  };
  if (x <= critical) return {subsonic(critical).value, 0};
  if (x < 1 - linear) return subsonic(x);
  static const double slope = subsonic(1 - linear).value / linear;
  return {slope * (1 - x), -slope};
}

/// Pressure that satisfies p V + n dt outflow(p) = energy: a bracketed Newton iteration.
double pressure_with_vent(const AirPocket& pocket, double ambient, double dt, double volume, double energy) {
  double low = std::min(ambient, energy / volume), high = std::max(ambient, energy / volume), p = high;
  for (int i = 0; i < 100 && high - low > 1e-14 * high; ++i) {
    const auto outflow = vent_outflow(pocket.vent, p, ambient);
    const double excess = p * volume + pocket.exponent * dt * outflow.value - energy;
    (excess > 0 ? high : low) = p;
    p -= excess / (volume + pocket.exponent * dt * outflow.slope);
    if (!(p > low && p < high)) p = 0.5 * (low + high);
  }
  return p;
}

}  // namespace

ValueAndSlope vent_outflow(double vent, double inside, double ambient) {
  if (inside >= ambient) {
    const double x = ambient / inside;
    const auto flow = flow_function(x);
    return {vent * inside * flow.value, vent * (flow.value - x * flow.slope)};
  }
  const auto flow = flow_function(inside / ambient);
  return {-vent * ambient * flow.value, -vent * flow.slope};
}

ValueAndSlope pressure_at(const AirPocket& pocket, double ambient, double dt, double volume) {
  if (const double floor = least_volume * pocket.volume; volume < floor) {
    const auto there = pressure_at(pocket, ambient, dt, floor);
    return {there.value + (volume - floor) * there.slope, there.slope};
  }
  const double n = pocket.exponent, energy = pocket.energy * std::pow(pocket.volume / volume, n - 1);
  const bool vented = pocket.vent > 0 && dt > 0;
  const double p = vented ? pressure_with_vent(pocket, ambient, dt, volume, energy) : energy / volume;
  const double outflow_slope = vented ? vent_outflow(pocket.vent, p, ambient).slope : 0;
  return {p, -(p + (n - 1) * energy / volume) / (volume + n * dt * outflow_slope)};
}

}  // namespace parison::flow
