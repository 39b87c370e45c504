// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cstdlib>
#include <optional>

#include "core/case/case_error.hpp"
#include "core/case/units.hpp"
#include "tools/workbench/handles/handles.hpp"

namespace parison::tools {
namespace {

constexpr double mm = 1e-3;

/// A dimension that is a number with a unit of length.
struct Length {
  double number, unit;  ///< as written; the unit in m
  std::string unit_text;
};

std::optional<Length> length_of(const std::string& given) {
  char* rest = nullptr;
  const double number = std::strtod(given.c_str(), &rest);
  if (rest == given.c_str()) return {};
  std::string unit(rest);
  unit.erase(0, unit.find_first_not_of(' '));
  const auto one = core::parse_quantity("1 " + unit, core::dimension::length);
  if (unit.empty() || !one.problem.empty()) return {};
  return Length{number, one.value, unit};
}

/// A corner of a tool and how it moves with a dimension.
struct Moved {
  std::string tool;
  core::Point at = core::Point::Zero(), along = core::Point::Zero();  ///< m; m for each m
};

Moved most_moved(const forming::Scene& before, const forming::Scene& after, double step) {
  Moved most;
  for (std::size_t t = 0; t < before.tools.size(); ++t) {
    const auto &from = before.tools[t].profile.segments, &to = after.tools[t].profile.segments;
    for (std::size_t i = 0; i < from.size() && i < to.size(); ++i) {
      const core::Point along = (to[i].start - from[i].start) / step;
      if (along.norm() > 1.01 * most.along.norm())
        most = {before.tools[t].name, from[i].start + before.tools[t].position * core::axis_direction(), along};
    }
  }
  return most;
}

/// The case with a dimension a little larger, or smaller where the reader refuses that.
Moved moved_by(const std::string& file, const forming::Scene& scene, const std::string& name, const Length& length) {
  for (const double step : {0.02 * mm, -0.02 * mm}) {
    std::vector<std::string> overrides = scene.overrides;
    overrides.push_back(
        fmt::format("dimension.{}=\"{} {}\"", name, length.number + step / length.unit, length.unit_text));
    try {
      return most_moved(scene, forming::read_scene(file, scene.accuracy_name, overrides), step);
    } catch (const core::CaseError&) {
    }
  }
  return {};
}

}  // namespace

void add_dimension_handles(const std::string& case_file, const forming::Scene& scene, core::JsonWriter& json) {
  constexpr std::size_t most_shown = 40;  // each takes a reading of the case
  std::size_t shown = 0;
  json.open_list("handles");
  for (const auto& dimension : scene.dimensions) {
    const auto length = length_of(dimension.given);
    if (!length || ++shown > most_shown) continue;
    const Moved moved = moved_by(case_file, scene, dimension.name, *length);
    if (moved.along.norm() < 0.01) continue;
    json.open_object("");
    json.add("name", dimension.name);
    json.add("tool", moved.tool);
    json.add("number", length->number);
    json.add("unit", length->unit_text);
    json.add("unit_mm", length->unit / mm);
    json.add("r_mm", moved.at[0] / mm);
    json.add("z_mm", moved.at[1] / mm);
    json.add("dr", moved.along[0]);
    json.add("dz", moved.along[1]);
    json.close();
  }
  json.close();
}

}  // namespace parison::tools
