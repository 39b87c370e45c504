// SPDX-License-Identifier: GPL-3.0-or-later
#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#define TOML_ASSERT(condition) ((void)0)  // the parser reports what it asserts
#include <fmt/core.h>
#include <toml++/toml.h>

#include <filesystem>

#include "core/case/case_file.hpp"
#include "core/case/text/case_text.hpp"
#include "core/io/input_file.hpp"

namespace parison::core {
namespace {

/// An empty node below another one.
CaseNode child(const CaseNode& parent, int line, const std::string& name) {
  CaseNode node;
  node.file = parent.file;
  node.line = line;
  node.key = parent.key.empty() ? name : fmt::format("{}.{}", parent.key, name);
  node.name = name;
  return node;
}

CaseNode convert(const toml::node& node, CaseNode place) {
  if (const int line = static_cast<int>(node.source().begin.line); line > 0 && place.line == 0) place.line = line;
  if (const auto* value = node.as_string()) {
    place.kind = CaseNode::Kind::text;
    place.text = value->get();
  } else if (const auto* flag = node.as_boolean()) {
    place.kind = CaseNode::Kind::flag;
    place.flag = flag->get();
  } else if (node.is_number()) {
    place.kind = CaseNode::Kind::number;
    place.number = *node.value<double>();
  } else if (const auto* array = node.as_array()) {
    place.kind = CaseNode::Kind::list;
    for (const auto& item : *array) {
      CaseNode member;
      member.file = place.file;
      member.key = place.key;
      member.name = place.name;
      place.items.push_back(convert(item, member));
    }
  } else if (const auto* table = node.as_table()) {
    place.kind = CaseNode::Kind::table;
    for (const auto& [key, item] : *table)
      place.items.push_back(
          convert(item, child(place, static_cast<int>(key.source().begin.line), std::string(key.str()))));
  } else {
    refuse(place, "a date was found, allowed are texts, numbers, true, false, lists and tables");
  }
  return place;
}

/// Refuses what the parser cannot be given.
void require_parsable(const std::string& text, CaseNode place) {
  const CaseFlaw flaw = find_flaw(text);
  if (flaw.line == 0) return;
  if (place.line > 0) place.line = flaw.line;
  refuse(place, flaw.problem);
}

/// Gives a value and all in it to the command line, which has no lines.
void clear_lines(CaseNode& node) {
  node.line = 0;
  for (auto& item : node.items) clear_lines(item);
}

}  // namespace

CaseNode parse_value(const std::string& text, const CaseNode& place) {
  const bool is_text = !text.empty() && text.find_first_of("[{\"'") != 0 && text.find('\n') == text.npos;
  if (!is_text) require_parsable(text, place);
  const auto parsed = toml::parse(find_flaw(text).line == 0 ? "value = " + text : "");
  CaseNode value = place;
  if (parsed && parsed.table().size() == 1) {
    value = convert(*parsed.table().get("value"), place);
    clear_lines(value);
  } else if (is_text) {
    value.kind = CaseNode::Kind::text;
    value.text = text;
  } else {
    refuse(place, fmt::format("\"{}\" was found, allowed is a TOML value or a text", text));
  }
  return value;
}

CaseNode parse_case_text(const std::string& text, const std::string& file) {
  CaseNode place;
  place.file = file;
  place.line = 1;
  require_parsable(text, place);
  const auto parsed = toml::parse(std::string_view(text), std::string_view(file));
  if (!parsed) {
    place.line = static_cast<int>(parsed.error().source().begin.line);
    refuse(place, fmt::format("{}, allowed is TOML", parsed.error().description()));
  }
  return convert(parsed.table(), place);
}

CaseFile read_case_file(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code unknown;  // as of a loop of links: the reading says what it is
  const fs::path file = fs::is_directory(path, unknown) ? fs::path(path) / "case.toml" : fs::path(path);
  CaseNode place;
  place.file = file.string();
  place.line = 1;
  if (!fs::exists(file, unknown) && !unknown)
    refuse(place, "no such file, allowed is a case file or a folder that holds a case.toml");
  constexpr std::size_t max_bytes = 4'000'000;  // its tree takes some hundred times as much memory
  const InputFile content = read_input_file(place.file, max_bytes);
  if (!content.problem.empty()) refuse(place, content.problem);
  const auto directory = file.parent_path();
  return {place.file, directory.empty() ? "." : directory.string(), parse_case_text(content.content, place.file), {}};
}

}  // namespace parison::core
