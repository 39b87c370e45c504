// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/dxf/dxf_file.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <optional>

#include "core/case/given_file.hpp"
#include "core/case/number.hpp"

namespace parison::forming {
namespace {

constexpr std::size_t max_groups = 200'000;  // of one entity

/// A whole text as a number; nothing where it is none or too large for one.
template <typename Number>
std::optional<Number> parse(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  return core::parse_number<Number>(text);
}

/// The next group; nothing at the end of the text.
std::optional<DxfGroup> next_group(const DxfFile& file, core::Lines& lines) {
  std::string_view code, value;
  if (!lines.next(code)) return {};
  const auto found = parse<int>(core::trimmed(code));
  if (!found)
    file.refuse(lines.number(), fmt::format("\"{}\" was found, allowed is a group code of an ASCII DXF file",
                                            core::trimmed(code).substr(0, 40)));
  if (!lines.next(value)) file.refuse(lines.number(), "the file ends within a group, allowed is a whole DXF file");
  return DxfGroup{*found, core::trimmed(value), lines.number()};
}

/// Follows the groups of a file and knows where it is in it.
class Sections {
 public:
  Sections(const DxfFile& file, DxfHeader& header, const std::function<void(const DxfEntity&)>& use)
      : file_(file), header_(header), use_(use) {}

  /// False at the end of the file.
  bool take(const DxfGroup& group) {
    if (group.code == 0) return begin(group);
    take_variable(group);
    if (after_section_ && group.code == 2) open_section(group.value);
    after_section_ = false;
    if (!entity_.kind.empty()) entity_.groups.push_back(group);
    if (entity_.groups.size() > max_groups)
      file_.refuse(entity_.line, fmt::format("a {} with too many values was found, allowed are {} in one entity",
                                             entity_.kind, max_groups));
    return true;
  }

  bool inside_entities() const { return inside_ && section_ != DxfEntity::Section::tables; }

 private:
  void take_variable(const DxfGroup& group) {
    if (variable_ == "$INSUNITS" && group.code == 70) header_.units = group;
    if (variable_ == "$ACADVER" && group.code == 1) header_.version = group.value;
    if (variable_ == "$DWGCODEPAGE" && group.code == 3) header_.code_page = group.value;
    variable_ = group.code == 9 ? group.value : std::string_view{};
  }

  void open_section(std::string_view name) {
    using Section = DxfEntity::Section;
    inside_ = name == "TABLES" || name == "BLOCKS" || name == "ENTITIES";
    section_ = name == "TABLES" ? Section::tables : name == "BLOCKS" ? Section::blocks : Section::entities;
  }

  /// A section, an entity or an end.
  bool begin(const DxfGroup& group) {
    if (!entity_.kind.empty()) use_(entity_);
    entity_ = {};
    if (group.value == "ENDSEC") inside_ = false;
    if (inside_) entity_ = {std::string(group.value), {}, group.line, section_};
    after_section_ = group.value == "SECTION";
    return group.value != "EOF";
  }

  const DxfFile& file_;
  DxfHeader& header_;
  const std::function<void(const DxfEntity&)>& use_;
  DxfEntity entity_;
  std::string_view variable_;  ///< of the group before
  bool inside_ = false, after_section_ = false;
  DxfEntity::Section section_ = DxfEntity::Section::entities;
};

/// A unit of lengths by its number in a DXF file.
struct DxfUnit {
  const char* name;
  double metres;
};
/// Those from 1 on, in their order; from 15 on no container is drawn in them.
constexpr std::array dxf_units{
    DxfUnit{"inches", 0.0254}, DxfUnit{"feet", 0.3048},  DxfUnit{"miles", 1609.344},  DxfUnit{"mm", 1e-3},
    DxfUnit{"cm", 1e-2},       DxfUnit{"m", 1.0},        DxfUnit{"km", 1e3},          DxfUnit{"microinches", 2.54e-8},
    DxfUnit{"mils", 2.54e-5},  DxfUnit{"yards", 0.9144}, DxfUnit{"angstroms", 1e-10}, DxfUnit{"nm", 1e-9},
    DxfUnit{"um", 1e-6},       DxfUnit{"dm", 0.1}};

/// The unit that $INSUNITS names; null where it names none.
const DxfUnit* unit_named(const DxfFile& file, const DxfHeader& header) {
  if (!header.units) return nullptr;
  const double number = file.number(*header.units);
  if (!(number >= 1 && number <= double(dxf_units.size()) && number == std::floor(number))) return nullptr;
  return &dxf_units[static_cast<std::size_t>(number) - 1];
}

}  // namespace

void DxfFile::refuse(int line, const std::string& message) const {
  core::CaseNode at = node;
  at.file = path;
  at.line = line;
  core::refuse(at, message);
}

double DxfFile::number(const DxfGroup& group) const {
  constexpr double largest = 1e15;
  const auto value = parse<double>(group.value);
  if (!value || !(std::abs(*value) <= largest))
    refuse(group.line, fmt::format("\"{}\" was found, allowed is a number of up to {:g} in size",
                                   group.value.substr(0, 40), largest));
  return *value;
}

std::optional<double> unit_of(const DxfFile& file, const DxfHeader& header) {
  const DxfUnit* unit = unit_named(file, header);
  if (!unit) return {};
  return unit->metres;
}

void require_same_unit(const DxfFile& file, const DxfHeader& header, double unit) {
  constexpr double same = 1e-4;
  const DxfUnit* own = unit_named(file, header);
  if (own && std::abs(own->metres / unit - 1) > same)
    file.refuse(header.units->line,
                fmt::format("$INSUNITS {} was found, a drawing in {}, where the case says that its unit is {:g} m; "
                            "allowed is the same unit, no unit in the case, or 0 in the drawing",
                            header.units->value, own->name, unit));
}

void read_entities(const DxfFile& file, const std::string& content, DxfHeader& header,
                   const std::function<void(const DxfEntity&)>& use) {
  core::Lines lines(content);
  Sections sections(file, header, use);
  bool ended = false;
  while (!ended) {
    const auto group = next_group(file, lines);
    if (!group) break;
    ended = !sections.take(*group);
  }
  if (ended && !sections.inside_entities()) return;
  file.refuse(lines.number(),
              fmt::format("the file ends without {}, so a part of it is missing, allowed is a whole DXF file",
                          sections.inside_entities() ? "the ENDSEC of its entities" : "EOF"));
}

}  // namespace parison::forming
