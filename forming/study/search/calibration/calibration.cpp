// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/search/calibration/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <tuple>

#include "core/case/given_file.hpp"
#include "core/io/csv.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;

constexpr const char* time_heading = "time_s";
constexpr const char* what_is_read =
    "time_s and PROBE_degC, TOOL_position_mm or TOOL_force_N, or thickness_mm and arc_mm or z_mm, with numbers";

/// NaN where nothing was measured, which an empty cell or "nan" says.
double measured(const core::CsvTable& table, const core::CsvTable::Row& row, int column) {
  const std::string& cell = row.cells[static_cast<std::size_t>(column)];
  const double value = table.number(row, column);
  if (!std::isfinite(value) && !cell.empty() && cell != "nan")
    throw core::CaseError(fmt::format("{}:{}: {}: \"{}\" was found, allowed are a number, an empty cell and nan",
                                      table.path, row.line, table.heading[static_cast<std::size_t>(column)], cell));
  return value;
}

/// A bound, with the unit of the last one where it has none.
std::string with_unit(std::string_view bound, std::string_view last) {
  const std::size_t unit = last.find(' ');
  const bool bare = unit != last.npos && bound.find_first_not_of("+-.0123456789eE") == bound.npos;
  return std::string(bound) + std::string(bare ? last.substr(unit) : "");
}

