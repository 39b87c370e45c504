#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/study/production/heat_cycles.hpp"

namespace parison::forming {

/// A temperature that a tool is to settle to: the mean of its contact surface over the cycle, as SurfaceRange::mean.
struct WantedTool {
  std::string name;
  double temperature;  ///< K
};

/// What cools a boundary of a tool in production.
struct Cooling {
  std::string tool, boundary;
  double h;  ///< W/m2/K

  /// The key of the case that says h.
  std::string key() const;
};

/// Throws core::CaseError for a tool that is not in the scene, not used, wanted twice, or without a `cooled` boundary
/// of constant h, for a temperature that does not lie between those of its cooling and of the glass, and for one at
/// which the surface without glass loses more to the air than the glass has. What else no cooling gives only a forming
/// run can say: how much of a tool the glass touches, and how well.
void check_wanted(const Scene& scene, const MachineCycle& cycle, const std::vector<WantedTool>& wanted);

/// The `cooled` boundaries of the wanted tools as the scene has them.
std::vector<Cooling> cooling_of(const Scene& scene, const std::vector<WantedTool>& wanted);

/// The scene, and its overrides, with this h of a boundary.
void set_cooling(Scene& scene, const Cooling& cooling);

/// Cooling with which the tools settle to wanted temperatures. All cooled boundaries of a tool share one factor.
struct CoolingSearch {
  const State& initial;
  const std::vector<WantedTool>& wanted;
  double tolerance;  ///< of the wanted temperatures, K
};

struct FoundCooling {
  bool changed = false;     ///< whether the scene has other cooling than before
  std::string failure;      ///< why there is none; empty where there is
  Eigen::VectorXd settled;  ///< tool temperatures to which heat-only cycles settle with it, K
};

/// Changes the cooling of the scene that `cycles` refer to until heat-only cycles with the heat of the run, which they
/// have learnt, settle to the wanted temperatures; nothing is changed where `settled`, to which they settle now, has
/// them. With constant heat from the glass the temperature of a surface is linear in 1/h: the secant method in 1/h, for
/// all tools at once. A surface is above its temperature at the gob by as much as in the run, in proportion to how much
/// hotter the glass is.
FoundCooling find_cooling(const CoolingSearch& search, const HeatCycles& cycles, const CycleRun& run,
                          const Eigen::VectorXd& settled, Scene& scene);

}  // namespace parison::forming
