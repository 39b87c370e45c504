// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/solid_end.hpp"

#include <algorithm>
#include <cmath>

#include "core/solid/hex_geometry.hpp"
#include "forming/solid/solid_step.hpp"

namespace parison::forming {

namespace {

using core::Vector3;

/// Calls work(face, point) for the points of contact of each face of the surface but for planes of symmetry.
template <typename Work>
void for_surface_points(const SolidState& solid, const Work& work) {
  for (std::size_t f = 0; f < solid.faces.size(); ++f)
    for (const core::HexFacePoint& point : core::map_hex_face(core::face_nodes(solid.glass.mesh, solid.faces[f]),
                                                              solid.faces[f], flow::contact_points_along))
      work(f, point);
}

double mean_surface_temperature(const SolidState& solid) {
  double sum = 0, area = 0;
  for_surface_points(solid, [&](std::size_t face, const core::HexFacePoint& point) {
    const auto nodes = core::face_node_numbers(solid.glass.mesh, solid.faces[face]);
    area += point.area;
    for (int n = 0; n < 9; ++n) sum += point.area * point.shape[n] * solid.glass.temperature[nodes[n]];
  });
  return sum / area;
}

/// Share of the surface on which the stage sets no pressure that is near a tool of the stage.
double share_near_tools(const Scene& scene, const State& clock, double stage_time, const SolidState& solid,
                        double within) {
  const Stage& stage = scene.stages[clock.stage];
  const bool blown = stage.pressure.count(inner_side) > 0;
  double near = 0, whole = 0;
  for_surface_points(solid, [&](std::size_t face, const core::HexFacePoint& point) {
    if (blown && solid.heat_faces[face].boundary_id == static_cast<Index>(SolidSide::inner)) return;
    whole += point.area;
    for (const SolidTool& tool : solid.tools) {
      if (!stage.uses(tool.tool)) continue;
      const Vector3 offset = tool_offset(scene, clock, tool.tool, stage_time) * Vector3::UnitZ();
      if (tool.surface->gap(point.position - offset).distance > within) continue;
      near += point.area;
      return;
    }
  });
  return whole > 0 ? near / whole : 0;
}

double lowest_place(const Stage& stage, const SolidState& solid) {
  const auto lower = [](const Vector3& a, const Vector3& b) { return a[2] < b[2]; };
  const auto& nodes = solid.glass.mesh.nodes;
  const auto [least, most] = std::minmax_element(nodes.begin(), nodes.end(), lower);
  return stage.gravity > 0 ? (*most)[2] : (*least)[2];
}

}  // namespace

EndMeasure end_measure(const Scene& scene, const State& clock, double stage_time, const SolidState& solid) {
  return [&, stage_time](const EndCondition& end) {
    const Stage& stage = scene.stages[clock.stage];
    switch (end.kind) {
      case EndCondition::Kind::force:
        break;  // who reads a case refuses it
      case EndCondition::Kind::filled:
        return share_near_tools(scene, clock, stage_time, solid, end.within);
      case EndCondition::Kind::surface_below:
      case EndCondition::Kind::surface_above:
        return mean_surface_temperature(solid);
      case EndCondition::Kind::lowest:
        return lowest_place(stage, solid);
    }
    return 0.0;
  };
}

}  // namespace parison::forming
