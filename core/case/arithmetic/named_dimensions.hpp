#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/arithmetic/expression.hpp"
#include "core/case/case_file.hpp"

namespace parison::core {

/// A named dimension of a case as it was given and what it is.
struct NamedDimension {
  std::string name, given;
  Measure measure;
};

/// Reads the table [dimension] of a case, in which each entry may use the others, and lets every text of the case use
/// the names. Refuses names that a formula cannot have, circles, and more than 500 entries.
std::vector<NamedDimension> read_dimensions(CaseFile& file);

/// Lets every text of the case use these names, in place of those it could use before.
void let_name(CaseFile& file, const std::vector<NamedDimension>& named);

/// Refuses a name that a formula cannot have.
void check_formula_name(const CaseNode& entry);

}  // namespace parison::core
