#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <string>
#include <vector>

#include "core/io/json_read.hpp"

namespace parison::forming {

/// A text whose first line begins at column `indent` of the terminal, broken between words before column `width`; the
/// lines after the first are indented as far. Without a line feed at the end.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width = 120);

/// What a run says of itself beside its numbers: a flag of the process, a warning, or a check beyond its limit.
struct Remark {
  enum class Kind { flag, warning, failed_check };
  Kind kind;
  std::string name;  ///< the same in two runs that say the same: flag and tool, check, warning without its numbers
  std::string text;  ///< short, with value and limit
};
/// "flag", "warning" or "failed check".
const char* name_of(Remark::Kind kind);

/// Those of a summary.json.
std::vector<Remark> read_remarks(const core::JsonValue& summary);

/// The remark of the same kind and name among others; null without one.
const Remark* same_remark(const std::vector<Remark>& remarks, const Remark& remark);

}  // namespace parison::forming
