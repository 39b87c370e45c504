// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/cycle_files.hpp"

#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/case/units.hpp"
#include "core/io/files.hpp"
#include "core/io/json.hpp"
#include "core/mesh/element.hpp"
#include "forming/study/production/tool_fields.hpp"

namespace parison::forming {

namespace {

using core::Index;
using core::Point;
using Entries = std::vector<Eigen::Triplet<double>>;

/// Places at equal distances along r and along z.
struct Grid {
  Point low, step;
  int across, along;

  int count() const { return across * along; }
  int index(int i, int k) const { return k * across + i; }
  Point at(int i, int k) const { return low + Point(i * step[0], k * step[1]); }
};

Grid grid_around(const core::Mesh& mesh) {
  constexpr double places = 400;
  Point low = mesh.nodes.front(), high = low;
  for (const Point& x : mesh.nodes) low = low.cwiseMin(x), high = high.cwiseMax(x);
  const Point size = high - low;
  const double spacing = std::sqrt(size[0] * size[1] / places);
  const auto cells = [&](double length) { return std::max(2, static_cast<int>(std::ceil(length / spacing))); };
  const int across = cells(size[0]), along = cells(size[1]);
  return {low, Point(size[0] / across, size[1] / along), across + 1, along + 1};
}

/// Adds weight (w.x - value)^2 to a sum of squares.
void add_square(const std::vector<std::pair<int, double>>& row, double value, double weight, Entries& matrix,
                Eigen::VectorXd& right) {
  for (const auto& [i, a] : row) {
    right[i] += weight * a * value;
    for (const auto& [k, b] : row) matrix.emplace_back(i, k, weight * a * b);
  }
}

/// The four places around a point and their bilinear weights.
std::vector<std::pair<int, double>> around(const Grid& grid, const Point& x) {
  const Point in = (x - grid.low).cwiseQuotient(grid.step);
  const int i = std::clamp(static_cast<int>(in[0]), 0, grid.across - 2);
  const int k = std::clamp(static_cast<int>(in[1]), 0, grid.along - 2);
  const double a = in[0] - i, b = in[1] - k;
  return {{grid.index(i, k), (1 - a) * (1 - b)},
          {grid.index(i + 1, k), a * (1 - b)},
          {grid.index(i, k + 1), (1 - a) * b},
          {grid.index(i + 1, k + 1), a * b}};
}

/// The field itself, by its values at the nodes and inside the cells.
void add_field(const Grid& grid, const core::Mesh& mesh, const Eigen::VectorXd& temperature, Entries& matrix,
               Eigen::VectorXd& right) {
  for (Index node = 0; node < mesh.node_count(); ++node)
    add_square(around(grid, mesh.nodes[node]), temperature[node], 1, matrix, right);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (const auto& rule : core::triangle_rule(4)) {
      const auto point = core::map_cell_point(mesh, cell, core::Geometry::planar, rule);
      double value = 0;
      for (int i = 0; i < 6; ++i) value += point.shape[i] * temperature[mesh.cells()[cell][i]];
      add_square(around(grid, point.position), value, 1, matrix, right);
    }
}

/// Small second differences, which decide only beyond the body.
void add_smoothness(const Grid& grid, Entries& matrix, Eigen::VectorXd& right) {
  constexpr double weight = 1e-3;
  for (int k = 0; k < grid.along; ++k)
    for (int i = 0; i < grid.across; ++i) {
      if (i + 2 < grid.across)
        add_square({{grid.index(i, k), 1}, {grid.index(i + 1, k), -2}, {grid.index(i + 2, k), 1}}, 0, weight, matrix,
                   right);
      if (k + 2 < grid.along)
        add_square({{grid.index(i, k), 1}, {grid.index(i, k + 1), -2}, {grid.index(i, k + 2), 1}}, 0, weight, matrix,
                   right);
    }
}

}  // namespace

std::string temperature_table_text(const core::Mesh& mesh, const Eigen::VectorXd& temperature) {
  constexpr double mm = 1e3;
  const Grid grid = grid_around(mesh);
  Entries entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(grid.count());
  add_field(grid, mesh, temperature, entries, right);
  add_smoothness(grid, entries, right);
  Eigen::SparseMatrix<double> matrix(grid.count(), grid.count());
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd values = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
  // Beyond the body no place is hotter or colder than the body.
  const double lowest = temperature.minCoeff(), highest = temperature.maxCoeff();
  std::string text = "r_mm,z_mm,T_degC\n";
  for (int k = 0; k < grid.along; ++k)
    for (int i = 0; i < grid.across; ++i) {
      const Point x = mm * grid.at(i, k);
      text += fmt::format("{:.6g},{:.6g},{:.1f}\n", x[0], x[1],
                          std::clamp(values[grid.index(i, k)], lowest, highest) - core::zero_celsius);
    }
  return text;
}

namespace {

void add_search(core::JsonWriter& json, const Scene& scene, const PeriodicState& state) {
  json.open_list("forming_runs");
  for (const SearchRun& run : state.search) {
    json.open_object("");
    json.open_object("surface_change_K");
    for (std::size_t t = 0; t < scene.tools.size(); ++t) json.add(scene.tools[t].name, run.change[t]);
    json.close();
    json.open_object("distance_K");
    for (std::size_t t = 0; t < scene.tools.size(); ++t) json.add(scene.tools[t].name, run.distance[t]);
    json.close();
    json.close();
  }
  json.close();
  json.open_list("plain_cycles_change_K");
  for (const double change : state.confirmed) json.add("", change);
  json.close();
}

void add_tool(core::JsonWriter& json, const Scene& scene, const PeriodicState& state, std::size_t t) {
  const Tool& tool = scene.tools[t];
  const CycleHeat& heat = state.settled.heat[t];
  const SurfaceRange range = range_of(state.settled.samples, t);
  json.open_object(tool.name);
  json.add("use_begin_s", state.cycle.uses[t].begin);
  json.add("use_end_s", state.cycle.uses[t].end);
  json.add("sets", static_cast<long>(state.cycle.sets[t]));
  json.add("surface_min_degC", range.min - core::zero_celsius);
  json.add("surface_mean_degC", range.mean - core::zero_celsius);
  json.add("surface_max_degC", range.max - core::zero_celsius);
  json.add("hottest_point_degC", range.hottest - core::zero_celsius);
  json.add("heat_received_J", heat.received);
  json.open_object("power_W");
  for (std::size_t b = 0; b < tool.boundaries.size(); ++b)
    json.add(tool.boundaries[b].name, heat.through[b] / state.cycle.seconds_of(t));
  json.close();
  if (tool.swab) {
    json.add("swab_heat_J", state.swab_heat[t]);
    json.add("swab_mean_power_W", state.swab_heat[t] / tool.swab->every / state.cycle.seconds_of(t));
  }
  json.close();
}

void add_changes(core::JsonWriter& json, const std::vector<CaseDifference>& changes) {
  json.open_list("changes");
  for (const CaseDifference& change : changes) {
    json.open_object("");
    json.add("key", change.key);
    json.add("base", change.before);
    json.add("other", change.now);
    json.close();
  }
  json.close();
}

/// Wanted temperatures and the cooling that was found for them.
void add_wanted(core::JsonWriter& json, const PeriodicRequest& request, const PeriodicState& state) {
  json.open_object("wanted_degC");
  for (const WantedTool& one : request.wanted) json.add(one.name, one.temperature - core::zero_celsius);
  json.close();
  json.open_object("cooling_W_m2K");
  for (const Cooling& one : state.cooling) json.add(one.key(), one.h);
  json.close();
}

std::string json_text(const Scene& scene, const PeriodicRequest& request, const PeriodicState& state,
                      const std::string& reason) {
  core::JsonWriter json;
  json.add("case", scene.name);
  json.add("accuracy", scene.accuracy_name);
  json.add("cycle_s", state.cycle.seconds);
  json.add("tolerance_K", request.tolerance);
  json.add("settled", state.found);
  json.add("confirmed", state.is_confirmed(request.tolerance));
  json.add("uncertainty_K", state.uncertainty);
  json.add("offset_K", state.offset);
  json.add("reason", reason);
  json.open_list("not_possible");
  for (const std::string& sentence : why_not_possible(scene, state.settled.samples)) json.add("", sentence);
  json.close();
  json.open_list("too_cold");
  for (const std::string& sentence : too_cold(scene, state.settled.samples)) json.add("", sentence);
  json.close();
  add_wanted(json, request, state);
  add_changes(json, request.changes);
  add_search(json, scene, state);
  json.add("start_up_cycles", static_cast<long>(std::max<std::size_t>(state.start_up.size(), 1) - 1));
  if (!state.start_up.empty()) json.add("start_up_end_distance_K", state.start_up.back().distance);
  json.open_object("tools");
  if (!state.settled.samples.empty())
    for (std::size_t t = 0; t < scene.tools.size(); ++t) add_tool(json, scene, state, t);
  json.close();
  return json.finish();
}

std::string cycle_text(const Scene& scene, const PeriodicState& state) {
  std::string text = "time_s,stage";
  for (const Tool& tool : scene.tools)
    text += ',' + core::csv_text(tool.name + "_surface_mean_degC") + ',' +
            core::csv_text(tool.name + "_surface_max_degC") + ',' + core::csv_text(tool.name + "_mean_degC");
  for (const Probe& probe : scene.probes)
    if (probe.body != glass_body) text += ',' + core::csv_text(probe.name + "_degC");
  text += '\n';
  for (const CycleSample& sample : state.settled.samples) {
    text += fmt::format("{:.10g},{}", sample.time, core::csv_text(sample.stage));
    for (const ToolTemperatures& tool : sample.tools)
      text += fmt::format(",{:.10g},{:.10g},{:.10g}", tool.surface_mean - core::zero_celsius,
                          tool.surface_max - core::zero_celsius, tool.mean - core::zero_celsius);
    for (std::size_t p = 0; p < scene.probes.size(); ++p)
      if (scene.probes[p].body != glass_body) text += fmt::format(",{:.10g}", sample.probes[p] - core::zero_celsius);
    text += '\n';
  }
  return text;
}

/// The surfaces of the tools cycle by cycle.
std::string cycles_text(const Scene& scene, const std::vector<StartUpCycle>& cycles) {
  std::string text = "cycle";
  for (const Tool& tool : scene.tools) text += ',' + core::csv_text(tool.name + "_surface_mean_degC");
  text += ",distance_K\n";
  for (std::size_t k = 0; k < cycles.size(); ++k) {
    text += fmt::format("{}", k);
    for (const double mean : cycles[k].mean) text += fmt::format(",{:.10g}", mean - core::zero_celsius);
    text += fmt::format(",{:.6g}\n", cycles[k].distance);
  }
  return text;
}

}  // namespace

void write_periodic_state(const Scene& scene, const PeriodicRequest& request, const PeriodicState& state,
                          const std::string& reason) {
  core::replace_file(request.directory + "/cycle.json", json_text(scene, request, state, reason));
  const std::string& folder = request.directory;
  if (!state.start_up.empty()) core::replace_file(folder + "/start_up.csv", cycles_text(scene, state.start_up));
  if (!state.since_swab.empty()) core::replace_file(folder + "/swab.csv", cycles_text(scene, state.since_swab));
  if (!state.settled.samples.empty()) core::replace_file(request.directory + "/cycle.csv", cycle_text(scene, state));
}

std::string periodic_table(const Scene& scene, const PeriodicState& state) {
  std::string text = fmt::format("\n  {:<14}{:>16}{:>34}{:>12}{:>12}{:>12}\n", "tool", "in use, s", "surface, degC",
                                 "hottest", "heat, kJ", "cooling, W");
  for (std::size_t t = 0; t < scene.tools.size(); ++t) {
    const SurfaceRange range = range_of(state.settled.samples, t);
    const CycleHeat& heat = state.settled.heat[t];
    double out = 0;
    for (std::size_t b = 0; b < heat.through.size(); ++b)
      if (scene.tools[t].boundaries[b].kind != BoundaryKind::contact) out += heat.through[b];
    text += fmt::format("  {:<14}{:>16}{:>34}{:>12.1f}{:>12.3f}{:>12.1f}\n", scene.tools[t].name,
                        fmt::format("{:.4g} to {:.4g}", state.cycle.uses[t].begin, state.cycle.uses[t].end),
                        fmt::format("{:.1f}  {:.1f}  {:.1f}", range.min - core::zero_celsius,
                                    range.mean - core::zero_celsius, range.max - core::zero_celsius),
                        range.hottest - core::zero_celsius, 1e-3 * heat.received, out / state.cycle.seconds_of(t));
  }
  text +=
      "  surface: the mean over it, the lowest, mean and highest in the cycle; hottest: of any place and time;\n"
      "  cooling: through the boundaries that no glass touches, what the contact surface loses to air is not in it\n";
  for (const std::string& sentence : why_not_possible(scene, state.settled.samples))
    text += fmt::format("\n  no possible production: {}\n", sentence);
  for (const std::string& sentence : too_cold(scene, state.settled.samples))
    text += fmt::format("\n  colder than production: {}\n", sentence);
  return text;
}

}  // namespace parison::forming
