// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/data/wall_bars.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/math/numbers.hpp"
#include "forming/report/error_bars.hpp"

namespace parison::tools {
namespace {

using Json = nlohmann::ordered_json;

/// Places to each side whose bars count too: a difference may vanish by chance at one of them.
constexpr int reach = 4;

/// The bar at each even place of the outer side by the coarser runs; empty without one.
std::vector<double> bars_of(const forming::FinishedRun& run) {
  const std::vector<double>& own = run.quantities.profile;
  if (own.empty()) return {};
  std::vector<std::vector<forming::ValueOfRun>> values;
  for (const double value : own) values.push_back({{1, value}});
  for (const forming::FinishedRun& coarser : run.coarser) {
    const std::vector<double>& profile = coarser.quantities.profile;
    if (profile.size() != own.size()) continue;
    for (std::size_t i = 0; i < own.size(); ++i) values[i].push_back({coarser.factor, profile[i]});
  }
  std::vector<double> bars;
  if (values.front().size() > 1)
    for (const auto& of_runs : values) bars.push_back(forming::bar_of_values(of_runs));
  return bars;
}

/// The largest bar near a share of the outer side.
double bar_at(const std::vector<double>& bars, double share) {
  double bar = core::none;
  if (bars.empty() || !std::isfinite(share)) return bar;
  const int last = static_cast<int>(bars.size()) - 1;
  const int place = static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * last));
  for (int i = std::max(0, place - reach); i <= std::min(last, place + reach); ++i)
    bar = std::fmax(bar, bars[static_cast<std::size_t>(i)]);
  return bar;
}

/// The row of a table whose outer point is nearest to a place, mm.
std::size_t nearest_row(const std::vector<double>& r, const std::vector<double>& z, double at_r, double at_z) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < r.size(); ++i)
    if (std::hypot(r[i] - at_r, z[i] - at_z) < std::hypot(r[best] - at_r, z[best] - at_z)) best = i;
  return best;
}

void add_column(ResultTable& table, std::vector<double> values) {
  table.names.emplace_back("error_mm");
  table.numbers.push_back(std::move(values));
  table.texts.emplace_back();
}

}  // namespace

std::optional<forming::FinishedRun> run_with_coarser(const std::string& folder) {
  try {
    forming::FinishedRun run = forming::read_finished_run(folder);
    if (run.completed && !run.coarser.empty()) return run;
  } catch (const std::exception&) {  // a file that is damaged, or was edited, costs the bars and not the page
  }
  return std::nullopt;
}

void add_errors(const forming::FinishedRun& run, Json& summary) {
  const auto quantities = summary.find("quantities");
  if (summary.contains("error_bars") || quantities == summary.end() || !quantities->is_object()) return;
  for (const forming::Quantity& quantity : run.quantities.values)
    if (const auto found = quantities->find(quantity.name);
        found != quantities->end() && found->is_object() && std::isfinite(quantity.error))
      (*found)["error"] = quantity.error;
}

WallTables wall_tables(const std::string& folder, const std::optional<forming::FinishedRun>& run) {
  WallTables wall{read_table(folder + "/heights.csv"), read_table(folder + "/thickness.csv")};
  const std::vector<double> bars = run ? bars_of(*run) : std::vector<double>{};
  const auto *arc = wall.profile.column("arc_mm"), *r = wall.profile.column("r_outer_mm"),
             *z = wall.profile.column("z_outer_mm");
  if (!arc || !r || !z || arc->empty()) return wall;
  const auto* height_r = wall.heights.column("r_outer_mm");
  const auto* height_z = wall.heights.column("z_mm");
  std::vector<double> along, over;
  along.reserve(arc->size());
  const double start = run ? run->quantities.profile_start : 0, end = run ? run->quantities.profile_end : 0;
  for (const double place : *arc) along.push_back(bar_at(bars, (place - start) / (end - start)));
  for (std::size_t i = 0; height_r && height_z && i < wall.heights.rows(); ++i)
    over.push_back(along[nearest_row(*r, *z, (*height_r)[i], (*height_z)[i])]);
  if (over.size() == wall.heights.rows() && !over.empty()) add_column(wall.heights, std::move(over));
  add_column(wall.profile, std::move(along));
  return wall;
}

}  // namespace parison::tools
