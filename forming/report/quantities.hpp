#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <string>
#include <vector>

#include "core/io/json.hpp"
#include "core/io/json_read.hpp"
#include "forming/report/thickness_profile.hpp"

namespace parison::forming {

struct Summary;

/// A quantity of interest, in the unit it is shown in.
struct Quantity {
  std::string name, unit;
  double value;
  double scale;  ///< what a share of it is taken of: its own size, for temperatures the span of the scene
  double error = std::numeric_limits<double>::quiet_NaN();                  ///< estimated; NaN where none was asked for
  Point place = Point::Constant(std::numeric_limits<double>::quiet_NaN());  ///< that it stands for, m; NaN for none
  /// What the best models were found to move a quantity of its kind, at most; 0 where the run has them, NaN where it
  /// was not measured.
  double model = std::numeric_limits<double>::quiet_NaN();
};

/// The model that a run used of a part of the physics, and the best one there is, by their names in a case.
struct ModelUse {
  std::string part, used, best;
};

/// Number of evenly spaced points of the wall-thickness profile along the outer arc, with both ends, from the axis, or
/// the middle of a rim, to the middle of the rim.
inline constexpr int profile_points = 401;

/// The quantities of interest of a run.
struct Quantities {
  std::vector<Quantity> values;
  /// Wall thickness at evenly spaced points of the outer arc, mm; NaN where there is no opposite side, and empty where
  /// the scene has no wall.
  std::vector<double> profile;
  double profile_start = 0, profile_end = 0;  ///< arcs of its first and last point, mm
  std::vector<ModelUse> models = {};

  const Quantity* find(const std::string& name) const;
};
Quantities quantities(const Scene& scene, const State& state, const Summary& summary, const ThicknessProfile& wall);

/// The quantities that a run of a scene may have, with their units and without values; with the scale where that is
/// known before the run, or at least so large. Some are there only where the
/// run makes them: of the wall where the glass has become one, the heat of a tool that took up some, a peak force of
/// one that was pressed on.
std::vector<Quantity> possible_quantities(const Scene& scene);

/// Where no quantity has a name, the sentence that refuses it, with the nearest name and all that are allowed; else
/// empty.
std::string unknown_quantity(const std::string& name, const std::vector<Quantity>& known);

/// To and from the `quantities`, `models` and `thickness_profile_mm` of a summary.json.
void add_quantities(core::JsonWriter& json, const Quantities& quantities);
Quantities read_quantities(const core::JsonValue& summary);

/// How two profiles differ, as shares of the second one.
struct ProfileDifference {
  double mean, max;  ///< NaN without a profile
  double where;      ///< share of the arc where it is largest
};
/// Over the points that are wall in both profiles and lie farther than `profile_margin` of the arc from any point that
/// is not wall: there the finish begins and the thickness jumps.
ProfileDifference compare_profiles(const std::vector<double>& profile, const std::vector<double>& reference);
inline constexpr double profile_margin = 0.02;

/// Sum of the errors of the heats into the tools over the whole heat into them; NaN where no tool received any.
double heat_difference(const Quantities& run, const Quantities& reference);

}  // namespace parison::forming
