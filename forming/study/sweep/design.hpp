#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <string>
#include <vector>

#include "core/case/case_file.hpp"

namespace parison::forming {

/// A number with the unit that it was given in; plain numbers have none.
struct Measured {
  double value;
  std::string unit;
};

/// Reads "440 degC" or a plain number; refuses anything else.
Measured read_measured(const core::CaseNode& node);

/// As a case takes it, "440 degC".
std::string measure_text(double value, const std::string& unit);

/// The values of a variable, `from` below `to`.
struct Bounds {
  double from, to;
  std::string unit;
};

/// Reads `from` and `to` of a table; refuses bounds the wrong way round or in two units.
Bounds read_bounds(const core::CaseTable& table);

/// Points of a design of experiments, one a row; a member is the share of the way through the values of a variable, at
/// least 0 and below 1.
using DesignPoints = std::vector<std::vector<double>>;

/// The most variables that a Sobol sequence is made for.
inline constexpr std::size_t max_sobol_dimensions = 3667;

/// Latin hypercube (M. D. McKay, R. J. Beckman, W. J. Conover, Technometrics 21 (1979) 239-245): each of `runs` equal
/// parts of each variable has one point, anywhere in it. The same seed gives the same points on every machine.
DesignPoints latin_hypercube(std::size_t variables, std::size_t runs, std::uint64_t seed);

/// The first points behind the origin of Sobol's sequence, by Boost.Random with 64 bits; more runs begin with the
/// points of fewer. A seed other than 0 shifts all points by the same random bits of each variable (digital shift),
/// which keeps how evenly they lie.
DesignPoints sobol_sequence(std::size_t variables, std::size_t runs, std::uint64_t seed);

/// All combinations of so many levels of each variable as numbers of the levels, the last one changing fastest.
std::vector<std::vector<std::size_t>> full_grid(const std::vector<std::size_t>& levels);

}  // namespace parison::forming
