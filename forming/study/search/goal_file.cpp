// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/case/units.hpp"
#include "core/math/numbers.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/study/search/goal.hpp"
#include "forming/study/setting_error.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
using Kind = Target::Kind;

constexpr int usual_runs = 120;
constexpr double usual_corrections = 1, most_corrections = 10;

const Quantity& known_quantity(const CaseNode& node, const std::vector<Quantity>& known) {
  const std::string& name = core::text(node);
  if (const std::string problem = unknown_quantity(name, known); !problem.empty()) core::refuse(node, problem);
  return *std::find_if(known.begin(), known.end(), [&](const Quantity& one) { return one.name == name; });
}

/// The case of a goal, and what its runs can reach.
struct Reach {
  const Scene& scene;
  std::vector<Quantity> known;
  TemperatureRange temperatures;  ///< of all runs, K
};

/// The temperatures in the case, with each variable at its bounds too.
TemperatureRange temperatures_of(const Goal& goal, const Scene& scene) {
  TemperatureRange range = temperature_range(scene);
  for (const SearchVariable& variable : goal.variables)
    for (const double end : {variable.low(), variable.high()}) {
      std::vector<std::string> overrides = goal.overrides;
      overrides.push_back(variable.key + '=' + variable.text(end));
      try {
        const TemperatureRange found = temperature_range(read_scene(goal.case_path, goal.accuracy, overrides));
        range = {std::min(range.min_temperature, found.min_temperature),
                 std::max(range.max_temperature, found.max_temperature)};
      } catch (const core::CaseError&) {
        continue;  // told with the corners of the bounds
      }
    }
  return range;
}

/// Weights, thicknesses and times are not negative; heat, heights and temperatures may be.
bool is_never_negative(const std::string& name) {
  static const std::vector<std::string> names{"weight",         "wall_rms",     "wall_min",     "thickness_min",
                                              "thickness_mean", "extent_r_max", "temper_number"};
  return std::count(names.begin(), names.end(), name) > 0 || name.rfind("time_", 0) == 0 ||
         name.rfind("peak_force_", 0) == 0 || name.rfind("residual_", 0) == 0 || name.rfind("cooling_", 0) == 0;
}

/// Refuses what lies beyond that which a quantity can be: `low` and `high` are where it is wanted.
void require_reachable(const CaseNode& node, const Quantity& quantity, double low, double high, const Reach& reach) {
  const double found = std::isfinite(low) ? low : high;
  const double coldest = reach.temperatures.min_temperature - core::zero_celsius,
               hottest = reach.temperatures.max_temperature - core::zero_celsius;
  if (quantity.unit == "degC" && (high < coldest || low > hottest))
    core::refuse(node, fmt::format("{:g} degC was found, which no run can reach, allowed is what lies between the "
                                   "coldest and the hottest of the case, {:g} and {:g} degC",
                                   found, coldest, hottest));
  if (is_never_negative(quantity.name) && high < 0)
    core::refuse(node,
                 fmt::format("{:g} {} was found, which no run can reach, allowed is 0 or more", found, quantity.unit));
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
  WallPart part{-core::infinity, core::infinity};
  if (const CaseNode* from = table.find("from")) part.from = in_unit(read_measured(*from), "mm", *from);
  if (const CaseNode* to = table.find("to")) {
    part.to = in_unit(read_measured(*to), "mm", *to);
    if (!(part.to > part.from))
      core::refuse(*to, fmt::format("{:g} mm was found, allowed are heights above from, {:g} mm", part.to, part.from));
  }
  return part;
}

/// What ends a search: a share of a wall, a difference of a value, the least or the most itself.
double read_good_enough(const CaseNode& node, const Target& target) {
  const bool difference = target.kind == Kind::value && target.unit == "degC";
  const double found = in_unit(read_measured(node), difference ? "K" : target.unit, node);
  if (!target.is_scalar() && !(found > 0))
    core::refuse(node, fmt::format("{:g} was found, allowed is more than 0, as runs scatter", found));
  return found;
}

