// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/case_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>
#include <numeric>

#include "core/case/arithmetic/expression.hpp"
#include "core/case/tolerance.hpp"

namespace parison::core {
namespace {

std::string found(const CaseNode& node) {
  switch (node.kind) {
    case CaseNode::Kind::text:
      return node.given.empty() ? fmt::format("the text \"{}\"", node.text)
                                : fmt::format("the tolerance \"{}\"", node.given);
    case CaseNode::Kind::number:
      return fmt::format("the number {}", node.number);
    case CaseNode::Kind::flag:
      return node.flag ? "true" : "false";
    case CaseNode::Kind::list:
      return "a list";
    case CaseNode::Kind::table:
      return "a table";
  }
  return {};
}

void require_kind(const CaseNode& node, CaseNode::Kind kind, const std::string& allowed) {
  if (node.kind != kind) refuse(node, fmt::format("{} was found, allowed is {}", found(node), allowed));
}

std::string shown(const CaseNode& node) {
  return node.kind == CaseNode::Kind::text ? fmt::format("\"{}\"", node.text) : fmt::format("{}", node.number);
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const auto substitute = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j + 1] + 1, row[j] + 1, substitute});
    }
  }
  return row.back();
}

/// Whether one word is a part of the other between its signs, as `flint` is of `flint_glass`.
bool is_part(const std::string& part, const std::string& word) {
  const auto ends = [&](std::size_t at) {
    return at >= word.size() || !std::isalnum(static_cast<unsigned char>(word[at]));
  };
  for (auto at = word.find(part); !part.empty() && at != word.npos; at = word.find(part, at + 1))
    if ((at == 0 || ends(at - 1)) && ends(at + part.size())) return true;
  return false;
}

}  // namespace

std::string nearest(const std::string& word, const std::vector<std::string>& candidates) {
  std::string best;
  auto limit = std::max<std::size_t>(2, word.size() / 2);
  for (const auto& candidate : candidates)
    if (const auto apart = edit_distance(word, candidate); apart <= limit && apart < candidate.size()) {
      best = candidate;
      limit = apart - (apart > 0);
    }
  if (!best.empty()) return best;
  const auto related = [&](const auto& candidate) { return is_part(candidate, word) || is_part(word, candidate); };
  const auto found = std::find_if(candidates.begin(), candidates.end(), related);
  return found == candidates.end() ? "" : *found;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  const auto near = nearest(word, candidates);
  return near.empty() ? "" : fmt::format(" (did you mean \"{}\"?)", near);
}

namespace {

/// A text on one line, blanks for the signs that steer a terminal, without its middle where it is too long.
std::string as_sentence(std::string text) {
  constexpr std::size_t longest = 1500;
  if (text.size() > longest) text = text.substr(0, longest / 2) + " ... " + text.substr(text.size() - longest / 2);
  const auto steers = [](unsigned char c) { return c < ' ' || c == 127; };
  std::replace_if(text.begin(), text.end(), steers, ' ');
  return text;
}

}  // namespace

void refuse(const CaseNode& at, const std::string& message) {
  const std::string place = at.line > 0 ? fmt::format("{}:{}", at.file, at.line) : at.file;
  throw CaseError(at.key.empty() ? fmt::format("{}: {}", place, as_sentence(message))
                                 : fmt::format("{}: {}: {}", place, as_sentence(at.key), as_sentence(message)),
                  at.file, static_cast<int>(at.line), at.key);
}

const CaseNode* member(const CaseNode& table, std::string_view name) {
  if (table.kind == CaseNode::Kind::table)
    for (const CaseNode& item : table.items)
      if (item.name == name) return &item;
  return nullptr;
}

CaseNode* member(CaseNode& table, std::string_view name) {
  return const_cast<CaseNode*>(member(std::as_const(table), name));
}

