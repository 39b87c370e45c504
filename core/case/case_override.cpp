// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "core/case/given_file.hpp"
#include "core/case/number.hpp"
#include "core/case/text/case_text.hpp"

namespace parison::core {
namespace {

std::vector<std::string> words_of(const std::string& path) {
  std::vector<std::string> words;
  for (const auto word : split(path, '.')) words.emplace_back(trimmed(word));
  return words;
}

/// Names that pick an entry of a list of tables: its own, or without one those in its `tools`.
std::vector<std::string> names_of(CaseNode& entry) {
  if (entry.kind != CaseNode::Kind::table) return {};
  if (const auto* name = member(entry, "name")) return {name->text};
  std::vector<std::string> names;
  if (const auto* tools = member(entry, "tools"))
    for (const auto& tool : tools->items) names.push_back(tool.text);
  return names;
}

/// The entry alone for one of its several tools: that tool leaves it and gets a copy.
CaseNode& split_off(CaseNode& list, std::size_t at, const std::string& tool) {
  CaseNode copy = list.items[at];
  const auto other = [&](const CaseNode& item) { return item.text != tool; };
  auto &rest = member(list.items[at], "tools")->items, &own = member(copy, "tools")->items;
  own.erase(std::remove_if(own.begin(), own.end(), other), own.end());
  rest.erase(std::stable_partition(rest.begin(), rest.end(), other), rest.end());
  list.items.push_back(std::move(copy));
  return list.items.back();
}

CaseNode& entry(CaseNode& list, const std::string& word, const CaseNode& place) {
  const auto index = parse_number<std::size_t>(word);
  if (index && *index < list.items.size()) return list.items[*index];
  std::vector<std::string> known;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const auto names = names_of(list.items[i]);
    if (std::count(names.begin(), names.end(), word))
      return names.size() == 1 ? list.items[i] : split_off(list, i, word);
    known.insert(known.end(), names.begin(), names.end());
  }
  const std::string names = known.empty() ? "" : fmt::format(", and the names {}", fmt::join(known, ", "));
  refuse(place, fmt::format("no entry \"{}\" was found{}, allowed are numbers from 0 to {}{}", word,
                            did_you_mean(word, known), static_cast<long>(list.items.size()) - 1, names));
}

CaseNode& step_down(CaseNode& at, const std::string& word, const CaseNode& place, bool may_be_new) {
  if (at.kind == CaseNode::Kind::list) return entry(at, word, place);
  if (at.kind != CaseNode::Kind::table)
    refuse(place, fmt::format("nothing below \"{}\" was found, allowed is to set the value itself", at.key));
  if (auto* item = member(at, word)) return *item;
  std::vector<std::string> known;
  for (const auto& item : at.items) known.push_back(item.name);
  if (!may_be_new)
    refuse(place, fmt::format("no \"{}\" was found{}, allowed are {}", word, did_you_mean(word, known),
                              fmt::join(known, ", ")));
  at.items.push_back(place);
  at.items.back().name = word;
  return at.items.back();
}

}  // namespace

namespace {

/// The place of a key, made where it may be new.
CaseNode& place_of(CaseFile& file, const CaseNode& place, const std::vector<std::string>& words) {
  CaseNode* at = &file.root;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool last = i + 1 == words.size();
    // A new table in the middle of a path is read with the case, which refuses what it does not know with the keys that
    // are allowed. Materials may have any name: a new one would be a table that nothing uses, and so would a new
    // dimension, since it is the case's texts that use them; the whole table of dimensions may be new, for texts that
    // are set too.
    const bool is_unused_name = words[0] == "dimension" && words.size() > 1;
    const bool has_free_names = i == 1 && words[0] == "material" && !last;
    at = &step_down(*at, words[i], place, !is_unused_name && !has_free_names);
  }
  return *at;
}

}  // namespace

void override_value(CaseFile& file, const std::string& assignment) {
  const auto equals = assignment.find('=');
  CaseNode place;
  place.file = "--set";
  place.key = trimmed(std::string_view(assignment).substr(0, equals));
  const auto words = words_of(place.key);
  if (equals == assignment.npos || std::count(words.begin(), words.end(), ""))
    refuse(place, "allowed is KEY=VALUE such as tool.blank.temperature=\"480 degC\"");
  const CaseNode value = parse_value(std::string(trimmed(std::string_view(assignment).substr(equals + 1))), place);
  CaseNode& at = place_of(file, place, words);
  const std::string name = at.name;
  at = value;
  at.name = name;
  file.overrides.push_back(assignment);
}

std::string numbered_key(CaseFile file, const std::string& key) {
  CaseNode place;
  place.file = "--set";
  place.key = key;
  CaseNode* at = &file.root;
  std::string numbered;
  for (const std::string& word : words_of(key)) {
    CaseNode& next = step_down(*at, word, place, true);
    const bool is_entry = at->kind == CaseNode::Kind::list;
    numbered += (numbered.empty() ? "" : ".") + (is_entry ? fmt::format("{}", &next - at->items.data()) : word);
    at = &next;
  }
  return numbered;
}

std::string repeated_key(CaseFile file, const std::vector<std::string>& assignments) {
  const auto replaces = [](const std::string& now, const std::string& before) {
    return now == before || before.rfind(now + '.', 0) == 0;
  };
  const auto sentence = [](const std::string& now, const std::string& before) {
    return fmt::format("{} was found{}, of which the last would count alone", now,
                       before == now ? " twice" : fmt::format(" after {}, which it replaces", before));
  };
  std::vector<std::string> keys;  // by their words first: what has been replaced has no numbers
  for (const std::string& assignment : assignments) {
    keys.emplace_back(trimmed(std::string_view(assignment).substr(0, assignment.find('='))));
    for (std::size_t i = 0; i + 1 < keys.size(); ++i)
      if (replaces(keys.back(), keys[i])) return sentence(keys.back(), keys[i]);
  }
  std::vector<std::string> numbered;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    override_value(file, assignments[i]);
    numbered.push_back(numbered_key(file, keys[i]));
    for (std::size_t before = 0; before < i; ++before)
      if (replaces(numbered[i], numbered[before])) return sentence(keys[i], keys[before]);
  }
  return {};
}

CaseNode value_of(CaseFile file, const std::string& key) {
  CaseNode place;
  place.file = file.path;
  place.key = key;
  return place_of(file, place, words_of(key));
}

}  // namespace parison::core