Target read_target(const CaseNode& node, const std::string& directory, const Reach& reach) {
  const CaseTable table(node, {"wall", "from", "to", "quantity", "value", "least", "most", "good_enough"});
  Target target{Kind::even_wall, "", "%", 0, {}, read_part(table), {}};
  int goals = 0;
  if (const CaseNode* wall = table.find("wall")) {
    ++goals;
    if (!reach.scene.has_flow())
      core::refuse(*wall, "the glass of the case does not flow, allowed are goals without a wall");
    read_wall(*wall, directory, target);
  }
  for (const auto& [key, kind] : {std::pair{"quantity", Kind::value}, {"least", Kind::least}, {"most", Kind::most}})
    if (const CaseNode* named = table.find(key)) {
      ++goals;
      const Quantity& quantity = known_quantity(*named, reach.known);
      target.kind = kind;
      target.quantity = quantity.name;
      target.unit = quantity.unit;
      if (kind != Kind::value) continue;
      const CaseNode& value = table.get("value");
      target.value = in_unit(read_measured(value), quantity.unit, value);
      require_reachable(value, quantity, target.value, target.value, reach);
    }
  if (goals != 1)
    core::refuse(node, fmt::format("{} goals were found, allowed is one of wall, quantity, least and most", goals));
  if (const CaseNode* value = table.find("value"); value && target.kind != Kind::value)
    core::refuse(*value, "a value without a quantity was found, allowed is one only of a quantity");
  if (const CaseNode* good = table.find("good_enough")) target.good_enough = read_good_enough(*good, target);
  return target;
}

void read_limits(const CaseTable& root, const Reach& reach, std::vector<Limit>& limits) {
  for (const CaseNode* node : root.tables("limit")) {
    const CaseTable table(*node, {"quantity", "at_least", "at_most"});
    const Quantity& quantity = known_quantity(table.get("quantity"), reach.known);
    double low = -core::infinity, high = core::infinity;
    const auto read = [&](const char* key, bool at_least, double& end) {
      const CaseNode* given = table.find(key);
      if (!given) return;
      end = in_unit(read_measured(*given), quantity.unit, *given);
      require_reachable(*given, quantity, at_least ? end : -core::infinity, at_least ? core::infinity : end, reach);
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

/// None where the answer is not run at a finer accuracy than the search.
std::size_t read_corrections(const CaseTable& root, const Goal& goal) {
  double found = usual_corrections;
  if (const CaseNode* node = root.find("corrections")) {
    const std::string allowed = fmt::format("allowed is a whole number from 0 to {:g}", most_corrections);
    if (node->kind != CaseNode::Kind::number) core::refuse(*node, "no number was found, " + allowed);
    found = node->number;
    if (!(found >= 0 && found <= most_corrections && found == std::floor(found)))
      core::refuse(*node, fmt::format("{:g} was found, {}", found, allowed));
  }
  const auto level = [](const std::string& accuracy) { return read_accuracy(accuracy).effective_level(); };
  if (goal.confirm.empty() || level(goal.confirm) <= level(goal.accuracy)) return 0;
  return static_cast<std::size_t>(found);
}

/// The case with what holds for all runs; what it refuses of that carries its place in the goal file.
Scene scene_with_settings(const CaseTable& root, const Goal& goal) {
  try {
    return read_scene(goal.case_path, goal.accuracy, goal.overrides);
  } catch (const core::CaseError& error) {
    refuse_setting(root.find("set"), error);
  }
}

}  // namespace

Goal read_goal(const std::string& path,
               const std::function<std::string(const std::string&, const std::string&)>& find_case) {
  const core::CaseFile file = core::read_case_file(path);
  const CaseTable root(file.root,
                       {"case", "accuracy", "confirm", "set", "runs", "corrections", "variable", "goal", "limit"});
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
  goal.corrections = read_corrections(root, goal);
  const Scene scene = scene_with_settings(root, goal);
  goal.variables = read_search_variables(root, goal.file, goal.case_path, goal.overrides);
  const Reach reach{scene, known_quantities(scene), temperatures_of(goal, scene)};
  goal.target = read_target(root.get("goal"), goal.directory, reach);
  read_limits(root, reach, goal.limits);
  if (goal.runs < goal.variables.size() + 2)
    throw core::CaseError(fmt::format("{}: runs: {} were found, allowed are at least two more than variables, {}",
                                      goal.file, goal.runs, goal.variables.size() + 2));
  return goal;
}

}  // namespace parison::forming
