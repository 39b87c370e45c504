#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/math/numbers.hpp"

namespace parison::thermal {

using core::stefan_boltzmann;

/// Fraction of a black body's emissive power at wavelengths, in vacuum, below the one of this product of wavelength and
/// temperature, m K: the series of S. L. Chang, K. T. Rhee, Int. Commun. Heat Mass Transf. 11 (1984) 451-455, and for
/// large products the power series of the integrand.
double planck_fraction(double wavelength_temperature);

/// Emissive power and its derivative with respect to temperature.
struct Emission {
  double value;       ///< W/m2
  double derivative;  ///< W/m2/K
};

/// Emissive power of a black body in vacuum between two wavelengths, m, at a temperature, K, by the series. Odd in the
/// temperature, so that it rises everywhere.
Emission emission_between(double from, double to, double temperature);

/// The same, prepared for many evaluations: cubic Hermite polynomials between exact values, so that value and
/// derivative belong together.
class BandEmission {
 public:
  /// `to` may be infinite.
  BandEmission(double from, double to);
  Emission operator()(double temperature) const;
  double value(double temperature) const { return (*this)(temperature).value; }

 private:
  double from_, to_;
  std::vector<Emission> knots_;
};

}  // namespace parison::thermal
