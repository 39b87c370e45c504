// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "forming/scene/outline_place.hpp"
#include "forming/scene/read/scene_reading.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

namespace {

bool is_in(const Body& body, const core::Point& point) {
  const double on_outline = tolerance::on_outline * core::size(body.profile);
  return core::contains(body.profile, point) || core::distance(body.profile, point) <= on_outline;
}

/// What a probe outside its body may have instead, by the contact boundary that is closest to it.
std::string advice(const Body& body, const core::Point& point) {
  const auto place = closest_contact(body, point);
  if (!place) return "";
  return fmt::format("; with boundary = \"{}\" and a depth such as \"5 mm\" it follows the drawing",
                     body.profile.boundary_names[place->boundary]);
}

/// The point so deep behind the place of a boundary that is closest to the one given.
core::Point behind(const Body& body, Index boundary, const core::Point& near, double depth) {
  const auto place = *closest_place(body, near, [&](Index id) { return id == boundary; });
  return place.point - depth * place.normal;
}

}  // namespace

Probe read_probe(const CaseNode& node, const Scene& scene) {
  const CaseTable table(node, {"name", "body", "point", "boundary", "depth"});
  auto bodies = tool_names(scene);
  bodies.insert(bodies.begin(), "glass");
  Probe probe{core::identifier(table.get("name")), core::choice(table.get("body"), bodies),
              read_point(table.get("point"))};
  const Body& body = probe.body == 0 ? static_cast<const Body&>(scene.glass) : scene.tools[probe.body - 1];
  if (!body.thermal)
    core::refuse(table.get("body"), fmt::format("\"{}\" carries no heat, allowed are bodies that do", body.name));
  const auto *boundary = table.find("boundary"), *depth = table.find("depth");
  if (depth && !boundary)
    core::refuse(*depth, "a depth was found, allowed only together with \"boundary\", behind which it is");
  if (!boundary) {
    if (!is_in(body, probe.point))
      core::refuse(table.get("point"), fmt::format("\"{}\" lies outside \"{}\", allowed are points inside or on its "
                                                   "outline{}",
                                                   table.get("point").text, body.name, advice(body, probe.point)));
    return probe;
  }
  const Index id = core::choice(*boundary, body.profile.boundary_names);
  probe.point = behind(body, id, probe.point, depth ? core::not_negative(*depth, dimension::length) : 0);
  if (!is_in(body, probe.point))
    core::refuse(*depth, fmt::format("({:.4g}, {:.4g}) mm, so far behind \"{}\", lies outside \"{}\", allowed are "
                                     "depths that end inside",
                                     1e3 * probe.point[0], 1e3 * probe.point[1], boundary->text, body.name));
  return probe;
}

}  // namespace parison::forming
