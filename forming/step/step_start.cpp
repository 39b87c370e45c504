// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/step_start.hpp"

#include <algorithm>

#include "core/mesh/element.hpp"
#include "forming/step/cavities/trapped_air.hpp"
#include "forming/step/contact/film.hpp"

namespace parison::forming {

StepStart step_start(const Scene& scene, const State& state, double dt) {
  StepStart start{scene, state, dt, {}, {}, 0, {}, {}};
  if (!scene.has_flow()) return start;
  start.frozen = frozen_cells(scene, state);
  start.penetrations = penetrations(scene, state, 0);
  if (scene.stages[state.stage].trapped_air) seal_air(start);
  for (const auto& inside : start.penetrations) start.max_penetration = std::max(start.max_penetration, inside.depth);
  const core::Mesh& mesh = state.glass.mesh;
  double surface = 0;
  for (const auto& edge : mesh.boundary_edges())
    if (mesh.kind_of(edge) != BoundaryKind::symmetry)
      for (const auto& at : core::edge_rule(2))
        surface += core::map_edge_point(mesh, edge.nodes, scene.geometry, at).area;
  start.wall = 2 * core::volume(mesh, scene.geometry) / surface;
  return start;
}

}  // namespace parison::forming
