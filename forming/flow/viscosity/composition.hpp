#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <map>
#include <string>

#include "forming/flow/material.hpp"

namespace parison::flow {

/// Shares of the oxides of a glass by mass, 0 to 1, by their names such as "Na2O".
using Composition = std::map<std::string, double>;

/// An oxide of the model of composition, and the shares by mass that its glasses had.
struct OxideRange {
  const char* name;
  double least, most;
};
/// The oxides and their ranges, SiO2 first.
const std::array<OxideRange, 11>& oxide_ranges();

/// Temperatures, K, at which a glass has a viscosity of 10, 1e3 and 1e5 Pa.s: T. Lakatos, L.-G. Johansson,
/// B. Simmingskoeld, Glasteknisk Tidskrift 31 (1976) 31-35, linear in the parts of each oxide by mass for 100 parts of
/// SiO2, with a square of B2O3. Standard deviation over its 44 glasses 4.6, 3.3 and 3.1 K.
std::array<double, 3> isokom_temperatures(const Composition& composition);

/// The law of Vogel, Fulcher and Tammann through these three points.
Viscosity viscosity_of(const Composition& composition);

/// The law through three points, temperatures in K and log10 of the viscosity in Pa.s, the hottest first.
Viscosity vft_through(const std::array<double, 3>& temperature, const std::array<double, 3>& log10_viscosity);

}  // namespace parison::flow
