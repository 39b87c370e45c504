// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/search/goal_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "forming/scene/accuracy.hpp"
#include "forming/study/setting_error.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
using Kind = Target::Kind;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int usual_runs = 120;

const Quantity& known_quantity(const CaseNode& node, const std::vector<Quantity>& known) {
  const std::string& name = core::text(node);
  std::vector<std::string> names;
  for (const Quantity& quantity : known) {
    if (quantity.name == name) return quantity;
    names.push_back(quantity.name);
  }
  core::refuse(node, fmt::format("no quantity \"{}\" was found{}, allowed are {}", name,
                                 core::did_you_mean(name, names), fmt::join(names, ", ")));
}

/// Refuses temperatures of the glass that nothing in the case is as hot or as cold as.
void require_reachable(const CaseNode& node, const Quantity& quantity, double value, const Scene& scene) {
  if (quantity.unit != "degC") return;
  constexpr double zero = 273.15;
  const TemperatureRange range = temperature_range(scene);
  if (value + zero < range.min_temperature || value + zero > range.max_temperature)
    core::refuse(node, fmt::format("{:g} degC was found, which no run can reach, allowed is what lies between the "
                                   "coldest and the hottest of the case, {:g} and {:g} degC",
                                   value, range.min_temperature - zero, range.max_temperature - zero));
}

void read_wall(const CaseNode& node, const std::string& directory, Target& target) {
  const std::string& text = core::text(node);
  if (text == "even") {
    target.kind = Kind::even_wall;
    return;
  }
  target.kind = Kind::wall;
  if (text.size() > 4 && text.substr(text.size() - 4) == ".csv") {
    const std::string path = (std::filesystem::path(directory) / text).string();
    if (!std::filesystem::is_regular_file(path))
      core::refuse(node, fmt::format("\"{}\" is no file, allowed is a table of the wall, from this file", text));
    target.wall = read_wall_table(path);
    return;
  }
  target.value = in_unit(read_measured(node), "mm", node);
  if (!(target.value > 0))
    core::refuse(node, fmt::format("\"{}\" was found, allowed are \"even\", a thickness above zero such as \"2.5 mm\", "
                                   "or a table such as \"wanted.csv\"",
                                   text));
}

WallPart read_part(const CaseTable& table) {
  WallPart part{-infinity, infinity};
  if (const CaseNode* from = table.find("from")) part.from = in_unit(read_measured(*from), "mm", *from);
  if (const CaseNode* to = table.find("to")) {
    part.to = in_unit(read_measured(*to), "mm", *to);
    if (!(part.to > part.from))
      core::refuse(*to, fmt::format("{:g} mm was found, allowed are heights above from, {:g} mm", part.to, part.from));
  }
  return part;
}

Target read_target(const CaseNode& node, const std::string& directory, const Scene& scene) {
  const CaseTable table(node, {"wall", "from", "to", "quantity", "value", "least", "most", "good_enough"});
  const std::vector<Quantity> known = known_quantities(scene);
  Target target{Kind::even_wall, "", 0, {}, read_part(table), 0};
  int goals = 0;
  std::string unit = "%";
  if (const CaseNode* wall = table.find("wall")) {
    ++goals;
    if (!scene.has_flow()) core::refuse(*wall, "the glass of the case does not flow, allowed are goals without a wall");
    read_wall(*wall, directory, target);
  }
  for (const auto& [key, kind] : {std::pair{"quantity", Kind::value}, {"least", Kind::least}, {"most", Kind::most}})
    if (const CaseNode* named = table.find(key)) {
      ++goals;
      const Quantity& quantity = known_quantity(*named, known);
      target.kind = kind;
      target.quantity = quantity.name;
      unit = quantity.unit;
      if (kind != Kind::value) continue;
      const CaseNode& value = table.get("value");
      target.value = in_unit(read_measured(value), quantity.unit, value);
      require_reachable(value, quantity, target.value, scene);
    }
  if (goals != 1)
    core::refuse(node, fmt::format("{} goals were found, allowed is one of wall, quantity, least and most", goals));
  if (const CaseNode* good = table.find("good_enough"))
    target.good_enough = in_unit(read_measured(*good), unit == "degC" ? "K" : unit, *good);
  return target;
}