CaseTable::CaseTable(const CaseNode& node, std::vector<std::string> keys) : node_(&node), keys_(std::move(keys)) {
  require_kind(node, CaseNode::Kind::table, fmt::format("a table with the keys {}", fmt::join(keys_, ", ")));
  for (const auto& item : node.items)
    if (std::find(keys_.begin(), keys_.end(), item.name) == keys_.end())
      refuse(item,
             fmt::format("unknown key{}, allowed are {}", did_you_mean(item.name, keys_), fmt::join(keys_, ", ")));
}

const CaseNode* CaseTable::find(const std::string& key) const {
  assert(std::find(keys_.begin(), keys_.end(), key) != keys_.end());
  return member(*node_, key);
}

const CaseNode& CaseTable::get(const std::string& key) const {
  if (const auto* item = find(key)) return *item;
  CaseNode place = *node_;
  place.key = place.key.empty() ? key : place.key + "." + key;
  refuse(place, fmt::format("missing, the table that starts here needs the key \"{}\"", key));
}

std::vector<const CaseNode*> CaseTable::tables(const std::string& key) const {
  std::vector<const CaseNode*> result;
  if (const auto* node = find(key))
    for (const auto& item : list(*node)) {
      require_kind(item, CaseNode::Kind::table, "a table");
      result.push_back(&item);
    }
  return result;
}

double text_quantity(const CaseNode& node, std::string_view text, const Dimension& dimension, std::string_view unit) {
  refuse_tolerance_of_formula(node);
  const auto simple = parse_quantity(unit.empty() ? std::string(text) : fmt::format("{} {}", text, unit), dimension);
  if (simple.problem.empty()) return simple.value;
  const auto formula = parse_formula_as(text, dimension, node.known ? *node.known : NamedQuantities{}, unit);
  if (formula.problem.empty()) return formula.value;
  const bool is_formula = node.known || text.find_first_of("+*(") != text.npos;
  refuse(node, is_formula ? formula.problem : simple.problem);
}

void refuse_tolerance_of_formula(const CaseNode& node) {
  if (find_tolerance(node.text) != std::string::npos)
    refuse(node,
           fmt::format("\"{}\" has a tolerance, allowed is one behind a single number, such as \"460 +- 10 degC\"; "
                       "in a formula or a path, name the quantity in [dimension] and give that the tolerance",
                       node.text));
}

double quantity(const CaseNode& node, const Dimension& dimension) {
  const bool plain = dimension.length == 0 && dimension.mass == 0 && dimension.time == 0 && dimension.temperature == 0;
  if (node.kind == CaseNode::Kind::number && plain) {
    if (std::abs(node.number) <= largest_of(dimension)) return node.number;
    refuse(node, fmt::format("the number {} was found, allowed are numbers of up to {:g} in size", node.number,
                             largest_of(dimension)));
  }
  require_kind(node, CaseNode::Kind::text, describe(dimension));
  const double value = text_quantity(node, node.text, dimension);
  if (dimension.absolute && value <= 0)
    refuse(node, fmt::format("\"{}\" is not above absolute zero, allowed is {}", node.text, describe(dimension)));
  return value;
}

double positive(const CaseNode& node, const Dimension& dimension) {
  constexpr double least = 1e-30;  // its reciprocal and products stay finite
  const double value = quantity(node, dimension);
  if (value > 0 && value < least)
    refuse(node, fmt::format("{} was found, allowed are values from {:g} in SI units", shown(node), least));
  if (!(value > 0))
    refuse(node, fmt::format("{} was found, allowed is {}, above zero", shown(node), describe(dimension)));
  return value;
}

double not_negative(const CaseNode& node, const Dimension& dimension) {
  const double value = quantity(node, dimension);
  if (!(value >= 0))
    refuse(node, fmt::format("{} was found, allowed is {}, not below zero", shown(node), describe(dimension)));
  return value;
}

int count(const CaseNode& node) {
  constexpr double largest = 1e6;
  if (node.kind != CaseNode::Kind::number || !(node.number >= 1 && node.number <= largest) ||
      node.number != std::floor(node.number))
    refuse(node, fmt::format("{} was found, allowed is a whole number from 1 to {}", found(node), largest));
  return static_cast<int>(node.number);
}

