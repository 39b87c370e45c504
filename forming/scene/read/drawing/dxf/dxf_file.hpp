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
  enum class Section { tables, blocks, entities } section = Section::entities;
};

/// The variables of a DXF file that say how to read it, as far as it has them.
struct DxfHeader {
  std::optional<DxfGroup> units;        ///< $INSUNITS: the unit of the drawing
  std::string_view version, code_page;  ///< $ACADVER and $DWGCODEPAGE
};

/// A DXF file and the value of the case that names it, for the sentence of an error.
struct DxfFile {
  const core::CaseNode& node;
  std::string path;

  [[noreturn]] void refuse(int line, const std::string& message) const;
  /// A finite number of up to 1e15 in size.
  double number(const DxfGroup& group) const;
};

/// Calls `use` with each entity of the sections TABLES, BLOCKS and ENTITIES, in their order, and fills in the header
/// before that. Refuses a file that ends before its ENDSEC or its EOF, and lines that are no groups.
void read_entities(const DxfFile& file, const std::string& content, DxfHeader& header,
                   const std::function<void(const DxfEntity&)>& use);

/// The unit of the drawing, m, as `$INSUNITS` has it; nothing where that is absent, 0, or no unit of containers.
std::optional<double> unit_of(const DxfFile& file, const DxfHeader& header);
/// Refuses a unit of the drawing that is another one than that of the case, m.
void require_same_unit(const DxfFile& file, const DxfHeader& header, double unit);

}  // namespace parison::forming
