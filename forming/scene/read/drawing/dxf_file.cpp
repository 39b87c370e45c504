// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/dxf_file.hpp"

#include <fmt/core.h>

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

void read_entities(const DxfFile& file, const std::string& content, const std::function<void(const DxfEntity&)>& use) {
  core::Lines lines(content);
  DxfEntity entity;
  bool inside = false, ended = false, after_section = false;
  const auto finish = [&] {
    if (!entity.kind.empty()) use(entity);
    entity = {};
  };
  while (const auto group = next_group(file, lines)) {
    if (group->code == 0 && group->value == "EOF") {
      ended = true;
      break;
    }
    if (inside && group->code == 0) finish();
    if (group->code == 0 && group->value == "ENDSEC") inside = false;
    if (inside && group->code == 0)
      entity = {std::string(group->value), {}, group->line};
    else if (inside && !entity.kind.empty())
      entity.groups.push_back(*group);
    if (entity.groups.size() > max_groups)
      file.refuse(entity.line, fmt::format("a {} with too many values was found, allowed are {} in one entity",
                                           entity.kind, max_groups));
    if (after_section && group->code == 2 && group->value == "ENTITIES") inside = true;
    after_section = group->code == 0 && group->value == "SECTION";
  }
  if (inside || !ended)
    file.refuse(lines.number(), fmt::format("the file ends without {}, so a part of it is missing, allowed is a whole "
                                            "DXF file",
                                            inside ? "the ENDSEC of its entities" : "EOF"));
}

}  // namespace parison::forming
