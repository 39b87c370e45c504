// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/hand_over.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/process/run_error.hpp"
#include "core/solid/cell_stacks.hpp"
#include "forming/solid/solid_heat.hpp"
#include "forming/solid/solid_openings.hpp"
#include "forming/solid/swept_tool.hpp"
#include "forming/state/initial_state.hpp"
#include "remesh/solid/column_values.hpp"
#include "remesh/solid/wall_mesh.hpp"

namespace parison::forming {

namespace {

/// Half the width of the widest tool of the stages in space over that of the glass: by so much a cell is stretched.
double widening(const Scene& scene, const State& state) {
  double glass = 0, widest = 0;
  for (const Point& x : state.glass.mesh.nodes) glass = std::max(glass, x[0]);
  for (std::size_t s = static_cast<std::size_t>(scene.solid->from_stage); s < scene.stages.size(); ++s)
    for (const StageTool& entry : scene.stages[s].tools) {
      const Tool& tool = scene.tools[entry.tool];
      const auto contact = contact_boundaries(tool);
      for (const core::Segment& segment : tool.profile.segments)
        if (contact[segment.boundary_id] && !entry.moves() && !tool.section.is_round())
          widest = std::max(widest, core::point_at(segment, 0)[0]);
    }
  return std::max(1.0, widest / glass);
}

void add_side(const std::vector<core::HexFace>& faces, SolidSide side, SolidState& solid) {
  for (const core::HexFace& face : faces) {
    solid.faces.push_back(face);
    solid.heat_faces.push_back(core::quad_face(solid.glass.mesh, face, static_cast<Index>(side)));
  }
}

/// Tools that any stage from the solid's start on uses.
std::vector<Index> tools_in_space(const Scene& scene) {
  std::set<Index> tools;
  for (std::size_t s = static_cast<std::size_t>(scene.solid->from_stage); s < scene.stages.size(); ++s)
    for (const StageTool& entry : scene.stages[s].tools) tools.insert(entry.tool);
  return {tools.begin(), tools.end()};
}

}  // namespace

double solid_size(const Accuracy& accuracy) {
  return 2 * accuracy.surface_size;  // a cell has a node in its middle
}

Index solid_layers(const Accuracy& accuracy) {
  constexpr Index least = 3;  // the skins of both sides, and what is between them
  return std::max(least, 1 + static_cast<Index>(std::floor(accuracy.elements_across)));
}

std::vector<core::HexFace> faces_of(const SolidState& state, SolidSide side) {
  std::vector<core::HexFace> result;
  for (std::size_t f = 0; f < state.faces.size(); ++f)
    if (state.heat_faces[f].boundary_id == static_cast<Index>(side)) result.push_back(state.faces[f]);
  return result;
}

double solid_cell_size(const Scene& scene, const State& state) {
  return solid_size(scene.accuracy) / widening(scene, state);
}

SolidState hand_over(const Scene& scene, const State& state, double cell_size) {
  const core::Mesh& section = state.glass.mesh;
  const auto sides = remesh::wall_sides(section, scene.geometry, remesh::surface_rays(section, scene.geometry));
  if (!sides.no_wall.empty()) throw core::RunError("the parison cannot be followed in space: " + sides.no_wall);
  const remesh::WallCoordinates coordinates(section, sides);
  remesh::WallMesh wall =
      remesh::turn_wall(coordinates, {cell_size, solid_layers(scene.accuracy), scene.solid->sector});
  SolidState solid;
  solid.cell_size = cell_size;
  solid.glass.temperature = remesh::column_values(section, state.glass.temperature, wall);
  solid.share = scene.solid->sector / (2 * M_PI);
  solid.first_mesh = wall.mesh;
  solid.glass.mesh = std::move(wall.mesh);
  add_side(wall.inner, SolidSide::inner, solid);
  add_side(wall.outer, SolidSide::outer, solid);
  add_side(wall.rim, SolidSide::rim, solid);
  solid.planes = std::move(wall.planes);
  solid.columns = std::move(wall.columns);
  solid.stacks = core::cell_stacks(solid.glass.mesh);
  const auto cells = core::cell_list(solid.glass.mesh, core::hexahedron_table());
  solid.point_mass =
      thermal::point_masses(solid.glass.mesh.nodes, cells, *scene.glass.thermal, solid.glass.temperature);
  const double mass = solid.share * state.glass.mass;
  solid.point_mass *= mass / solid.point_mass.sum();
  solid.glass.cell_mass = flow::masses_by_volume(*scene.glass.flow, solid.glass.mesh, solid.glass.temperature);
  solid.glass.cell_mass *= mass / solid.glass.cell_mass.sum();
  const auto body = thermal::solid_body(solid.glass.mesh, solid.heat_faces, solid.point_mass, *scene.glass.thermal);
  solid.totals.start_heat = solid.share * glass_heat(scene, state);
  keep_heat(body, solid.totals.start_heat, Eigen::VectorXd::Ones(solid.glass.mesh.node_count()),
            solid.glass.temperature);
  for (const Index tool : tools_in_space(scene)) solid.tools.push_back(swept_tool(scene, state, tool));
  take_openings(scene, state, solid);
  return solid;
}

}  // namespace parison::forming
