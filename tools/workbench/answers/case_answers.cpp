// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <regex>
#include <set>

#include "core/case/case_error.hpp"
#include "core/case/case_file.hpp"
#include "core/case/given_file.hpp"
#include "core/case/text/case_edit.hpp"
#include "tools/workbench/answers/workbench_state.hpp"
#include "tools/workbench/handles/handles.hpp"

namespace parison::tools {
namespace {

/// The size in SI of the unit of a text that is a number with a unit; nothing for other texts.
std::optional<double> unit_size(const std::string& text) {
  char* rest = nullptr;
  std::strtod(text.c_str(), &rest);
  const std::string unit(core::trimmed(rest));
  if (rest == text.c_str() || unit.empty()) return {};
  if (unit == "degC") return 1;
  const auto found = core::parse_unit(unit);
  return found ? std::optional(found->factor) : std::nullopt;
}

/// The values of a case that are no list: key as override_value takes it, text, line and size of the unit if any.
void add_values(const core::CaseNode& node, const std::string& key, core::JsonWriter& json) {
  using Kind = core::CaseNode::Kind;
  if (node.kind == Kind::table || node.kind == Kind::list) {
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const std::string word = node.kind == Kind::list ? std::to_string(i) : node.items[i].name;
      add_values(node.items[i], key.empty() ? word : key + "." + word, json);
    }
    return;
  }
  json.open_list("");
  json.add("", key);
  json.add("", node.kind == Kind::text     ? node.text
               : node.kind == Kind::number ? fmt::format("{}", node.number)
               : node.flag                 ? "true"
                                           : "false");
  json.add("", static_cast<long>(node.line));
  if (const auto size = unit_size(node.text)) json.add("", *size);
  json.close();
}

/// The words of all texts of a case.
void add_words(const core::CaseNode& node, std::set<std::string>& words) {
  static const std::regex word("[A-Za-z_][A-Za-z0-9_]*");
  for (std::sregex_iterator one(node.text.begin(), node.text.end(), word), end; one != end; ++one)
    words.insert(one->str());
  for (const core::CaseNode& item : node.items) add_words(item, words);
}

/// The keys of the named dimensions that nothing in the case names.
void add_unused(const core::CaseNode& root, core::JsonWriter& json) {
  std::set<std::string> words;
  add_words(root, words);
  json.open_list("unused");
  for (const core::CaseNode& table : root.items)
    for (const core::CaseNode& one : table.items)
      if (table.name == "dimension" && !words.count(one.name)) json.add("", "dimension." + one.name);
  json.close();
}

/// The sentence of an error without its place.
std::string sentence_of(const core::CaseError& error) {
  std::string text = error.what();
  for (const std::string& begin :
       {fmt::format("{}:{}: ", error.file, error.line), error.file + ": ", error.key.empty() ? "" : error.key + ": "})
    if (!begin.empty() && text.compare(0, begin.size(), begin) == 0) text.erase(0, begin.size());
  return text;
}

/// Whether a page has seen the last change.
bool has_seen(const OpenCase& one, const Asked& asked) {
  return asked.number_of("version") == static_cast<double>(one.version());
}

/// Refuses a change by a page that has not seen the last one.
void require_seen(const OpenCase& one, const Asked& asked) {
  if (!has_seen(one, asked))
    throw core::CaseError(fmt::format("{}: the file has changed meanwhile; nothing was written", one.file()));
}

void refuse_bundled(const Asked& asked) {
  const std::string name = asked.text_of("case");
  if (is_bundled(name))
    throw core::CaseError(fmt::format("{}: bundled cases are not changed, allowed is a copy of it", name));
}

void add_text(const OpenCase& one, const std::string& name, core::JsonWriter& json) {
  json.add("case", name);
  json.add("file", one.file());
  json.add("version", one.version());
  json.add("text", one.text());
  json.add("bundled", is_bundled(name));
  json.add("undo", static_cast<long>(one.undoable()));
  json.add("redo", static_cast<long>(one.redoable()));
  try {
    const core::CaseNode root = core::parse_case_text(one.text(), one.file());
    json.open_list("values");
    add_values(root, "", json);
    json.close();
    add_unused(root, json);
  } catch (const core::CaseError& error) {
    add_error(error, one.text(), json);
  }
}

OpenCase& changeable(WorkbenchState& state, const Asked& asked) {
  refuse_bundled(asked);
  OpenCase& one = state.open(asked.text_of("case"));
  require_seen(one, asked);
  return one;
}

}  // namespace

void add_error(const core::CaseError& error, const std::string& text, core::JsonWriter& json) {
  const core::TextRange range = core::range_of(text, error);
  json.open_object("problem");
  json.add("sentence", sentence_of(error));
  json.add("key", error.key);
  json.add("line", static_cast<long>(range.line));
  json.add("column", static_cast<long>(range.column));
  json.add("end_line", static_cast<long>(range.end_line));
  json.add("end_column", static_cast<long>(range.end_column));
  json.close();
}

void add_case(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  add_text(state.open(asked.text_of("case")), asked.text_of("case"), json);
}

void add_news(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  if (const std::string name = asked.text_of("case"); !name.empty()) {
    const OpenCase& one = state.open(name);
    if (!has_seen(one, asked)) add_text(one, name, json);
  }
  if (const std::string results = asked.text_of("results"); !results.empty()) {
    json.open_object("run");
    state.runs.add_state(results, json);
    json.close();
  }
  if (!asked.flag_of("sketch")) return;
  json.open_object("sketch");
  state.sketch.add_state(wanted_wall_of(state, asked), json);
  json.close();
}

void change_values(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  OpenCase& one = changeable(state, asked);
  {
    const std::lock_guard<std::mutex> lock(state.reading);
    one.set(assignments_of(one, asked));
  }
  add_text(one, asked.text_of("case"), json);
}

void change_text(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  changeable(state, asked).replace(asked.text_of("text"));
  add_case(state, asked, json);
}

void undo_change(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  changeable(state, asked).undo();
  add_case(state, asked, json);
}

void redo_change(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  changeable(state, asked).redo();
  add_case(state, asked, json);
}

}  // namespace parison::tools
