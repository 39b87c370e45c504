// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/data/wall_bars.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/io/files.hpp"
#include "forming/report/error_bars.hpp"
#include "forming/study/coarse_run.hpp"

namespace parison::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// Places to each side whose bars count too: a difference may vanish by chance at one of them.
constexpr int reach = 4;

/// The wall thickness at even places of the outer side, mm; empty where a summary has none.
std::vector<double> profile_of(const Json& summary) {
  std::vector<double> profile;
  const auto found = summary.is_object() ? summary.find("thickness_profile_mm") : summary.end();
  if (!summary.is_object() || found == summary.end() || !found->is_array()) return profile;
  for (const Json& value : *found) profile.push_back(value.is_number() ? value.get<double>() : none);
  return profile;
}

/// The bar at each place by the coarser runs; empty without one.
std::vector<double> bars_of(const std::string& folder, const Json& summary, const forming::Scene& scene) {
  const std::vector<double> own = profile_of(summary);
  if (own.empty() || !summary.contains("error_bars")) return {};
  std::vector<std::vector<forming::ValueOfRun>> values;
  for (const double value : own) values.push_back({{1, value}});
  for (const forming::CoarseCase& coarse : forming::coarse_cases(scene, folder)) {
    const std::string path = coarse.directory + "/summary.json";
    if (!std::filesystem::is_regular_file(path)) continue;
    const Json other = Json::parse(core::read_text(path), nullptr, false);
    const std::vector<double> profile = profile_of(other);
    if (profile.size() != own.size() || other.value("completed", Json()) != Json(true)) continue;
    for (std::size_t i = 0; i < own.size(); ++i) values[i].push_back({coarse.factor, profile[i]});
  }
  std::vector<double> bars;
  if (values.front().size() > 1)
    for (const auto& of_runs : values) bars.push_back(forming::bar_of_values(of_runs));
  return bars;
}

/// The largest bar near a share of the outer side.
double bar_at(const std::vector<double>& bars, double share) {
  double bar = none;
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

WallTables wall_tables(const std::string& folder, const Json& summary, const std::optional<forming::Scene>& scene) {
  WallTables wall{read_table(folder + "/heights.csv"), read_table(folder + "/thickness.csv")};
  const std::vector<double> bars = scene ? bars_of(folder, summary, *scene) : std::vector<double>{};
  const auto *arc = wall.profile.column("arc_mm"), *r = wall.profile.column("r_outer_mm"),
             *z = wall.profile.column("z_outer_mm");
  if (!arc || !r || !z || arc->empty()) return wall;
  const auto* height_r = wall.heights.column("r_outer_mm");
  const auto* height_z = wall.heights.column("z_mm");
  std::vector<double> along, over;
  along.reserve(arc->size());
  for (const double place : *arc) along.push_back(bar_at(bars, place / arc->back()));
  for (std::size_t i = 0; height_r && height_z && i < wall.heights.rows(); ++i)
    over.push_back(along[nearest_row(*r, *z, (*height_r)[i], (*height_z)[i])]);
  if (over.size() == wall.heights.rows() && !over.empty()) add_column(wall.heights, std::move(over));
  add_column(wall.profile, std::move(along));
  return wall;
}

}  // namespace parison::tools