bool ends_with(const std::string& text, const std::string& ending) {
  return text.size() > ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/// What histories are measured: the ending of their columns behind the name, and what is named.
struct HistoryKind {
  const char* ending;
  const char* what;
  std::vector<std::string> names;
  double noise;
};

template <class Things>
std::vector<std::string> names_of(const Things& things) {
  std::vector<std::string> names;
  for (const auto& thing : things) names.push_back(thing.name);
  return names;
}

std::vector<HistoryKind> history_kinds(const Scene& scene, const CalibrationNoise& noise) {
  return {{"_degC", "probe", names_of(scene.probes), noise.temperature},
          {"_position_mm", "tool", names_of(scene.tools), noise.position},
          {"_force_N", "tool", names_of(scene.tools), noise.force}};
}

/// The kind of a column; null for one that is no measurement of the case. A probe or tool that the case does not have,
/// and one with another unit, are refused.
const HistoryKind* kind_of(const core::CsvTable& table, const std::string& heading,
                           const std::vector<HistoryKind>& kinds) {
  for (const HistoryKind& kind : kinds) {
    if (!ends_with(heading, kind.ending)) continue;
    const std::string name = heading.substr(0, heading.size() - std::string_view(kind.ending).size());
    if (std::count(kind.names.begin(), kind.names.end(), name)) return &kind;
    throw core::CaseError(fmt::format("{}:1: column \"{}\": the case has no {} \"{}\"{}, allowed are {}", table.path,
                                      heading, kind.what, name, core::did_you_mean(name, kind.names),
                                      kind.names.empty() ? fmt::format("those of a case with {}s", kind.what)
                                                         : fmt::format("{}", fmt::join(kind.names, ", "))));
  }
  for (const HistoryKind& kind : kinds)
    for (const std::string& name : kind.names)
      if (heading.rfind(name + '_', 0) == 0)
        throw core::CaseError(fmt::format(
            "{}:1: column \"{}\": allowed are PROBE_degC, TOOL_position_mm and TOOL_force_N", table.path, heading));
  return nullptr;
}

/// How long histories are measured, s, and what ends them.
struct LongestTime {
  double seconds = 0;
  const char* end = "the end of the case";
};
LongestTime longest_time(const Scene& scene) {
  LongestTime longest;
  const std::size_t count = scene.solid ? static_cast<std::size_t>(scene.solid->from_stage) : scene.stages.size();
  for (std::size_t s = 0; s < count; ++s) longest.seconds += scene.stages[s].duration;
  if (scene.solid) longest.end = "where the glass becomes a body in space";
  return longest;
}

MeasuredCurve curve_over_time(const core::CsvTable& table, int column, double noise, const LongestTime& longest) {
  MeasuredCurve curve{table.path, table.heading[static_cast<std::size_t>(column)], false, {}, {}, noise};
  const int time = table.find(time_heading);
  for (const core::CsvTable::Row& row : table.rows) {
    const double at = measured(table, row, time), value = measured(table, row, column);
    if (!std::isfinite(value)) continue;
    if (!(at >= 0 && at <= longest.seconds))
      throw core::CaseError(fmt::format("{}:{}: the time {} s was found, allowed is 0 to {}, {} s", table.path,
                                        row.line, at, longest.end, longest.seconds));
    curve.at.push_back(at);
    curve.value.push_back(value);
  }
  return curve;
}

/// The thickness over the height, rising: of a wall that goes back at its end, as in a push-up, the part before.
std::pair<std::vector<double>, std::vector<double>> over_height(const WallTable& wall) {
  std::vector<double> height = wall.height, thickness = wall.thickness;
  if (height.back() < height.front()) {
    std::reverse(height.begin(), height.end());
    std::reverse(thickness.begin(), thickness.end());
  }
  std::pair<std::vector<double>, std::vector<double>> rising;
  for (std::size_t i = 0; i < height.size(); ++i)
    if (rising.first.empty() || height[i] > rising.first.back()) {
      rising.first.push_back(height[i]);
      rising.second.push_back(thickness[i]);
    }
  return rising;
}

/// The planes of solid/meridians.csv, deg.
std::array<double, 3> planes_in_space(const Scene& scene) {
  const double sector = scene.solid->sector * 180 / M_PI;
  return {0, 0.5 * sector, sector};
}

/// The plane of solid/meridians.csv in which an angle about the axis is, as sectors are mirrored; deg.
std::optional<double> plane_of(const Scene& scene, double angle) {
  const auto planes = planes_in_space(scene);
  const double turned = std::abs(std::remainder(angle, 2 * planes.back()));
  constexpr double same = 0.05;  // deg
  for (const double plane : planes)
    if (std::abs(turned - plane) < same) return plane;
  return {};
}

/// The walls of a table that has planes through the axis, one for each angle in it.
std::vector<MeasuredCurve> walls_in_space(const core::CsvTable& table, const Scene& scene, double noise) {
  const int column = table.find("angle_deg");
  if (column < 0)
    throw core::CaseError(fmt::format(
        "{}:1: a wall without angle_deg was found and the container is not round, allowed is one with it", table.path));
  std::vector<double> angles;
  for (const core::CsvTable::Row& row : table.rows) {
    const double angle = table.number(row, column);
    if (!std::isfinite(angle) || !plane_of(scene, angle))
      throw core::CaseError(fmt::format(
          "{}:{}: the angle \"{}\" was found, allowed are the planes {:g} deg, which come "
          "again in each sector",
          table.path, row.line, row.cells[static_cast<std::size_t>(column)], fmt::join(planes_in_space(scene), ", ")));
    if (!std::count(angles.begin(), angles.end(), angle)) angles.push_back(angle);
  }
  std::vector<MeasuredCurve> walls;
  for (const double angle : angles) {
    const WallTable wall = read_wall_table(table.path, angle);
    walls.push_back({table.path, "", wall.over_arc, wall.at, wall.thickness, noise, plane_of(scene, angle)});
  }
  return walls;
}

}  // namespace

std::string MeasuredCurve::name() const {
  return !column.empty() ? column : angle ? fmt::format("wall at {:g} deg", *angle) : "wall";
}

std::vector<MeasuredCurve> read_measurements(const std::string& path, const Scene& scene,
                                             const CalibrationNoise& noise) {
  if (!fs::is_regular_file(path))
    throw core::CaseError(fmt::format("{}: no such file, allowed is a table of measurements", path));
  const core::CsvTable table = core::read_csv(path);
  std::vector<MeasuredCurve> curves;
  if (table.find("thickness_mm") >= 0) {
    if (!scene.has_flow())
      throw core::CaseError(
          fmt::format("{}: a wall was found and the glass of the case does not flow, allowed are "
                      "temperatures of its probes",
                      path));
    if (scene.solid) {
      curves = walls_in_space(table, scene, noise.thickness);
    } else {
      const WallTable wall = read_wall_table(path);
      curves.push_back({path, "", wall.over_arc, wall.at, wall.thickness, noise.thickness});
    }
  } else if (table.find(time_heading) >= 0) {
    const std::vector<HistoryKind> kinds = history_kinds(scene, noise);
    for (const std::string& heading : table.heading)
      if (const HistoryKind* kind = kind_of(table, heading, kinds))
        curves.push_back(curve_over_time(table, table.find(heading), kind->noise, longest_time(scene)));
  }
  curves.erase(std::remove_if(curves.begin(), curves.end(), [](const auto& curve) { return curve.at.empty(); }),
               curves.end());
  if (curves.empty())
    throw core::CaseError(
        fmt::format("{}: no measurements were found, allowed are the columns {}", path, what_is_read));
  return curves;
}

