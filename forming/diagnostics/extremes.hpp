#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

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
  /// A step that ended at such a time, s, beyond the limit, and took so long.
  void add_beyond(double when, double duration) {
    if (!was_beyond()) first_beyond = when;
    seconds_beyond += duration;
  }
  void set(double found, double when, const Point& where) { temperature = found, time = when, at = where; }
};

/// What a run remembers of temperatures: the hottest contact surface of each tool, the coldest glass.
struct Extremes {
  std::vector<Extreme> tools;  ///< against the limit Flags::tool_surface_above
  Extreme glass;               ///< against Flags::glass_below
};

/// Those of the start of a run; nothing without heat.
Extremes first_extremes(const Scene& scene, const State& start);

/// Takes an accepted step into account; nothing without heat.
void follow_extremes(const Scene& scene, const State& before, const State& state, Extremes& extremes);

template <typename Visitor, typename Record>
void visit_extreme(Visitor visit, Record& extreme) {
  visit("temperature", extreme.temperature);
  visit("time", extreme.time);
  visit("r", extreme.at[0]);
  visit("z", extreme.at[1]);
  visit("first_beyond", extreme.first_beyond);
  visit("seconds_beyond", extreme.seconds_beyond);
}

template <typename Visitor, typename Whole>
void visit_extremes(Visitor visit, Whole& extremes) {
  visit_extreme(visit.part("coldest_glass"), extremes.glass);
  for (std::size_t i = 0; i < extremes.tools.size(); ++i)
    visit_extreme(visit.part(fmt::format("hottest_tool_{}", i)), extremes.tools[i]);
}

}  // namespace parison::forming
