// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "forming/report/cooling/cold_container.hpp"
#include "forming/report/wall/solid_wall.hpp"
#include "forming/solid/solid_memory.hpp"

namespace parison::forming {

SidesTension surface_tension(const SolidState& solid, double time) {
  SidesTension tension;
  if (!remembers(solid)) return tension;
  const NodalTensors stress = nodal_stress(solid);
  for (const core::QuadFace& face : solid.heat_faces) {
    const bool is_inner = face.boundary_id == static_cast<Index>(SolidSide::inner);
    for (const Index node : face.nodes) {
      const core::Vector3& at = solid.glass.mesh.nodes[node];
      keep_larger({largest_principal(stress.col(node)), {std::hypot(at[0], at[1]), at[2]}, time},
                  is_inner ? tension.inner : tension.outer);
    }
  }
  return tension;
}

std::optional<CooledContainer> cooled_container(const Scene& scene, const SolidState& solid, double capacity,
                                                double time) {
  if (!remembers(solid)) return {};
  CooledContainer cold;
  cold.tension = surface_tension(solid, time);
  const NodalTensors stress = nodal_stress(solid);
  for (Index node = 0; node < stress.cols(); ++node)
    cold.largest_tension = std::max(cold.largest_tension, largest_principal(stress.col(node)));
  cold.base = base_view(solid, scene.stages.back().gravity > 0 ? -1 : 1);
  cold.volume = whole_volume(solid);
  const SolidExtent extent = extent_of(solid);
  cold.height = extent.high - extent.low;
  cold.diameter = 2 * extent.radius;
  cold.capacity = capacity;
  return cold;
}

}  // namespace parison::forming
