#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "core/io/json.hpp"
#include "forming/report/process/extremes.hpp"
#include "forming/report/thickness_profile.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Something that a process engineer would look at: a limit of the case that the run went beyond.
struct Flag {
  std::string name;  ///< tool_surface_above, glass_below, wall_below or mould_not_filled
  std::string tool;  ///< whose surface; empty for the glass
  std::string unit;  ///< of limit and value: degC, mm or %
  double limit, value;
  double time, first, seconds;  ///< of the value, of the first step beyond the limit, beyond it in all, s
  Point at;                     ///< of the value, m
  std::string sentence;         ///< with what to do
};
using FlagsRaised = std::vector<Flag>;

/// The flags of a run with what it remembers, its end at `end_time`, s, and its wall there.
FlagsRaised raised_flags(const Scene& scene, const Extremes& extremes, double end_time, const ThicknessRange& wall);

/// How the outer surface of the glass lies to the tools of the stage.
struct OuterSurface {
  double near_tools = 0;   ///< share within 0.2 mm of one
  double largest_gap = 0;  ///< m
  Point at = Point::Zero();
};

/// That glass which the stage blows has come to most of a mould and not to all of it by the run's end at `time`, s;
/// nothing where it has, or where so little of it is at tools that it may be blown freely from a ring.
std::optional<Flag> mould_not_filled(const Stage& stage, const OuterSurface& outer, double time);

/// The list `flags` of summary.json.
void add_flags(core::JsonWriter& json, const FlagsRaised& flags);

}  // namespace parison::forming
