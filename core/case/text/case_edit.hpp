#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "core/case/case_error.hpp"

namespace parison::core {

/// A part of a text; lines and columns from 1, columns in letters. Line 0: nowhere.
struct TextRange {
  int line = 0, column = 0, end_line = 0, end_column = 0;
};

/// The text of a case in which `path=value`, as override_value takes it, has replaced one value, or has added a key of
/// a table; comments, order and layout stay. `file` is what sentences call it. Throws CaseError where the text cannot
/// be changed so that it reads as override_value would have it.
std::string edited_case_text(const std::string& text, const std::string& file, const std::string& assignment);

/// Where the value stands of which an error tells, or its key where the value is a table; the line alone where it is
/// not found.
TextRange range_of(const std::string& text, const CaseError& error);

}  // namespace parison::core
