// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/straighten.hpp"

#include <utility>

#include "core/solid/hex_geometry.hpp"
#include "forming/solid/solid_heat.hpp"
#include "remesh/solid/cell_places.hpp"
#include "remesh/solid/wall_straightening.hpp"

namespace parison::forming {

namespace {

using core::Vector3;

/// What moved nodes belong to: the rest keeps its mass and temperatures.
struct MovedParts {
  std::vector<bool> cell;
  Eigen::VectorXd node;  ///< 1 for nodes of those cells, 0 for others
};

MovedParts moved_parts(const core::HexMesh& mesh, const std::vector<Vector3>& nodes) {
  MovedParts parts{std::vector<bool>(mesh.cells.size(), false), Eigen::VectorXd::Zero(mesh.node_count())};
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (const Index node : mesh.cells[c])
      if (nodes[node] != mesh.nodes[node]) parts.cell[c] = true;
    if (!parts.cell[c]) continue;
    for (const Index node : mesh.cells[c]) parts.node[node] = 1;
  }
  return parts;
}

/// Gives moved cells the masses that they now have by volume, so many values for each, with the sum that they had.
void share_mass(const MovedParts& parts, const Eigen::VectorXd& by_volume, Eigen::VectorXd& mass) {
  const auto values = static_cast<Index>(mass.size()) / static_cast<Index>(parts.cell.size());
  double before = 0, after = 0;
  const auto for_moved = [&](const auto& use) {
    for (std::size_t c = 0; c < parts.cell.size(); ++c)
      if (parts.cell[c])
        for (Index v = 0; v < values; ++v) use(static_cast<Index>(c) * values + v);
  };
  for_moved([&](Index i) {
    before += mass[i];
    after += by_volume[i];
  });
  for_moved([&](Index i) { mass[i] = by_volume[i] * (before / after); });
}

/// Whether a cell that is too bad to bear gains what a transfer of the fields is worth.
bool is_worth(const core::HexMesh& before, const core::HexMesh& after, double bearable) {
  constexpr double worth = 0.02;
  for (Index cell = 0; cell < before.cell_count(); ++cell)
    if (const double own = core::least_jacobian(before, cell);
        own < bearable && core::least_jacobian(after, cell) >= own + worth)
      return true;
  return false;
}

}  // namespace

bool straighten(const flow::Material& material, const thermal::Material& thermal, SolidState& solid,
                const StraightenLimits& limits) {
  flow::SolidGlass& glass = solid.glass;
  if (remesh::least_jacobian(glass.mesh) >= limits.bearable) return false;
  const auto inner = faces_of(solid, SolidSide::inner), outer = faces_of(solid, SolidSide::outer),
             rim = faces_of(solid, SolidSide::rim);
  std::vector<Vector3> nodes =
      remesh::straightened_nodes({&glass.mesh, &solid.columns, &inner, &outer, &rim, &solid.planes}, limits.wanted);
  core::HexMesh after{std::move(nodes), glass.mesh.cells};
  if (!is_worth(glass.mesh, after, limits.bearable)) return false;

  const MovedParts parts = moved_parts(glass.mesh, after.nodes);
  const auto places = remesh::cell_places(glass.mesh, after.nodes);
  const auto carry = [&](Eigen::VectorXd& field, Index components) {
    if (field.size() > 0) field = remesh::values_at(glass.mesh, places, field, components);
  };
  const double heat = thermal::heat_content(
      thermal::solid_body(glass.mesh, solid.heat_faces, solid.point_mass, thermal), glass.temperature);
  carry(glass.temperature, 1);
  carry(solid.temperature_rate, 1);
  carry(glass.velocity, 3);
  carry(glass.velocity_before, 3);
  glass.mesh = std::move(after);
  const auto cells = core::cell_list(glass.mesh, core::hexahedron_table());
  share_mass(parts, thermal::point_masses(glass.mesh.nodes, cells, thermal, glass.temperature), solid.point_mass);
  share_mass(parts, flow::masses_by_volume(material, glass.mesh, glass.temperature), glass.cell_mass);
  keep_heat(thermal::solid_body(glass.mesh, solid.heat_faces, solid.point_mass, thermal), heat, parts.node,
            glass.temperature);
  return true;
}

}  // namespace parison::forming
