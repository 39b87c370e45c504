#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

namespace parison::core {

/// What a number is where there is nothing to measure.
inline constexpr double none = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double millimetre = 1e-3;                  ///< m
inline constexpr double millilitre = 1e-6;                  ///< m3
inline constexpr double bar = 1e5;                          ///< Pa
inline constexpr double zero_celsius = 273.15;              ///< K
inline constexpr double room_temperature = 293.15;          ///< K
inline constexpr double heat_ratio_of_air = 1.4;            ///< cp/cv
inline constexpr double stefan_boltzmann = 5.670374419e-8;  ///< W/m2/K4

/// Share of a value below which a difference of it is what operations left.
inline constexpr double round_off = 1e-9;
/// Times closer than this are one, s.
inline constexpr double same_time = 1e-9;

}  // namespace parison::core