std::vector<SearchVariable> varied_constants(const std::vector<std::string>& texts, const std::string& case_path,
                                             const std::vector<std::string>& overrides, bool with_flow) {
  constexpr double step_of_heat = 0.05;  // without flow a run has no noise, and a small step is the better derivative
  core::CaseNode tables;
  tables.kind = core::CaseNode::Kind::list;
  tables.name = "variable";
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('='), to = text.find(" to ");
    if (equals == text.npos || to == text.npos || to < equals)
      throw core::CaseError(
          fmt::format("--vary: \"{}\" was found, allowed is \"KEY=FROM to TO\", such as "
                      "\"interface.0.h0=100 W/m2/K to 2000 W/m2/K\"",
                      text));
    core::CaseNode table;
    table.file = "--vary";
    table.key = text.substr(0, equals);
    const auto add = [&](const char* name, std::string_view value) {
      core::CaseNode node;
      node.kind = core::CaseNode::Kind::text;
      node.file = "--vary";
      node.key = text.substr(0, equals);
      node.name = name;
      node.text = std::string(core::trimmed(value));
      table.items.push_back(node);
    };
    const std::string_view view = text;
    add("key", view.substr(0, equals));
    const std::string_view last = core::trimmed(view.substr(to + 4));
    add("from", with_unit(core::trimmed(view.substr(equals + 1, to - equals - 1)), last));
    add("to", last);
    tables.items.push_back(table);
  }
  core::CaseNode root;
  root.items.push_back(tables);
  for (core::CaseNode& table : root.items[0].items) {
    const core::CaseTable read(table, {"key", "from", "to"});
    const Bounds bounds = read_bounds(read);
    if (!(bounds.from > 0) || bounds.unit == "degC") continue;
    core::CaseNode scale = table.items[0];
    scale.name = "scale";
    scale.text = "logarithmic";
    table.items.push_back(scale);
  }
  auto variables = read_search_variables(core::CaseTable(root, {"variable"}), "--vary", case_path, overrides);
  for (SearchVariable& variable : variables)
    if (!with_flow && variable.logarithmic) variable.step = step_of_heat;
  return variables;
}

std::optional<std::vector<double>> model_at(const MeasuredCurve& curve, const std::string& folder) {
  std::vector<double> x, y, found;
  if (curve.column.empty()) {
    const std::string path = folder + (curve.angle ? "/solid/meridians.csv" : "/thickness.csv");
    if (!fs::exists(path)) return std::nullopt;
    WallTable wall = read_wall_table(path, curve.angle);
    const double start = curve.angle ? wall.at.front() : 0;  // arcs go on from plane to plane
    for (double& arc : wall.at) arc -= start;
    if (curve.over_arc)
      x = wall.at, y = wall.thickness;
    else
      std::tie(x, y) = over_height(wall);
  } else {
    const core::CsvTable table = core::read_csv(folder + "/history.csv");
    const int time = table.find(time_heading), column = table.find(curve.column);
    if (time < 0 || column < 0) return std::nullopt;
    for (const core::CsvTable::Row& row : table.rows) {
      x.push_back(table.number(row, time));
      y.push_back(table.number(row, column));
    }
  }
  if (x.size() < 2) return std::nullopt;
  for (const double at : curve.at) found.push_back(linear(x, y, at));
  return found;
}

std::optional<Eigen::VectorXd> misfit(const std::vector<MeasuredCurve>& curves, const std::string& folder) {
  std::vector<double> found;
  for (const MeasuredCurve& curve : curves) {
    const auto model = model_at(curve, folder);
    if (!model) return std::nullopt;
    for (std::size_t i = 0; i < model->size(); ++i) found.push_back(((*model)[i] - curve.value[i]) / curve.noise);
  }
  return Eigen::Map<const Eigen::VectorXd>(found.data(), Eigen::Index(found.size()));
}

}  // namespace parison::forming
