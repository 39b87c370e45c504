// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/conductance/conductance.hpp"

#include <cassert>

namespace parison::contact {

namespace {

bool lies_on(const std::vector<double>& axis, double value) {
  return axis.front() <= value && value <= axis.back();
}

// One for each law: a new one without its own does not compile.
double highest_of(const ConstantConductance& law) {
  return law.h;
}

double highest_of(const PressureViscosityConductance& law) {
  return std::max(law.h0, law.h1);
}

double highest_of(const TableConductance& law) {
  return *std::max_element(law.h.begin(), law.h.end());
}

double highest_of(const GapConductance& law) {
  constexpr double coldest_gas = 600;  // K; hotter gas conducts less across a gap shorter than some free paths
  return law.at_opening(0, coldest_gas, coldest_gas);
}

}  // namespace

bool TableConductance::clamps(double pressure_at, double viscosity_at) const {
  return !lies_on(pressure, pressure_at) || !lies_on(viscosity, viscosity_at);
}

double GapConductance::opening_after(double opening, double closing_rate, double time) const {
  const double rate = 1 / opening_time + closing_rate;
  const double settled = (open_gap - touch_gap) / (opening_time * rate);
  return opening - (settled - opening) * std::expm1(-rate * time);
}

ConductanceValue conductance(const ConductanceLaw& law, double pressure, double viscosity) {
  assert(viscosity > 0);
  const core::Dual<double> p{std::max(pressure, 0.0), 0}, eta{viscosity, 1};
  const auto [h, derivative] = std::visit([&](const auto& l) { return l(p, eta); }, law);
  const auto* table = std::get_if<TableConductance>(&law);
  return {h, derivative, table && table->clamps(p.value, viscosity)};
}

double highest(const ConductanceLaw& law) {
  return std::visit([](const auto& l) { return highest_of(l); }, law);
}

}  // namespace parison::contact
