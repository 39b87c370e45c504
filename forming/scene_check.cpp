// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>

#include "forming/scene_reading.hpp"

namespace parison::forming {
namespace {

constexpr double touching = 1e-6;  // bodies may overlap by this much at the start, m

/// Points along an outline, dense enough to find any overlap worth naming.
std::vector<core::Point> samples(const core::Profile& profile) {
  double perimeter = 0;
  for (const auto& segment : profile.segments) perimeter += core::length(segment);
  return core::polyline(profile, perimeter / 2000, touching / 2);
}

struct DeepPoint {
  core::Point point;
  double depth;  ///< m
};

/// The one of `points`, moved by `shift`, that lies deepest inside the outline.
DeepPoint deepest(const std::vector<core::Point>& points, const core::Point& shift, const core::Profile& profile) {
  DeepPoint result{core::Point::Zero(), 0};
  for (const auto& x : points)
    if (core::contains(profile, x + shift))
      if (const double depth = core::distance(profile, x + shift); depth > result.depth) result = {x, depth};
  return result;
}

bool can_touch(const Body& body) {
  const auto contact = [](const Piece& piece) { return piece.kind == PieceKind::contact; };
  return std::any_of(body.pieces.begin(), body.pieces.end(), contact);
}

}  // namespace

void refuse_repeated_names(const std::vector<const core::CaseNode*>& tables) {
  std::vector<std::string> names;
  for (const auto* table : tables)
    for (const auto& item : table->items)
      if (item.name == "name") {
        if (std::count(names.begin(), names.end(), core::text(item)))
          core::refuse(item, fmt::format("\"{}\" was found twice, allowed are different names", item.text));
        names.push_back(item.text);
      }
}

void check_no_overlap(const Scene& scene, const std::vector<const core::CaseNode*>& tools) {
  if (scene.stages.empty()) return;
  const auto glass = samples(scene.glass.profile);
  for (const auto& entry : scene.stages.front().tools) {
    const auto& tool = scene.tools[entry.tool];
    const core::Point shift = tool.position * core::axis_direction();
    auto inside = deepest(glass, -shift, tool.profile);
    auto other = deepest(samples(tool.profile), shift, scene.glass.profile);
    other.point += shift;
    if (other.depth > inside.depth) inside = other;
    if (inside.depth > touching)
      core::refuse(
          *tools[entry.tool],
          fmt::format("\"{}\" overlaps the glass at the start by {:.3g} mm, beside ({:g}, {:g}) mm; allowed is "
                      "contact to within {:g} mm",
                      tool.name, 1e3 * inside.depth, 1e3 * inside.point[0], 1e3 * inside.point[1], 1e3 * touching));
  }
}

void check_interfaces(const Scene& scene, const std::vector<const core::CaseNode*>& stages) {
  if (!scene.has_heat() || !can_touch(scene.glass)) return;
  for (std::size_t i = 0; i < scene.stages.size(); ++i)
    for (const auto& entry : scene.stages[i].tools) {
      const auto& tool = scene.tools[entry.tool];
      const auto joins = [&](const Interface& interface) { return interface.tool == entry.tool; };
      if (!tool.thermal || !can_touch(tool) || std::any_of(scene.interfaces.begin(), scene.interfaces.end(), joins))
        continue;
      core::CaseNode place = *stages[i];
      place.key += ".tools";
      core::refuse(place,
                   fmt::format("the glass and \"{}\" can touch in stage \"{}\" but have no interface; allowed is an "
                               "[[interface]] that names the tool",
                               tool.name, scene.stages[i].name));
    }
}

}  // namespace parison::forming
