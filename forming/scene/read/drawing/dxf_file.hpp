#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of an ASCII DXF file; private to the reading of drawings.
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/case/case_file.hpp"

namespace parison::forming {

/// A pair of lines: a code, which says what the value is.
struct DxfGroup {
  int code;
  std::string_view value;
  int line;  ///< of the value, from 1
};

/// A line, an arc, a text and the like with all its groups.
struct DxfEntity {
  std::string kind;
  std::vector<DxfGroup> groups;
  int line;
  bool in_blocks = false;  ///< of the section BLOCKS
};

/// A DXF file and the value of the case that names it, for the sentence of an error.
struct DxfFile {
  const core::CaseNode& node;
  std::string path;

  [[noreturn]] void refuse(int line, const std::string& message) const;
  /// A finite number of up to 1e15 in size.
  double number(const DxfGroup& group) const;
};

/// Calls `use` with each entity of the sections BLOCKS and ENTITIES, in their order, and gives the group with the unit
/// of the drawing, $INSUNITS, where the file has one. Refuses a file that ends before its ENDSEC or its EOF, and lines
/// that are no groups.
std::optional<DxfGroup> read_entities(const DxfFile& file, const std::string& content,
                                      const std::function<void(const DxfEntity&)>& use);

/// Refuses a unit of the drawing, $INSUNITS, that is another one than that of the case, m; 0 stands for none.
void require_same_unit(const DxfFile& file, const DxfGroup& drawn, double unit);

}  // namespace parison::forming