void read_limits(const CaseTable& root, const Scene& scene, std::vector<Limit>& limits) {
  const std::vector<Quantity> known = known_quantities(scene);
  for (const CaseNode* node : root.tables("limit")) {
    const CaseTable table(*node, {"quantity", "at_least", "at_most"});
    const Quantity& quantity = known_quantity(table.get("quantity"), known);
    double low = -infinity, high = infinity;
    const auto read = [&](const char* key, bool at_least, double& end) {
      const CaseNode* given = table.find(key);
      if (!given) return;
      end = in_unit(read_measured(*given), quantity.unit, *given);
      limits.push_back({quantity.name, quantity.unit, end, at_least});
    };
    read("at_least", true, low);
    read("at_most", false, high);
    if (!std::isfinite(low) && !std::isfinite(high))
      core::refuse(*node, "no limit was found, allowed are at_least, at_most or both");
    if (low > high)
      core::refuse(*node,
                   fmt::format("at least {:g} and at most {:g} {} were found, which no run can reach, allowed is "
                               "at_most not below at_least",
                               low, high, quantity.unit));
  }
}

std::string accuracy_in(const CaseTable& root, const char* key, const char* usual) {
  const CaseNode* node = root.find(key);
  const std::string text = node ? core::text(*node) : usual;
  if (text != "none" && read_accuracy(text).target)
    core::refuse(*node,
                 fmt::format("\"{}\" was found, allowed are draft, standard, fine, coarser or finer ones", text));
  return text;
}

/// The case with what holds for all runs; what it refuses of that carries its place in the goal file.
Scene scene_with_settings(const CaseTable& root, const Goal& goal) {
  try {
    return read_scene(goal.case_path, goal.accuracy, goal.overrides);
  } catch (const core::CaseError& error) {
    const CaseNode* set = root.find("set");
    if (!set || error.file != "--set" || error.key.empty()) throw;
    for (const CaseNode& assignment : set->items)
      if (assignment.text.rfind(error.key, 0) == 0) core::refuse(assignment, refusal_text(error));
    core::refuse(*set, refusal_text(error));
  }
}

}  // namespace

Goal read_goal(const std::string& path,
               const std::function<std::string(const std::string&, const std::string&)>& find_case) {
  const core::CaseFile file = core::read_case_file(path);
  const CaseTable root(file.root, {"case", "accuracy", "confirm", "set", "runs", "variable", "goal", "limit"});
  Goal goal;
  goal.file = file.path;
  goal.directory = file.directory;
  goal.name = std::filesystem::path(file.path).stem().string();
  goal.case_path = find_case(file.directory, core::text(root.get("case")));
  goal.accuracy = accuracy_in(root, "accuracy", "draft");
  goal.confirm = accuracy_in(root, "confirm", "standard");
  if (goal.accuracy == "none") core::refuse(root.get("accuracy"), "\"none\" was found, allowed is an accuracy");
  if (goal.confirm == "none") goal.confirm.clear();
  if (const CaseNode* set = root.find("set"))
    for (const CaseNode& assignment : core::list(*set)) goal.overrides.push_back(core::text(assignment));
  const CaseNode* runs = root.find("runs");
  goal.runs = static_cast<std::size_t>(runs ? core::count(*runs) : usual_runs);
  const Scene scene = scene_with_settings(root, goal);
  goal.variables = read_search_variables(root, goal.file, goal.case_path, goal.overrides);
  goal.target = read_target(root.get("goal"), goal.directory, scene);
  read_limits(root, scene, goal.limits);
  if (goal.runs < goal.variables.size() + 2)
    throw core::CaseError(fmt::format("{}: runs: {} were found, allowed are at least two more than variables, {}",
                                      goal.file, goal.runs, goal.variables.size() + 2));
  return goal;
}

}  // namespace parison::forming
