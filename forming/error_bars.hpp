#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>

#include "forming/quantities.hpp"
#include "forming/run.hpp"
#include "forming/scene.hpp"

namespace parison::forming {

/// Edges and steps of the companion run over those of the run itself.
inline constexpr double companion_factor = 1.5;

/// What a companion run says about a run: Richardson's estimate with the order that the dial's ladder showed. Quantities of one
/// kind lend each other the usual size of their differences, as one of them may vanish by chance.
struct ErrorBars {
  Quantities quantities;    ///< those of the run, with their errors
  double profile_mean, profile_largest;  ///< of the wall thickness, shares; NaN without a wall
  double heat;              ///< into all tools, a share; NaN without
  double companion_cpu_seconds = 0;
};
/// `expected_heat`: error of the heat into all tools known beforehand, a share; the tools' bars are not narrower than it says.
ErrorBars error_bars(const Quantities& run, const Quantities& companion, double expected_heat = 0);

/// Runs the coarser companion of a scene in the folder `companion` of its results, goes on with one that was stopped, or
/// reads one that is complete; none where it does not come to its end.
std::optional<ErrorBars> estimate_errors(const Scene& scene, const Quantities& run, const std::string& directory,
                                         const StopRequest& stop);

}  // namespace parison::forming
