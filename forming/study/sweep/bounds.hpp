#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

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

}  // namespace parison::forming