bool flag(const CaseNode& node) {
  require_kind(node, CaseNode::Kind::flag, "true or false");
  return node.flag;
}

const std::string& text(const CaseNode& node) {
  require_kind(node, CaseNode::Kind::text, "a text in quotes");
  if (!node.given.empty()) refuse(node, fmt::format("{} was found, allowed are tolerances of quantities", found(node)));
  if (node.text.empty()) refuse(node, "an empty text was found, allowed is a name");
  return node.text;
}

const std::string& identifier(const CaseNode& node) {
  const auto allowed = [](unsigned char c) { return c < 128 && (std::isalnum(c) || c == '_' || c == '-'); };
  if (!std::all_of(text(node).begin(), text(node).end(), allowed))
    refuse(node, fmt::format("\"{}\" was found, allowed are names of letters, digits, _ and -", node.text));
  constexpr std::size_t longest = 100;  // it becomes a part of file names
  if (node.text.size() > longest)
    refuse(node, fmt::format("a name of {} characters was found, allowed are up to {}", node.text.size(), longest));
  return node.text;
}

CaseNode key_of(const CaseNode& node) {
  CaseNode key = node;
  key.kind = CaseNode::Kind::text;
  key.text = node.name;
  return key;
}

const std::vector<CaseNode>& list(const CaseNode& node) {
  require_kind(node, CaseNode::Kind::list, "a list in brackets");
  return node.items;
}

const std::vector<CaseNode>& entries(const CaseNode& table) {
  require_kind(table, CaseNode::Kind::table, "a table");
  return table.items;
}

int choice(const CaseNode& node, const std::vector<std::string>& allowed) {
  const auto at = std::find(allowed.begin(), allowed.end(), text(node));
  if (at == allowed.end())
    refuse(node, fmt::format("\"{}\" was found{}, allowed {}", node.text, did_you_mean(node.text, allowed),
                             allowed.empty() ? "is nothing here" : fmt::format("are {}", fmt::join(allowed, ", "))));
  return static_cast<int>(at - allowed.begin());
}

Table quantity_table(const CaseNode& node, const Dimension& x, const Dimension& y) {
  if (node.kind != CaseNode::Kind::list) return constant(quantity(node, y));
  if (node.items.empty()) refuse(node, "an empty list was found, allowed are pairs of quantities");
  Table table;
  for (const auto& pair : node.items) {
    if (list(pair).size() != 2)
      refuse(pair, fmt::format("{} members were found, allowed are pairs of {} and {}", pair.items.size(), describe(x),
                               describe(y)));
    table.x.push_back(quantity(pair.items[0], x));
    table.y.push_back(quantity(pair.items[1], y));
    if (table.x.size() > 1 && !(table.x.back() > table.x[table.x.size() - 2]))
      refuse(pair,
             fmt::format("{} does not lie above the entry before, allowed are rising entries", shown(pair.items[0])));
  }
  return table;
}

TimeFunction quantity_over_time(const CaseNode& node, const Dimension& dimension) {
  if (node.kind != CaseNode::Kind::list) return quantity(node, dimension);
  return TimeFunction(quantity_table(node, dimension::time, dimension));
}

TimeFunction not_negative_over_time(const CaseNode& node, const Dimension& dimension) {
  if (node.kind != CaseNode::Kind::list) return not_negative(node, dimension);
  TimeFunction function = quantity_over_time(node, dimension);
  for (const auto& pair : node.items) not_negative(pair.items[1], dimension);
  return function;
}

TimeFunction positive_over_time(const CaseNode& node, const Dimension& dimension) {
  if (node.kind != CaseNode::Kind::list) return positive(node, dimension);
  TimeFunction function = quantity_over_time(node, dimension);
  for (const auto& pair : node.items) positive(pair.items[1], dimension);
  return function;
}

}  // namespace parison::core
