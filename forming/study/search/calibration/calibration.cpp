// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/search/calibration/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "core/case/given_file.hpp"
#include "core/io/files.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;

constexpr const char* time_heading = "time_s";
constexpr const char* temperature_ending = "_degC";

/// A table of numbers by its headings; a cell that is none is NaN.
struct Table {
  std::vector<std::string> headings;
  std::vector<std::vector<double>> rows;
  std::vector<int> lines;

  int find(const std::string& heading) const {
    const auto at = std::find(headings.begin(), headings.end(), heading);
    return at == headings.end() ? -1 : static_cast<int>(at - headings.begin());
  }
};

double number_in(std::string_view cell) {
  cell = core::trimmed(cell);
  double value = std::numeric_limits<double>::quiet_NaN();
  const auto read = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return read.ec == std::errc{} && read.ptr == cell.data() + cell.size() ? value
                                                                         : std::numeric_limits<double>::quiet_NaN();
}

Table read_table(const std::string& path) {
  const std::string text = core::read_text(path);
  Table table;
  core::Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    if (core::trimmed(line).empty()) continue;
    const auto cells = core::split_at_commas(line);
    if (table.headings.empty()) {
      for (const auto cell : cells) table.headings.emplace_back(core::trimmed(cell));
      continue;
    }
    std::vector<double> row;
    for (const auto cell : cells) row.push_back(number_in(cell));
    if (row.size() != table.headings.size())
      throw core::CaseError(fmt::format("{}:{}: {} cells were found, allowed are {} as in the heading", path,
                                        lines.number(), row.size(), table.headings.size()));
    table.rows.push_back(std::move(row));
    table.lines.push_back(lines.number());
  }
  return table;
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

void require_probe(const std::string& path, const std::string& probe, const Scene& scene) {
  std::vector<std::string> names;
  for (const Probe& one : scene.probes) names.push_back(one.name);
  if (std::count(names.begin(), names.end(), probe)) return;
  throw core::CaseError(
      fmt::format("{}:1: column \"{}{}\": the case has no probe \"{}\"{}, allowed are {}", path, probe,
                  temperature_ending, probe, core::did_you_mean(probe, names),
                  names.empty() ? "those of a case with probes" : fmt::format("{}", fmt::join(names, ", "))));
}

double longest_time(const Scene& scene) {
  double sum = 0;
  for (const Stage& stage : scene.stages) sum += stage.duration;
  return sum;
}

MeasuredCurve temperatures(const std::string& path, const Table& table, std::size_t column, const Scene& scene,
                           double noise) {
  const std::string& heading = table.headings[column];
  MeasuredCurve curve{path, heading.substr(0, heading.size() - std::string(temperature_ending).size()), false, {}, {},
                      noise};
  require_probe(path, curve.probe, scene);
  const auto time = static_cast<std::size_t>(table.find(time_heading));
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const double at = table.rows[i][time], value = table.rows[i][column];
    if (!std::isfinite(value)) continue;
    if (!(at >= 0 && at <= longest_time(scene)))
      throw core::CaseError(fmt::format("{}:{}: the time {} s was found, allowed is 0 to the end of the case, {} s",
                                        path, table.lines[i], at, longest_time(scene)));
    curve.at.push_back(at);
    curve.value.push_back(value);
  }
  return curve;
}

}  // namespace

std::vector<MeasuredCurve> read_measurements(const std::string& path, const Scene& scene,
                                             const CalibrationNoise& noise) {
  if (!fs::is_regular_file(path))
    throw core::CaseError(fmt::format("{}: no such file, allowed is a table of measurements", path));
  const Table table = read_table(path);
  std::vector<MeasuredCurve> curves;
  if (table.find("thickness_mm") >= 0) {
    if (!scene.has_flow())
      throw core::CaseError(
          fmt::format("{}: a wall was found and the glass of the case does not flow, allowed are "
                      "temperatures of its probes",
                      path));
    const WallTable wall = read_wall_table(path);
    curves.push_back({path, "", wall.over_arc, wall.at, wall.thickness, noise.thickness});
  } else if (table.find(time_heading) >= 0) {
    for (std::size_t i = 0; i < table.headings.size(); ++i)
      if (ends_with(table.headings[i], temperature_ending))
        curves.push_back(temperatures(path, table, i, scene, noise.temperature));
  }
  curves.erase(std::remove_if(curves.begin(), curves.end(), [](const auto& curve) { return curve.at.empty(); }),
               curves.end());
  if (curves.empty())
    throw core::CaseError(
        fmt::format("{}: no measurements were found, allowed are the columns time_s and PROBE_degC, "
                    "or thickness_mm and arc_mm or z_mm, with numbers",
                    path));
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
  if (curve.probe.empty()) {
    if (!fs::exists(folder + "/thickness.csv")) return std::nullopt;
    const WallTable wall = read_wall_table(folder + "/thickness.csv");
    x = curve.over_arc ? wall.at : wall.height;
    y = wall.thickness;
  } else {
    const Table table = read_table(folder + "/history.csv");
    const int time = table.find(time_heading), probe = table.find(curve.probe + temperature_ending);
    if (time < 0 || probe < 0) return std::nullopt;
    for (const std::vector<double>& row : table.rows) {
      x.push_back(row[std::size_t(time)]);
      y.push_back(row[std::size_t(probe)]);
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
