#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/case/case_file.hpp"
#include "forming/study/sweep/design.hpp"

namespace parison::forming {

/// A key or a named dimension of a case that a search changes between bounds. Where it is searched by its logarithm its
/// coordinate is ln(value), else the value in the unit of the bounds.
struct SearchVariable {
  std::string key;
  Bounds bounds;
  double start;  ///< coordinate
  double step;   ///< of difference quotients and of the first trial, coordinate; wider than the noise of a run
  bool logarithmic = false;

  double coordinate(double value) const;
  double value(double coordinate) const;
  double low() const { return coordinate(bounds.from); }
  double high() const { return coordinate(bounds.to); }
  /// As --set takes it.
  std::string text(double coordinate) const;
};

/// Reads the [[variable]] tables of a file: `key`, `from`, `to`, [`step`], [`start`], [`scale`]. Where no start is
/// given it is the value that the case has, after the assignments.
std::vector<SearchVariable> read_search_variables(const core::CaseTable& root, const std::string& file,
                                                  const std::string& case_path,
                                                  const std::vector<std::string>& overrides);

/// A number in another unit of the same dimension; refused at `node` where there is no such.
double in_unit(const Measured& measured, const std::string& unit, const core::CaseNode& node);

}  // namespace parison::forming
