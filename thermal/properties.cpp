// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/properties.hpp"

#include <cmath>

namespace parison::thermal {

double conductivity(const Material& material, double temperature, double thin_wall) {
  return Conductivity(material)(temperature, thin_wall);
}

Conductivity::Conductivity(const Material& material) : phonon_(material.conductivity) {
  if (!is_rosseland(material)) return;
  const double n = material.radiation->refractive_index;
  radiant_ = 16.0 / 3 * n * n * stefan_boltzmann / material.radiation->absorption;
}

Enthalpy::Enthalpy(const core::Table& heat_capacity) : capacity_(heat_capacity) {
  const double reference = heat_capacity.integral(content_reference);
  for (const double T : capacity_.x) at_knot_.push_back(heat_capacity.integral(T) - reference);
}

EnthalpyValue Enthalpy::operator()(double temperature) const {
  const auto& [x, c] = capacity_;
  if (!(temperature < x.back())) return {at_knot_.back() + c.back() * (temperature - x.back()), c.back()};
  if (temperature <= x.front()) return {at_knot_.front() + c.front() * (temperature - x.front()), c.front()};
  const auto i = std::upper_bound(x.begin(), x.end(), temperature) - x.begin() - 1;
  const double past = temperature - x[i];
  const double here = c[i] + (c[i + 1] - c[i]) * past / (x[i + 1] - x[i]);
  return {at_knot_[i] + 0.5 * (c[i] + here) * past, here};
}

SurfaceFlux surface_flux(const ExchangeCoefficients& exchange, double temperature) {
  const double radiant = exchange.emissivity * stefan_boltzmann, a = exchange.ambient_temperature;
  const double cube = std::abs(temperature) * temperature * temperature;  // |T|^3 T rises everywhere
  return {exchange.h * (temperature - exchange.air_temperature) + radiant * (cube * temperature - a * a * a * a),
          exchange.h + 4 * radiant * cube};
}

}  // namespace parison::thermal
