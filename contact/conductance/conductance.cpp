// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/conductance/conductance.hpp"

#include <cassert>

namespace parison::contact {

namespace {

bool lies_on(const std::vector<double>& axis, double value) {
  return axis.front() <= value && value <= axis.back();
}

}  // namespace

bool TableConductance::clamps(double pressure_at, double viscosity_at) const {
  return !lies_on(pressure, pressure_at) || !lies_on(viscosity, viscosity_at);
}

ConductanceValue conductance(const ConductanceLaw& law, double pressure, double viscosity) {
  assert(viscosity > 0);
  using Variable = core::Dual<double, Eigen::Array2d>;  // derivatives with respect to pressure and viscosity
  const Variable p{std::max(pressure, 0.0), {1, 0}}, eta{viscosity, {0, 1}};
  const auto [h, derivative] = std::visit([&](const auto& l) { return l(p, eta); }, law);
  const auto* table = std::get_if<TableConductance>(&law);
  return {h, derivative[0], derivative[1], table && table->clamps(p.value, viscosity)};
}

double highest(const ConductanceLaw& law) {
  if (const auto* constant = std::get_if<ConstantConductance>(&law)) return constant->h;
  if (const auto* band = std::get_if<PressureViscosityConductance>(&law)) return std::max(band->h0, band->h1);
  const auto& table = std::get<TableConductance>(law).h;
  return *std::max_element(table.begin(), table.end());
}

}  // namespace parison::contact
