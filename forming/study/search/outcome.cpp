// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/search/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/case/case_error.hpp"
#include "core/io/csv.hpp"
#include "core/io/files.hpp"
#include "core/io/json_read.hpp"
#include "core/math/numbers.hpp"

namespace parison::forming {
namespace {

/// The first of such columns that a table has, -1 for none.
int column(const core::CsvTable& table, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const int found = table.find(name); found >= 0) return found;
  return -1;
}

Wall sample(const WallTable& table) {
  Wall wall;
  for (std::size_t i = 0; i < wall_places; ++i) {
    const double arc = table.arc_end * double(i) / double(wall_places - 1);
    wall.thickness.push_back(linear(table.at, table.thickness, arc));
    wall.radius.push_back(linear(table.at, table.radius, arc));
    wall.height.push_back(linear(table.at, table.height, arc));
  }
  return wall;
}

void add_summary(const core::JsonValue& summary, Quantities& quantities) {
  if (const core::JsonValue* glass = summary.find("glass"))
    if (const double mass = glass->number_of("mass_kg"); std::isfinite(mass))
      quantities.values.push_back({"weight", "g", 1e3 * mass, 1e3 * mass});
  if (const core::JsonValue* tools = summary.find("tools"))
    for (const core::JsonValue& tool : tools->items)
      if (const double hottest = tool.number_of("surface_temperature_max_degC"); std::isfinite(hottest))
        quantities.values.push_back({"hottest_" + tool.name, "degC", hottest, hottest});
}

}  // namespace

double linear(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto after = std::upper_bound(x.begin(), x.end(), at);
  if (after == x.begin()) return y.front();
  if (after == x.end()) return y.back();
  const auto i = static_cast<std::size_t>(after - x.begin());
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

WallTable read_wall_table(const std::string& path, std::optional<double> angle) {
  const core::CsvTable csv = core::read_csv(path);
  const int thickness_at = column(csv, {"thickness_mm"}), arc = column(csv, {"arc_mm"}),
            height = column(csv, {"z_mm", "z_outer_mm"}), radius = column(csv, {"r_mm", "r_outer_mm"}),
            tolerance = column(csv, {"tolerance_mm"}), place = arc >= 0 ? arc : height,
            plane = angle ? csv.find("angle_deg") : -1;
  if (thickness_at < 0 || place < 0)
    throw core::CaseError(
        fmt::format("{}:1: the heading \"{}\" was found, allowed is one with thickness_mm, and arc_mm or z_mm", path,
                    csv.heading_line));
  WallTable table{arc >= 0, {}, {}, {}, {}, {}, 0};
  for (const core::CsvTable::Row& row : csv.rows) {
    const auto cell = [&](int i) { return i >= 0 ? csv.number(row, i) : core::none; };
    constexpr double printed = 1e-3;  // deg, to which tables give it
    if (plane >= 0 && !(std::abs(cell(plane) - *angle) <= printed)) continue;
    const double at = cell(place), thickness = cell(thickness_at);
    if (std::isfinite(at)) table.arc_end = at;
    if (!std::isfinite(at) || !std::isfinite(thickness)) continue;
    if (!table.at.empty() && at <= table.at.back()) {
      if (table.over_arc && at == table.at.back()) continue;
      throw core::CaseError(fmt::format("{}:{}: the {} {} was found after {}, allowed are rising ones", path, row.line,
                                        table.over_arc ? "arc" : "height", at, table.at.back()));
    }
    table.at.push_back(at);
    table.thickness.push_back(thickness);
    table.radius.push_back(cell(radius));
    table.height.push_back(cell(height));
    table.tolerance.push_back(cell(tolerance));
  }
  if (table.at.size() < 2)
    throw core::CaseError(
        fmt::format("{}: {} rows with a thickness were found, allowed are at least two", path, table.at.size()));
  return table;
}

std::vector<double> area_shares(const Wall& wall, const WallPart& part) {
  std::vector<double> shares;
  double sum = 0;
  for (std::size_t i = 0; i < wall.thickness.size(); ++i) {
    const bool inside = wall.height[i] >= part.from && wall.height[i] <= part.to;
    shares.push_back(inside ? std::max(wall.radius[i], 0.0) : 0);
    sum += shares.back();
  }
  for (double& share : shares) share /= sum > 0 ? sum : 1;
  return shares;
}

double mean_thickness(const Wall& wall, const std::vector<double>& shares) {
  double mean = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) mean += shares[i] * wall.thickness[i];
  return mean;
}

void add_wall(const Wall& wall, const WallPart& part, Quantities& quantities) {
  const std::vector<double> shares = area_shares(wall, part);
  const double mean = mean_thickness(wall, shares);
  double squares = 0, least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < shares.size(); ++i) {
    squares += shares[i] * std::pow(wall.thickness[i] - mean, 2);
    if (shares[i] > 0) least = std::min(least, wall.thickness[i]);
  }
  if (!std::isfinite(least)) return;
  quantities.values.push_back({"wall_rms", "%", 100 * std::sqrt(squares) / mean, 100});
  quantities.values.push_back({"wall_min", "mm", least, least});
}

Outcome read_outcome(const std::string& folder, const WallPart& part) {
  const std::string path = folder + "/summary.json", round = folder + "/thickness.csv";
  const std::string wall = std::filesystem::exists(round) ? round : folder + "/solid/meridians.csv";
  const core::JsonValue summary = core::read_json_file(path).value_or(core::JsonValue{});
  if (!summary.flag_of("completed")) return {summary.text_of("reason"), {}, {}};
  Outcome outcome{"", read_quantities(summary), {}};
  add_summary(summary, outcome.quantities);
  if (outcome.quantities.find("thickness_mean") && std::filesystem::exists(wall)) {
    outcome.wall = sample(read_wall_table(wall));
    add_wall(outcome.wall, part, outcome.quantities);
  }
  return outcome;
}

std::vector<Quantity> known_quantities(const Scene& scene) {
  std::vector<Quantity> known{{"weight", "g", core::none, core::none}};
  if (scene.has_flow()) {
    known.push_back({"wall_rms", "%", core::none, core::none});
    known.push_back({"wall_min", "mm", core::none, core::none});
  }
  for (const Quantity& quantity : possible_quantities(scene))
    if (quantity.name != "thickness_min_at") known.push_back(quantity);  // it jumps: no search can follow it
  if (scene.has_heat())
    for (const Tool& tool : scene.tools) known.push_back({"hottest_" + tool.name, "degC", core::none, core::none});
  return known;
}

}  // namespace parison::forming
