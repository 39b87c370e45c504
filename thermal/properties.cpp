// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/properties.hpp"

#include <algorithm>
#include <cmath>

namespace parison::thermal {

core::Table rosseland_absorption(const std::vector<Band>& bands) {
  constexpr double coldest = 300, hottest = 2000, apart = 50;  // K
  core::Table table;
  for (double T = coldest; T <= hottest; T += apart) {
    double conducted = 0, from = 0;
    for (const Band& band : bands) {
      const double absorption = band.absorption * (band.relative.x.empty() ? 1 : band.relative(T));
      conducted += emission_between(from, band.up_to, T).derivative / absorption;
      from = band.up_to;
    }
    table.x.push_back(T);
    table.y.push_back(4 * stefan_boltzmann * T * T * T / conducted);
  }
  return table;
}

bool absorption_varies(const Material& material) {
  const auto varies = [](const Band& band) { return !band.relative.x.empty(); };
  return has_light(material) && std::any_of(material.radiation->bands.begin(), material.radiation->bands.end(), varies);
}

double conductivity(const Material& material, double temperature, double thin_wall) {
  return Conductivity(material)(temperature, thin_wall);
}

Conductivity::Conductivity(const Material& material) : phonon_(material.conductivity) {
  if (!is_rosseland(material)) return;
  const double n = material.radiation->refractive_index;
  radiant_ = 16.0 / 3 * n * n * stefan_boltzmann / material.radiation->absorption;
  relative_ = material.radiation->relative;
}

void Conductivity::add_varying(const PointValues& temperature, const PointValues& thin_wall,
                               PointValues& values) const {
  for (int q = 0; q < 6; ++q)
    for (int lane = 0; lane < batch_size; ++lane) {
      double radiant = 0;
      add_radiant(temperature[q][lane], thin_wall[q][lane], radiant);
      values[q][lane] += radiant;
    }
}

void Conductivity::add_varying_derivatives(const PointValues& temperature, const PointValues& thin_wall,
                                           PointValues& derivatives) const {
  for (int q = 0; q < 6; ++q)
    for (int lane = 0; lane < batch_size; ++lane) {
      const double T = core::positive_part(double(temperature[q][lane]));
      const double depth = relative_(T) + added_depth(thin_wall[q][lane]);
      derivatives[q][lane] += radiant_ * T * T * (3 - T * relative_.derivative(T) / depth) / depth;
    }
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
