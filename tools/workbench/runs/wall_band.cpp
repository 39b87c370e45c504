// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/runs/wall_band.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/case/case_error.hpp"
#include "forming/study/search/outcome.hpp"

namespace parison::tools {
namespace {

using forming::WallTable;

/// A table, or nothing where it is not there or refused, with the sentence.
std::optional<WallTable> read(const std::string& path, std::string& problem) {
  try {
    return forming::read_wall_table(path);
  } catch (const core::CaseError& error) {
    problem = error.what();
    return {};
  }
}

/// The thickness that is wanted at the place of a row and how far it may be off; arcs as shares of their whole length.
std::pair<double, double> wanted_at(const WallTable& wanted, const WallTable& wall, std::size_t row) {
  const double at = wanted.over_arc ? wall.at[row] / wall.arc_end * wanted.arc_end : wall.height[row];
  const double tolerance = forming::linear(wanted.at, wanted.tolerance, at);
  return {forming::linear(wanted.at, wanted.thickness, at), std::isfinite(tolerance) ? tolerance : 0};
}

/// Half of the lengths to the neighbours of a row.
double length_at(const WallTable& wall, std::size_t row) {
  const std::size_t last = wall.at.size() - 1;
  return 0.5 * (wall.at[std::min(row + 1, last)] - wall.at[row > 0 ? row - 1 : 0]);
}

}  // namespace

void add_wall_band(const std::string& folder, const std::string& wanted_file, core::JsonWriter& json) {
  std::string problem, ignored;
  const auto wall = read(folder + "/thickness.csv", ignored);
  if (!wall) return;
  const auto wanted = wanted_file.empty() ? std::nullopt : read(wanted_file, problem);
  if (!problem.empty()) json.add("wanted_problem", problem);
  double outside = 0, whole = 0, worst = 0, worst_z = 0;
  json.open_list("wall");
  for (std::size_t i = 0; i < wall->at.size(); ++i) {
    json.open_list("");
    json.add("", wall->height[i]);
    json.add("", wall->thickness[i]);
    if (wanted) {
      const auto [middle, tolerance] = wanted_at(*wanted, *wall, i);
      json.add("", middle - tolerance);
      json.add("", middle + tolerance);
      const double off = wall->thickness[i] - middle, beyond = std::abs(off) - tolerance;
      whole += length_at(*wall, i);
      if (beyond > 0) outside += length_at(*wall, i);
      if (beyond > std::abs(worst)) worst = std::copysign(beyond, off), worst_z = wall->height[i];
    }
    json.close();
  }
  json.close();
  if (!wanted) return;
  json.add("outside", outside / whole);
  json.add("worst_mm", worst);
  json.add("worst_z_mm", worst_z);
}

}  // namespace parison::tools
