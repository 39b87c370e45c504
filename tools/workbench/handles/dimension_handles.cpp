// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "core/case/arithmetic/named_dimensions.hpp"
#include "core/case/case_error.hpp"
#include "core/case/tolerance.hpp"
#include "core/case/units.hpp"
#include "forming/scene/read/scene_reading.hpp"
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
  double counts = 0;                                                  ///< by which corners are compared
};

/// How much a movement of a corner shows: most where a side that the glass may touch moves across itself.
double weight(const forming::Tool& tool, const std::vector<core::Segment>& segments, std::size_t corner,
              const core::Point& along) {
  double most = 0.01;
  for (const std::size_t i : {corner, (corner + segments.size() - 1) % segments.size()})
    if (tool.boundaries[segments[i].boundary_id].kind == core::BoundaryKind::contact)
      most = std::max(most, 0.2 + std::abs(core::normal_at(segments[i], i == corner ? 0 : 1).dot(along.normalized())));
  return most * along.norm();
}

/// The outlines of the tools of a case with what is set in it: nothing else is read, as that takes far longer.
std::vector<core::Profile> outlines_of(const std::string& file, const std::vector<std::string>& assignments) {
  const core::CaseFile evaluated = evaluated_case(file, assignments);
  std::vector<core::Profile> outlines;
  std::vector<std::string> notes;
  const core::CaseNode* tools = member(evaluated.root, "tool");
  for (std::size_t t = 0; tools && t < tools->items.size(); ++t)
    if (const core::CaseNode* boundaries = member(tools->items[t], "boundary"))
      outlines.push_back(forming::read_outline(*boundaries, evaluated.directory, notes));
  return outlines;
}

Moved most_moved(const forming::Scene& scene, const std::vector<core::Profile>& before,
                 const std::vector<core::Profile>& after, double step) {
  Moved most;
  for (std::size_t t = 0; t < before.size(); ++t) {  // a plate of standard cooling stands behind those of the file
    const forming::Tool& tool = scene.tools[t];
    const auto &from = before.at(t).segments, &to = after.at(t).segments;
    for (std::size_t i = 0; i < from.size() && i < to.size(); ++i) {
      const core::Point along = (to[i].start - from[i].start) / step;
      if (along.norm() < 1e-3) continue;
      if (const double counts = weight(tool, from, i, along); counts > 1.01 * most.counts)
        most = {tool.name, from[i].start + tool.position * core::axis_direction(), along, counts};
    }
  }
  return most;
}

/// The case with a dimension a little larger, or smaller where the reader refuses that.
Moved moved_by(const std::string& file, const forming::Scene& scene, const std::vector<core::Profile>& outlines,
               const std::string& name, const Length& length) {
  for (const double step : {0.02 * mm, -0.02 * mm}) {
    const std::string assignment =
        fmt::format("dimension.{}=\"{} {}\"", name, length.number + step / length.unit, length.unit_text);
    try {
      return most_moved(scene, outlines, outlines_of(file, {assignment}), step);
    } catch (const core::CaseError&) {
    }
  }
  return {};
}

}  // namespace

core::CaseFile evaluated_case(const std::string& case_file, const std::vector<std::string>& assignments) {
  core::CaseFile file = core::read_case_file(case_file);
  for (const std::string& assignment : assignments) core::override_value(file, assignment);
  core::take_tolerances(file);
  core::read_dimensions(file);
  return file;
}

void add_dimension_handles(const std::string& case_file, const forming::Scene& scene, core::JsonWriter& json) {
  constexpr std::size_t most_shown = 40;  // each takes a reading of the outlines
  std::size_t shown = 0;
  const std::vector<core::Profile> outlines = outlines_of(case_file, {});
  json.open_list("handles");
  for (const auto& dimension : scene.dimensions) {
    const auto length = length_of(dimension.given);
    if (!length || ++shown > most_shown) continue;
    const Moved moved = moved_by(case_file, scene, outlines, dimension.name, *length);
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
