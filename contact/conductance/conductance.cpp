// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/conductance/conductance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace parison::contact {

namespace {

/// Place of a value on a logarithmic axis: between entries `low` and `high`, at `weight` from low to high.
struct AxisPlace {
  std::size_t low, high;
  double weight, derivative;  ///< slope = d weight / d value, 0 where an end is held
  bool outside;
};

AxisPlace find_place(const std::vector<double>& axis, double value) {
  assert(!axis.empty());
  const std::size_t last = axis.size() - 1;
  if (value < axis.front()) return {0, 0, 0, 0, true};
  if (value > axis.back()) return {last, last, 0, 0, true};
  if (last == 0) return {0, 0, 0, 0, false};
  const auto above = std::upper_bound(axis.begin() + 1, axis.end() - 1, value);
  const std::size_t high = above - axis.begin();
  const double span = std::log(axis[high] / axis[high - 1]);
  return {high - 1, high, std::log(value / axis[high - 1]) / span, 1 / (value * span), false};
}

ConductanceValue evaluate(const ConstantConductance& law, double, double) {
  return {law.h, 0, 0};
}

ConductanceValue evaluate(const PressureViscosityConductance& law, double pressure, double viscosity) {
  if (pressure <= 0 && law.a > 0) return {law.h0, 0, 0};
  // One exponential: this is evaluated at every point of the interface in every residual.
  const double relative_pressure = pressure / law.p_ref, stiff = law.b * std::log(law.eta_ref / viscosity);
  const double x = law.a == 0   ? std::exp(stiff)
                   : law.a == 1 ? relative_pressure * std::exp(stiff)
                                : std::exp(law.a * std::log(relative_pressure) + stiff);
  const double fraction = x < 1 ? x / (1 + x) : 1 / (1 + 1 / x);
  const double h = law.h0 + (law.h1 - law.h0) * fraction;
  const double dh_dlogx = (law.h1 - law.h0) * fraction / (1 + x);
  return {h, law.a == 0 ? 0 : dh_dlogx * law.a / pressure, -dh_dlogx * law.b / viscosity};
}

ConductanceValue evaluate(const TableConductance& law, double pressure, double viscosity) {
  const AxisPlace p = find_place(law.pressure, pressure), e = find_place(law.viscosity, viscosity);
  const auto entry = [&](std::size_t i, std::size_t j) { return law.h[i * law.viscosity.size() + j]; };
  const double low = entry(p.low, e.low) + e.weight * (entry(p.low, e.high) - entry(p.low, e.low));
  const double high = entry(p.high, e.low) + e.weight * (entry(p.high, e.high) - entry(p.high, e.low));
  const double thin = entry(p.low, e.low) + p.weight * (entry(p.high, e.low) - entry(p.low, e.low));
  const double thick = entry(p.low, e.high) + p.weight * (entry(p.high, e.high) - entry(p.low, e.high));
  return {low + p.weight * (high - low), p.derivative * (high - low), e.derivative * (thick - thin),
          p.outside || e.outside};
}

}  // namespace

ConductanceValue conductance(const ConductanceLaw& law, double pressure, double viscosity) {
  assert(viscosity > 0);
  return std::visit([&](const auto& l) { return evaluate(l, std::max(pressure, 0.0), viscosity); }, law);
}

double highest(const ConductanceLaw& law) {
  if (const auto* constant = std::get_if<ConstantConductance>(&law)) return constant->h;
  if (const auto* band = std::get_if<PressureViscosityConductance>(&law)) return std::max(band->h0, band->h1);
  const auto& table = std::get<TableConductance>(law).h;
  return *std::max_element(table.begin(), table.end());
}

}  // namespace parison::contact
