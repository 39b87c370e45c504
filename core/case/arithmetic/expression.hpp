#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/case/units.hpp"

namespace parison::core {

/// A quantity of any dimension, SI. `dimension.absolute` marks a temperature on a scale (degC).
struct Measure {
  double value = 0;
  Dimension dimension;
};

/// The quantities that a text may name.
struct NamedQuantities {
  std::function<std::optional<Measure>(std::string_view)> find;
  std::vector<std::string> names;
};

/// The longest text of a formula, and the most brackets and signs within each other that it may have.
inline constexpr std::size_t max_formula_length = 500;
inline constexpr int max_formula_depth = 32;

/// A measure, or a sentence part that says what was found and what is allowed.
struct ParsedMeasure {
  Measure measure;
  std::string problem;  ///< empty when the text was understood
};

/// The value of "2*h + 3 mm": numbers with or without a unit, names, + - * / and brackets, min, max (of two), sqrt,
/// sin, cos, tan and pi. Sums are of one dimension. Its time grows with the length of the text.
ParsedMeasure parse_formula(std::string_view text, const NamedQuantities& known);

/// The value of a formula as a quantity of a given dimension, with the same limits as parse_quantity. Where `unit` is
/// one, a plain number counts in it.
ParsedQuantity parse_formula_as(std::string_view text, const Dimension& expected, const NamedQuantities& known,
                                std::string_view unit = "");

}  // namespace parison::core
