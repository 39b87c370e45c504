#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "forming/report/quantities.hpp"

namespace parison::forming {

/// Evenly spaced places of the outer surface at which a search looks at the wall.
inline constexpr std::size_t wall_places = 201;

/// The wall over the outer arc, from the rim on; between places that are wall, as at a heel, linear.
struct Wall {
  std::vector<double> radius, height;  ///< of the outer side, mm
  std::vector<double> thickness;       ///< mm
};

/// The part of the wall that counts, by height; the glass is weighed by the area of its outer side.
struct WallPart {
  double from, to;  ///< heights, mm
};

/// What a run of a search came to.
struct Outcome {
  std::string reason;  ///< why it has no results; empty with them
  /// Those of the summary, and `weight`, `hottest_TOOL`, `wall_rms` (of the part's deviation from its mean),
  /// `wall_min`.
  Quantities quantities;
  Wall wall;  ///< empty without one
};

/// The value at `at` of the line through the points (x, y), x ascending; that of the nearest end beyond them.
double linear(const std::vector<double>& x, const std::vector<double>& y, double at);

/// Reads summary.json and thickness.csv, of a container in space solid/meridians.csv, of a run that has come to its
/// end.
Outcome read_outcome(const std::string& folder, const WallPart& part);

/// Shares of the outer area of the part at each place; all zero where no place lies in it.
std::vector<double> area_shares(const Wall& wall, const WallPart& part);

/// Mean thickness of a part, mm.
double mean_thickness(const Wall& wall, const std::vector<double>& shares);

/// Adds `wall_rms` and `wall_min` of a part to the quantities, where a place lies in it.
void add_wall(const Wall& wall, const WallPart& part, Quantities& quantities);

/// The quantities that runs of a scene have for goals and limits, with their units; some only where the run makes them.
std::vector<Quantity> known_quantities(const Scene& scene);

/// The wall of a table with the columns thickness_mm and arc_mm, or without the latter z_mm (z_outer_mm), at its rows
/// that have a thickness; of those of one plane through the axis where an angle is given, in degrees as in angle_deg.
/// Such a table is thickness.csv of a run, in space meridians.csv; one that is wanted may have a column tolerance_mm.
struct WallTable {
  bool over_arc;
  std::vector<double> at, thickness;   ///< mm
  std::vector<double> radius, height;  ///< where the table has them
  std::vector<double> tolerance;       ///< to both sides; not a number without it
  double arc_end = 0;                  ///< of the last row, wall or not, mm
};
WallTable read_wall_table(const std::string& path, std::optional<double> angle = {});

}  // namespace parison::forming
