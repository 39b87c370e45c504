#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "core/io/json.hpp"
#include "forming/diagnostics/extremes.hpp"
#include "forming/report/process/mould_filling.hpp"
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

/// That glass which was blown into a mould has not come to all of it by the end of the stage; nothing where it has.
std::optional<Flag> mould_not_filled(const MouldFilling& filling);

/// The list `flags` of summary.json.
void add_flags(core::JsonWriter& json, const FlagsRaised& flags);

}  // namespace parison::forming
