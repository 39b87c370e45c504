#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <vector>

namespace parison::forming {

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
