// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/arithmetic/named_dimensions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace parison::core {
namespace {

constexpr std::size_t most_entries = 500;
constexpr int longest_chain = 32;  // of entries that use each other

}  // namespace

void check_formula_name(const CaseNode& entry) {
  const auto allowed = [](unsigned char c) { return c < 128 && (std::isalnum(c) || c == '_'); };
  const std::string& name = entry.name;
  const bool starts_well = !name.empty() && !std::isdigit(static_cast<unsigned char>(name.front()));
  if (!starts_well || !std::all_of(name.begin(), name.end(), allowed) || name == "pi")
    refuse(entry, fmt::format("the name \"{}\" was found, allowed are names of letters, digits and _ that begin with a "
                              "letter, other than pi",
                              name));
}

namespace {

/// Finds the values of entries that use each other.
class Entries {
 public:
  explicit Entries(const CaseNode& table) {
    for (const CaseNode& entry : entries(table)) {
      check_formula_name(entry);
      nodes_[entry.name] = &entry;
      known_.names.push_back(entry.name);
    }
    if (nodes_.size() > most_entries)
      refuse(table, fmt::format("{} entries were found, allowed are up to {}", nodes_.size(), most_entries));
    known_.find = [this](std::string_view name) { return find(name); };
  }

  std::optional<Measure> find(std::string_view name) {
    const auto node = nodes_.find(name);
    if (node == nodes_.end()) return {};
    if (const auto done = measures_.find(name); done != measures_.end()) return done->second;
    if (std::count(open_.begin(), open_.end(), node->first))
      refuse(*node->second, fmt::format("it is used by itself ({} -> {}), allowed are entries without circles",
                                        fmt::join(open_, " -> "), node->first));
    if (open_.size() >= longest_chain)
      refuse(*node->second,
             fmt::format("entries that use each other over more than {} steps were found", longest_chain));
    open_.push_back(node->first);
    const Measure measure = value_of(*node->second);
    open_.pop_back();
    return measures_[node->first] = measure;
  }

 private:
  Measure value_of(const CaseNode& entry) {
    if (entry.kind == CaseNode::Kind::table || entry.kind == CaseNode::Kind::list)
      refuse(entry,
             fmt::format("a {} was found, allowed are quantities such as \"24 mm\"; keys that follow [dimension] "
                         "belong to it up to the next heading",
                         entry.kind == CaseNode::Kind::table ? "table" : "list"));
    if (entry.kind == CaseNode::Kind::number) return {quantity(entry, dimension::none), {}};
    refuse_tolerance_of_formula(entry);
    const auto parsed = parse_formula(entry.given.empty() ? text(entry) : entry.text, known_);
    if (!parsed.problem.empty()) refuse(entry, parsed.problem);
    return parsed.measure;
  }

  std::map<std::string, const CaseNode*, std::less<>> nodes_;
  std::map<std::string, Measure, std::less<>> measures_;
  std::vector<std::string> open_;  ///< whose values are being found, the last one by those before it
  NamedQuantities known_;
};

void attach(CaseNode& node, const std::shared_ptr<const NamedQuantities>& known) {
  node.known = known;
  for (CaseNode& item : node.items) attach(item, known);
}

}  // namespace

std::vector<NamedDimension> read_dimensions(CaseFile& file) {
  const auto& items = file.root.items;
  const auto table =
      std::find_if(items.begin(), items.end(), [](const CaseNode& item) { return item.name == "dimension"; });
  if (table == items.end()) return {};
  Entries all(*table);
  std::vector<NamedDimension> result;
  for (const CaseNode& entry : table->items) {
    const Measure measure = *all.find(entry.name);
    result.push_back(
        {entry.name, entry.kind == CaseNode::Kind::text ? entry.text : fmt::format("{}", entry.number), measure});
  }
  let_name(file, result);
  return result;
}

void let_name(CaseFile& file, const std::vector<NamedDimension>& named) {
  std::map<std::string, Measure, std::less<>> measures;
  auto known = std::make_shared<NamedQuantities>();
  for (const NamedDimension& one : named) {
    measures[one.name] = one.measure;
    known->names.push_back(one.name);
  }
  known->find = [measures](std::string_view name) -> std::optional<Measure> {
    const auto found = measures.find(name);
    return found == measures.end() ? std::nullopt : std::optional(found->second);
  };
  attach(file.root, known);
}

}  // namespace parison::core
