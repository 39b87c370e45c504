// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/tolerance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "core/case/case_file.hpp"
#include "core/case/given_file.hpp"
#include "core/case/number.hpp"

namespace parison::core {
namespace {

constexpr const char* signs[] = {"+-", "\u00b1"};  // the second one in UTF-8

struct Number {
  double value = 0;
  std::string unit;
};

/// "460 degC", "10", in its parts; nothing for what does not begin with a number or has brackets or signs behind it.
std::optional<Number> split_number(std::string_view text) {
  const auto read = leading_number(trimmed(text));
  if (!read) return {};
  const Number number{read->value, std::string(read->rest)};
  const bool is_unit = number.unit.empty() || std::isalnum(static_cast<unsigned char>(number.unit.front())) ||
                       number.unit.front() == '%';
  if (!is_unit || number.unit.find_first_of("()+,\"'") != std::string::npos) return {};
  return number;
}

/// The size of one of a unit as a difference, and its dimension; degC counts like K.
std::optional<Unit> difference_unit(const std::string& unit) {
  if (unit.empty()) return Unit{};
  return parse_unit(unit == "degC" ? "K" : unit);
}

constexpr const char* example = "allowed is such as \"460 +- 10 degC\" or \"460 +- 10 degC uniform\"";

Distribution take_distribution(std::string_view& text) {
  const auto ends_with = [&](std::string_view word) {
    return text.size() > word.size() && text.substr(text.size() - word.size()) == word &&
           text[text.size() - word.size() - 1] == ' ';
  };
  for (const auto& [word, distribution] :
       {std::pair{"uniform", Distribution::uniform}, {"normal", Distribution::normal}})
    if (ends_with(word)) {
      text = trimmed(text.substr(0, text.size() - std::string_view(word).size()));
      return distribution;
    }
  return Distribution::normal;
}

/// The tolerance in the unit of the mean; that of a mean without a unit goes for both.
void set_spread(const CaseNode& node, const Number& spread, Tolerance& tolerance) {
  if (tolerance.unit.empty()) tolerance.unit = spread.unit;
  const std::string own = spread.unit.empty() ? tolerance.unit : spread.unit;
  const auto mean_unit = difference_unit(tolerance.unit), spread_unit = difference_unit(own);
  if (!mean_unit || !spread_unit)
    refuse(node,
           fmt::format("\"{}\" has the unknown unit \"{}\", {}", node.text, mean_unit ? own : tolerance.unit, example));
  if (!same_exponents(mean_unit->dimension, spread_unit->dimension))
    refuse(node, fmt::format("\"{}\" has {} as the tolerance of {}, allowed is a tolerance of the same dimension",
                             node.text, name_of(spread_unit->dimension), name_of(mean_unit->dimension)));
  tolerance.spread = own == tolerance.unit ? spread.value : spread.value * spread_unit->factor / mean_unit->factor;
  if (!(tolerance.spread > 0))
    refuse(node, fmt::format("\"{}\" has the tolerance {}, allowed is one above zero", node.text,
                             tolerance.value_text(tolerance.spread)));
}

/// Takes the tolerance of a text out of it; nothing where it has none, or where more than a number stands before it.
std::optional<Tolerance> take_tolerance(CaseNode& node, const std::string& key) {
  const std::size_t at = find_tolerance(node.text);
  if (at == std::string::npos) return {};
  const std::string_view whole = node.text;
  const auto mean = split_number(whole.substr(0, at));
  if (!mean) return {};
  std::string_view behind = trimmed(whole.substr(at + 2));  // both signs have two bytes
  Tolerance tolerance{key, node.text, mean->value, 0, mean->unit, take_distribution(behind)};
  const auto spread = split_number(behind);
  if (!spread) refuse(node, fmt::format("\"{}\" has no number as its tolerance, {}", node.text, example));
  set_spread(node, *spread, tolerance);
  const std::string own(trimmed(whole.substr(0, at)));
  node.given = node.text;
  node.text = mean->unit.empty() && !tolerance.unit.empty() ? own + ' ' + tolerance.unit : own;
  return tolerance;
}

/// What --set calls an entry of a list: its name, that of the one tool it is for, or its number.
std::string name_in_list(const CaseNode& entry, std::size_t number) {
  if (entry.kind == CaseNode::Kind::table)
    for (const CaseNode& item : entry.items) {
      if (item.name == "name" && item.kind == CaseNode::Kind::text) return item.text;
      if (item.name == "tools" && item.items.size() == 1 && entry.key == "interface") return item.items.front().text;
    }
  return fmt::format("{}", number);
}

void walk(CaseNode& node, const std::string& key, std::vector<Tolerance>& found) {
  const auto below = [&](const std::string& name) { return key.empty() ? name : key + '.' + name; };
  if (node.kind == CaseNode::Kind::text)
    if (auto tolerance = take_tolerance(node, key)) found.push_back(std::move(*tolerance));
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    CaseNode& item = node.items[i];
    walk(item, below(node.kind == CaseNode::Kind::list ? name_in_list(item, i) : item.name), found);
  }
}

}  // namespace

double Tolerance::deviation() const {
  return distribution == Distribution::uniform ? spread / std::sqrt(3.0) : spread;
}

std::string Tolerance::value_text(double value) const {
  return unit.empty() ? fmt::format("{:.9g}", value) : fmt::format("{:.9g} {}", value, unit);
}

std::size_t find_tolerance(const std::string& text) {
  std::size_t first = std::string::npos;
  for (const char* sign : signs) first = std::min(first, text.find(sign));
  return first;
}

std::vector<Tolerance> take_tolerances(CaseFile& file) {
  std::vector<Tolerance> found;
  walk(file.root, "", found);
  return found;
}

}  // namespace parison::core
