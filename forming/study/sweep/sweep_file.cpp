// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/case/case_file.hpp"
#include "core/case/given_file.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/study/sweep/design.hpp"
#include "forming/study/sweep/sweep_plan.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;

std::string text_of(const CaseNode& node) {
  if (node.kind == CaseNode::Kind::number) return fmt::format("{}", node.number);
  if (node.kind == CaseNode::Kind::flag) return node.flag ? "true" : "false";
  if (node.kind != CaseNode::Kind::text || node.text.empty())
    core::refuse(node, "a table, a list or nothing was found, allowed are texts, numbers, true and false");
  return node.text;
}

/// Levels at even distances, the bounds among them.
void read_levels(const CaseTable& table, SweepVariable& variable) {
  const int number = core::count(table.get("number"));
  if (number < 2)
    core::refuse(table.get("number"), "1 was found, allowed are 2 or more, as both bounds are among them");
  for (int i = 0; i < number; ++i)
    variable.values.push_back(
        measure_text(variable.from + (variable.to - variable.from) * i / (number - 1), variable.unit));
}

SweepVariable read_variable(const CaseNode& node, Design design) {
  const CaseTable table(node, {"key", "values", "from", "to", "number"});
  SweepVariable variable;
  variable.key = core::text(table.get("key"));
  const bool between = table.find("from") || table.find("to");
  const bool has_levels = design == Design::grid || design == Design::list;
  if (const CaseNode* values = table.find("values")) {
    if (between) core::refuse(*values, "values beside from and to were found, allowed is one of both");
    for (const CaseNode& value : core::list(*values)) variable.values.push_back(text_of(value));
    if (variable.values.empty()) core::refuse(*values, "an empty list was found, allowed is at least one value");
  } else if (between) {
    const Bounds bounds = read_bounds(table);
    variable.from = bounds.from;
    variable.to = bounds.to;
    variable.unit = bounds.unit;
    if (has_levels) read_levels(table, variable);
  } else {
    core::refuse(node,
                 fmt::format("nothing that {} becomes was found, allowed are values, or from and to", variable.key));
  }
  if (const CaseNode* number = table.find("number"); number && !(between && has_levels))
    core::refuse(*number, "allowed is a number only of levels between from and to, in a grid or a list");
  return variable;
}

void read_variables(const CaseTable& root, Sweep& sweep) {
  for (const CaseNode* node : root.tables("variable")) {
    SweepVariable variable = read_variable(*node, sweep.design);
    for (const SweepVariable& other : sweep.variables)
      if (other.key == variable.key)
        core::refuse(*node, fmt::format("the key {} was found twice, allowed are different keys", variable.key));
    if (sweep.design == Design::list && !sweep.variables.empty() &&
        sweep.variables.front().values.size() != variable.values.size())
      core::refuse(*node, fmt::format("{} values of {} were found, allowed are as many as of {} in a list, {}",
                                      variable.values.size(), variable.key, sweep.variables.front().key,
                                      sweep.variables.front().values.size()));
    sweep.variables.push_back(std::move(variable));
  }
  if (sweep.variables.empty())
    throw core::CaseError(
        fmt::format("{}: no variable was found, allowed is at least one [[variable]] with a key and "
                    "its values",
                    sweep.file));
}

