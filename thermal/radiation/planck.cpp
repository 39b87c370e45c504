// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/planck.hpp"

#include <cmath>

namespace parison::thermal {

namespace {

constexpr double second_constant = 1.438776877e-2;  ///< hc/k, m K
const double norm = 15 / std::pow(M_PI, 4);

constexpr double knot_distance = 4, last_knot = 3000;  ///< K

/// x^4/(e^x - 1), the part of the derivative that comes from the limits moving along the spectrum.
double moving_limit(double x) {
  return x > 700 ? 0 : x == 0 ? 0 : norm * std::pow(x, 4) / std::expm1(x);
}

/// Emissive power below a wavelength.
Emission emission_below(double wavelength, double T) {
  if (wavelength == 0 || T == 0) return {0, 0};
  const double cube = stefan_boltzmann * T * T * T;
  if (std::isinf(wavelength)) return {cube * T, 4 * cube};
  const double product = wavelength * T, fraction = planck_fraction(product);
  return {cube * T * fraction, cube * (4 * fraction + moving_limit(second_constant / product))};
}

}  // namespace

double planck_fraction(double wavelength_temperature) {
  if (!(wavelength_temperature > 0)) return 0;
  const double x = second_constant / wavelength_temperature;
  if (x > 700) return 0;
  if (x < 0.5) {
    const double y = x * x;
    const double series =
        1.0 / 3 - x / 8 + y * (1.0 / 60 + y * (-1.0 / 5040 + y * (1.0 / 272160 + y * (-1.0 / 13305600))));
    return 1 - norm * x * y * series;
  }
  double sum = 0;
  for (int n = 1; n <= 80; ++n) {
    const double term = std::exp(-n * x) / n * (x * x * x + 3 * x * x / n + 6 * x / (n * n) + 6.0 / (n * n * n));
    sum += term;
    if (term < 1e-17 * sum) break;
  }
  return norm * sum;
}

Emission emission_between(double from, double to, double temperature) {
  const double T = std::abs(temperature);
  const Emission low = emission_below(from, T), high = emission_below(to, T);
  return {std::copysign(high.value - low.value, temperature), high.derivative - low.derivative};
}

BandEmission::BandEmission(double from, double to) : from_(from), to_(to) {
  for (double T = 0; T <= last_knot; T += knot_distance) knots_.push_back(emission_between(from, to, T));
}

Emission BandEmission::operator()(double temperature) const {
  const double T = std::abs(temperature);
  if (!(T < last_knot)) return emission_between(from_, to_, temperature);
  const auto i = static_cast<std::size_t>(T / knot_distance);
  const double s = T / knot_distance - static_cast<double>(i), r = 1 - s;
  const Emission &a = knots_[i], &b = knots_[i + 1];
  const double value = r * r * ((1 + 2 * s) * a.value + s * knot_distance * a.derivative) +
                       s * s * ((3 - 2 * s) * b.value - r * knot_distance * b.derivative);
  const double derivative =
      6 * s * r * (b.value - a.value) / knot_distance + r * (1 - 3 * s) * a.derivative + s * (3 * s - 2) * b.derivative;
  return {std::copysign(value, temperature), derivative};
}

}  // namespace parison::thermal
