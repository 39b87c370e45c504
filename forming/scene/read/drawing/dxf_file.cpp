// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/dxf_file.hpp"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/case/given_file.hpp"

namespace parison::forming {
namespace {

constexpr std::size_t max_groups = 200'000;  // of one entity

/// A whole text as a number; nothing where it is none or too large for one.
template <typename Number>
std::optional<Number> parse(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  Number value{};
  const auto end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc{} || read.ptr != end) return {};
  return value;
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
  Sections(const DxfFile& file, const std::function<void(const DxfEntity&)>& use) : file_(file), use_(use) {}

  /// False at the end of the file.
  bool take(const DxfGroup& group) {
    if (group.code == 0) return begin(group);
    if (after_units_ && group.code == 70) units_ = group;
    after_units_ = group.code == 9 && group.value == "$INSUNITS";
    if (after_section_ && group.code == 2) {
      blocks_ = group.value == "BLOCKS";
      inside_ = blocks_ || group.value == "ENTITIES";
    }
    after_section_ = false;
    if (!entity_.kind.empty()) entity_.groups.push_back(group);
    if (entity_.groups.size() > max_groups)
      file_.refuse(entity_.line, fmt::format("a {} with too many values was found, allowed are {} in one entity",
                                             entity_.kind, max_groups));
    return true;
  }

  bool inside_entities() const { return inside_; }
  const std::optional<DxfGroup>& units() const { return units_; }

 private:
  /// A section, an entity or an end.
  bool begin(const DxfGroup& group) {
    if (!entity_.kind.empty()) use_(entity_);
    entity_ = {};
    if (group.value == "ENDSEC") inside_ = false;
    if (inside_) entity_ = {std::string(group.value), {}, group.line, blocks_};
    after_section_ = group.value == "SECTION";
    return group.value != "EOF";
  }

  const DxfFile& file_;
  const std::function<void(const DxfEntity&)>& use_;
  DxfEntity entity_;
  std::optional<DxfGroup> units_;  ///< of the variable $INSUNITS
  bool inside_ = false, blocks_ = false, after_section_ = false, after_units_ = false;
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

void require_same_unit(const DxfFile& file, const DxfGroup& drawn, double unit) {
  constexpr double same = 1e-4;
  const double number = file.number(drawn);
  if (!(number >= 1 && number <= double(dxf_units.size()) && number == std::floor(number))) return;
  const DxfUnit& own = dxf_units[static_cast<std::size_t>(number) - 1];
  if (std::abs(own.metres / unit - 1) > same)
    file.refuse(drawn.line,
                fmt::format("$INSUNITS {:g} was found, a drawing in {}, where the case says that its unit is {:g} m; "
                            "allowed is the same unit, or 0 for none (set the units in the CAD program, or correct "
                            "unit in the case)",
                            number, own.name, unit));
}

std::optional<DxfGroup> read_entities(const DxfFile& file, const std::string& content,
                                      const std::function<void(const DxfEntity&)>& use) {
  core::Lines lines(content);
  Sections sections(file, use);
  bool ended = false;
  while (!ended) {
    const auto group = next_group(file, lines);
    if (!group) break;
    ended = !sections.take(*group);
  }
  if (ended && !sections.inside_entities()) return sections.units();
  file.refuse(lines.number(),
              fmt::format("the file ends without {}, so a part of it is missing, allowed is a whole DXF file",
                          sections.inside_entities() ? "the ENDSEC of its entities" : "EOF"));
}

}  // namespace parison::forming
