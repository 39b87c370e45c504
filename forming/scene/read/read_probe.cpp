// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "forming/scene/read/scene_reading.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

Probe read_probe(const CaseNode& node, const Scene& scene) {
  const CaseTable table(node, {"name", "body", "point"});
  auto bodies = tool_names(scene);
  bodies.insert(bodies.begin(), "glass");
  const Probe probe{core::identifier(table.get("name")), core::choice(table.get("body"), bodies),
                    read_point(table.get("point"))};
  const Body& body = probe.body == 0 ? static_cast<const Body&>(scene.glass) : scene.tools[probe.body - 1];
  const double on_outline = tolerance::on_outline * core::size(body.profile);
  if (!body.thermal)
    core::refuse(table.get("body"), fmt::format("\"{}\" carries no heat, allowed are bodies that do", body.name));
  if (!core::contains(body.profile, probe.point) && core::distance(body.profile, probe.point) > on_outline)
    core::refuse(table.get("point"),
                 fmt::format("\"{}\" lies outside \"{}\", allowed are points inside or on its outline",
                             table.get("point").text, body.name));
  return probe;
}

}  // namespace parison::forming
