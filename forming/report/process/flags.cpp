// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/process/flags.hpp"

#include <fmt/core.h>

#include "thermal/properties.hpp"

namespace parison::forming {
namespace {

double celsius(double kelvin) {
  return kelvin - thermal::content_reference;
}

Flag of_temperature(const char* name, const std::string& tool, double limit, const Extreme& extreme) {
  return {name,
          tool,
          "degC",
          celsius(limit),
          celsius(extreme.temperature),
          extreme.time,
          extreme.first_beyond,
          extreme.seconds_beyond,
          extreme.at,
          {}};
}

/// Whether a limit was passed for a time that a sentence can show: less is an instant.
bool lasted(const Extreme& extreme) {
  constexpr double shown = 0.005;  // s
  return extreme.seconds_beyond >= shown;
}

std::string place(const Flag& flag) {
  return fmt::format("({:.1f}, {:.1f}) mm", 1e3 * flag.at[0], 1e3 * flag.at[1]);
}

}  // namespace

FlagsRaised raised_flags(const Scene& scene, const Extremes& extremes, double end_time, const ThicknessRange& wall) {
  const Flags& limits = scene.output.flags;
  FlagsRaised flags;
  for (std::size_t i = 0; i < extremes.tools.size(); ++i) {
    if (!lasted(extremes.tools[i])) continue;
    Flag flag = of_temperature("tool_surface_above", scene.tools[i].name, limits.tool_surface_above, extremes.tools[i]);
    flag.sentence = fmt::format(
        "{} surface {:.0f} degC at {} at {:.2f} s, above {:.0f} degC for {:.2f} s in which glass touched it: glass may "
        "stick; cool the tool more "
        "or shorten the contact",
        flag.tool, flag.value, place(flag), flag.time, flag.limit, flag.seconds);
    flags.push_back(flag);
  }
  if (limits.glass_below && lasted(extremes.glass)) {
    Flag flag = of_temperature("glass_below", "", *limits.glass_below, extremes.glass);
    flag.sentence = fmt::format(
        "glass {:.0f} degC at {} at {:.2f} s, below {:.0f} degC for {:.2f} s: it may check or not fill; a hotter gob "
        "or tool, or a shorter contact",
        flag.value, place(flag), flag.time, flag.limit, flag.seconds);
    flags.push_back(flag);
  }
  if (limits.wall_below && wall.lowest < *limits.wall_below) {
    Flag flag{"wall_below", "",       "mm", 1e3 * *limits.wall_below, 1e3 * wall.lowest,
              end_time,     end_time, 0,    wall.lowest_at,           {}};
    flag.sentence =
        fmt::format("wall {:.2f} mm at {}, below {:.2f} mm: a heavier gob, or glass that is colder there in the blank",
                    flag.value, place(flag), flag.limit);
    flags.push_back(flag);
  }
  return flags;
}

std::optional<Flag> mould_not_filled(const MouldFilling& filling) {
  constexpr double filled_mould = 0.98;  // share of what faces a tool
  if (!filling.was_blown() || filling.share >= filled_mould) return {};
  Flag flag{"mould_not_filled", "",           "%", 100 * filled_mould, 100 * filling.share,
            filling.time,       filling.time, 0,   filling.at,         {}};
  flag.sentence = fmt::format(
      "mould not filled: of the outer surface that faces a tool {:.1f} % lies within {:g} mm of it when the blow ends "
      "at "
      "{:.2f} s, and {} is {:.2g} mm away; more pressure or time, or hotter glass",
      flag.value, 1e3 * near_tool, flag.time, place(flag), 1e3 * filling.largest_gap);
  return flag;
}

void add_flags(core::JsonWriter& json, const FlagsRaised& flags) {
  json.open_list("flags");
  for (const Flag& flag : flags) {
    json.open_object("");
    json.add("name", flag.name);
    if (!flag.tool.empty()) json.add("tool", flag.tool);
    json.add("unit", flag.unit);
    json.add("limit", flag.limit);
    json.add("value", flag.value);
    json.add("time_s", flag.time);
    json.add("first_s", flag.first);
    json.add("seconds", flag.seconds);
    json.add("r_mm", 1e3 * flag.at[0]);
    json.add("z_mm", 1e3 * flag.at[1]);
    json.add("sentence", flag.sentence);
    json.close();
  }
  json.close();
}

}  // namespace parison::forming