/// The number of runs: given for a design that draws them, that of the values for the others.
void read_runs(const CaseTable& root, Sweep& sweep) {
  const bool drawn = sweep.design == Design::latin_hypercube || sweep.design == Design::sobol;
  for (const char* key : {"runs", "seed"})
    if (const CaseNode* node = root.find(key); node && !drawn)
      core::refuse(*node, "allowed only with the designs latin_hypercube and sobol");
  double runs = 1;
  if (drawn)
    runs = core::count(root.get("runs"));
  else if (sweep.design == Design::list)
    runs = static_cast<double>(sweep.variables.front().values.size());
  else
    for (const SweepVariable& variable : sweep.variables) runs *= static_cast<double>(variable.values.size());
  if (runs > double(max_sweep_runs))
    throw core::CaseError(
        fmt::format("{}: {:g} runs were found, allowed are up to {}", sweep.file, runs, max_sweep_runs));
  sweep.runs = static_cast<std::size_t>(runs);
  if (const CaseNode* seed = root.find("seed")) {
    constexpr double largest = 4294967295;
    if (seed->kind != CaseNode::Kind::number || !(seed->number >= 0 && seed->number <= largest) ||
        seed->number != std::floor(seed->number))
      core::refuse(*seed, fmt::format("allowed is a whole number from 0 to {:.0f}", largest));
    sweep.seed = static_cast<std::uint64_t>(seed->number);
  }
  if (sweep.design == Design::sobol && sweep.variables.size() > max_sobol_dimensions)
    throw core::CaseError(fmt::format("{}: {} variables were found, allowed are up to {} in a Sobol sequence",
                                      sweep.file, sweep.variables.size(), max_sobol_dimensions));
}

std::string value_at(const SweepVariable& variable, double share) {
  if (variable.values.empty())
    return measure_text(variable.from + share * (variable.to - variable.from), variable.unit);
  return variable.values[static_cast<std::size_t>(share * static_cast<double>(variable.values.size()))];
}

}  // namespace

Sweep read_sweep(const std::string& path) {
  const core::CaseFile file = core::read_case_file(path);
  const CaseTable root(file.root,
                       {"case", "accuracy", "set", "design", "runs", "seed", "error_bars", "keep", "variable"});
  Sweep sweep;
  sweep.file = file.path;
  sweep.directory = file.directory;
  sweep.name = std::filesystem::path(file.path).stem().string();
  sweep.case_path = core::text(root.get("case"));
  sweep.accuracy = root.find("accuracy") ? core::text(root.get("accuracy")) : "draft";
  if (read_accuracy(sweep.accuracy).target)
    core::refuse(root.get("accuracy"), fmt::format("\"{}\" was found, allowed are draft, standard, fine, coarser or "
                                                   "finer ones",
                                                   sweep.accuracy));
  if (const CaseNode* set = root.find("set")) {
    for (const CaseNode& assignment : core::list(*set)) sweep.overrides.push_back(core::text(assignment));
    sweep.set = *set;
  }
  if (const CaseNode* design = root.find("design"))
    sweep.design = static_cast<Design>(core::choice(*design, {"grid", "list", "latin_hypercube", "sobol"}));
  if (const CaseNode* bars = root.find("error_bars")) sweep.error_bars = core::flag(*bars);
  if (const CaseNode* keep = root.find("keep")) sweep.keep = static_cast<Keep>(core::choice(*keep, {"all", "summary"}));
  read_variables(root, sweep);
  read_runs(root, sweep);
  return sweep;
}

std::vector<std::vector<std::string>> sweep_values(const Sweep& sweep) {
  const std::size_t variables = sweep.variables.size();
  std::vector<std::vector<std::string>> rows(sweep.runs, std::vector<std::string>(variables));
  const auto fill = [&](auto&& value) {
    for (std::size_t row = 0; row < rows.size(); ++row)
      for (std::size_t i = 0; i < variables; ++i) rows[row][i] = value(row, i);
  };
  if (sweep.design == Design::list) {
    fill([&](std::size_t row, std::size_t i) { return sweep.variables[i].values[row]; });
  } else if (sweep.design == Design::grid) {
    std::vector<std::size_t> levels;
    for (const SweepVariable& variable : sweep.variables) levels.push_back(variable.values.size());
    const auto grid = full_grid(levels);
    fill([&](std::size_t row, std::size_t i) { return sweep.variables[i].values[grid[row][i]]; });
  } else {
    const DesignPoints points = sweep.design == Design::sobol ? sobol_sequence(variables, sweep.runs, sweep.seed)
                                                              : latin_hypercube(variables, sweep.runs, sweep.seed);
    fill([&](std::size_t row, std::size_t i) { return value_at(sweep.variables[i], points[row][i]); });
  }
  return rows;
}

}  // namespace parison::forming
