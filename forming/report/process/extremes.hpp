#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// The most extreme temperature that a body has had at the end of a step, and for how long it was beyond a limit.
struct Extreme {
  double temperature = std::numeric_limits<double>::quiet_NaN();   ///< K
  double time = 0;                                                 ///< of it, s
  Point at = Point::Zero();                                        ///< in the frame of the case, m
  double first_beyond = std::numeric_limits<double>::quiet_NaN();  ///< time of the first step beyond the limit, s
  double seconds_beyond = 0;  ///< duration of all steps that ended beyond it; of a tool, touching glass

  bool was_beyond() const { return seconds_beyond > 0; }
};

/// What a run remembers of temperatures: the hottest contact surface of each tool, the coldest glass.
struct Extremes {
  std::vector<Extreme> tools;  ///< against the limit Flags::tool_surface_above
  Extreme glass;               ///< against Flags::glass_below
};

/// Takes an accepted step into account; nothing without heat.
void update_extremes(const Scene& scene, const State& before, const State& state, Extremes& extremes);

}  // namespace parison::forming
