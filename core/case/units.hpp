#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <string_view>

#include "core/math/numbers.hpp"

namespace parison::core {

/// Exponents of m, kg, s and K. `absolute` marks a temperature that may be given in degC, `heat` a heat on an area,
/// which has the exponents of a surface tension and is called otherwise.
struct Dimension {
  int length = 0, mass = 0, time = 0, temperature = 0;
  bool absolute = false, heat = false;
};

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension length{1};
inline constexpr Dimension inverse_length{-1};
inline constexpr Dimension area{2};
inline constexpr Dimension volume{3};
inline constexpr Dimension time{0, 0, 1};
inline constexpr Dimension frequency{0, 0, -1};
inline constexpr Dimension speed{1, 0, -1};
inline constexpr Dimension acceleration{1, 0, -2};
inline constexpr Dimension temperature{0, 0, 0, 1, true};
inline constexpr Dimension temperature_difference{0, 0, 0, 1};
inline constexpr Dimension density{-3, 1};
inline constexpr Dimension force{1, 1, -2};
inline constexpr Dimension pressure{-1, 1, -2};
inline constexpr Dimension viscosity{-1, 1, -1};
inline constexpr Dimension surface_tension{0, 1, -2};
inline constexpr Dimension heat_per_area{0, 1, -2, 0, false, true};
inline constexpr Dimension friction{-2, 1, -1};
inline constexpr Dimension heat_capacity{2, 0, -2, -1};
inline constexpr Dimension conductivity{1, 1, -3, -1};
inline constexpr Dimension conductance{0, 1, -3, -1};
}  // namespace dimension

/// A quantity in SI, or a sentence part that says what was found and what is allowed.
struct ParsedQuantity {
  double value = 0;
  std::string problem;  ///< empty when the text was understood
};

/// Reads "2.5 mm", "0.35 bar", "1.3 W/m/K", "20 %"; a bare number only where no dimension is asked for. The value is
/// finite and at most `largest_of` in size.
ParsedQuantity parse_quantity(const std::string& text, const Dimension& expected);

/// The largest size of a quantity that is taken, SI.
double largest_of(const Dimension& dimension);

/// A unit or a product of units: its size in SI and its dimension.
struct Unit {
  double factor = 1;
  Dimension dimension;
};
/// Factors such as "W/m2/K" joined by '.', '*' or a blank; each '/' divides by the one factor that follows it. Nothing
/// for what is no unit; degC is none.
std::optional<Unit> parse_unit(std::string_view text);

/// Whether two dimensions have the same exponents.
bool same_exponents(const Dimension& a, const Dimension& b);
/// "a length", "a quantity in kg m^-3".
std::string name_of(const Dimension& dimension);

/// What a dimension is called, with an example: `a length such as "2.5 mm"`.
std::string describe(const Dimension& dimension);

}  // namespace parison::core
