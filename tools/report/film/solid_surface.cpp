// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/film/solid_surface.hpp"

#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

#include "core/io/vtu.hpp"
#include "core/solid/hex_element.hpp"
#include "tools/report/film/vtu_grid.hpp"

namespace parison::tools {
namespace {

constexpr int nodes_of_cell = core::HexMesh::nodes_per_cell, nodes_of_face = 9;
constexpr int centre_of_face = 4, through_wall = 2;

using Point = std::array<float, 3>;

/// A face of one cell alone.
struct OuterFace {
  std::array<int, nodes_of_face> nodes;
  int axis, end;
};

/// The faces that no other cell shares, in the order of the cells.
std::vector<OuterFace> outer_faces(const std::vector<int>& cells) {
  std::vector<OuterFace> faces;
  std::map<int, int> cells_at_centre;
  for (std::size_t first = 0; first < cells.size(); first += nodes_of_cell) {
    std::array<int, nodes_of_cell> cell{};
    for (std::size_t i = 0; i < nodes_of_cell; ++i)
      cell[static_cast<std::size_t>(core::vtu_order_of_hex()[i])] = cells[first + i];
    for (const int axis : {0, 1, 2})
      for (const int end : {0, 1}) {
        OuterFace face{{}, axis, end};
        std::transform(core::hex_face_nodes(axis, end).begin(), core::hex_face_nodes(axis, end).end(),
                       face.nodes.begin(), [&](int local) { return cell[static_cast<std::size_t>(local)]; });
        ++cells_at_centre[face.nodes[centre_of_face]];
        faces.push_back(face);
      }
  }
  const auto is_shared = [&](const OuterFace& face) { return cells_at_centre[face.nodes[centre_of_face]] > 1; };
  faces.erase(std::remove_if(faces.begin(), faces.end(), is_shared), faces.end());
  return faces;
}

/// Sectors in the whole turn, by the largest angle of a node: the last plane of symmetry is there.
int copies_of(const std::vector<Point>& points) {
  double widest = 0, largest = 0;
  for (const Point& at : points) widest = std::max(widest, std::hypot(double(at[0]), double(at[1])));
  for (const Point& at : points) {
    if (std::hypot(at[0], at[1]) < 0.1 * widest) continue;
    const double angle = std::atan2(at[1], at[0]);
    largest = std::max(largest, angle < -1e-4 ? angle + 2 * M_PI : angle);
  }
  return largest > 0 ? std::max(1, static_cast<int>(std::lround(2 * M_PI / largest))) : 1;
}

/// Whether all nodes of a face lie in the half plane from the axis on at an angle.
bool lies_at(const OuterFace& face, const std::vector<Point>& points, double angle) {
  constexpr double off = 1e-3;  // mm
  return std::all_of(face.nodes.begin(), face.nodes.end(), [&](int node) {
    const Point& at = points[static_cast<std::size_t>(node)];
    const double along = std::cos(angle) * at[0] + std::sin(angle) * at[1];
    return along > -off && std::abs(std::cos(angle) * at[1] - std::sin(angle) * at[0]) < off;
  });
}

SurfaceSide side_of(const OuterFace& face, const std::vector<Point>& points, int copies) {
  if (face.axis == through_wall) return face.end == 0 ? SurfaceSide::inner : SurfaceSide::outer;
  if (copies > 1 && lies_at(face, points, 0)) return SurfaceSide::first_plane;
  return copies > 1 && lies_at(face, points, 2 * M_PI / copies) ? SurfaceSide::last_plane : SurfaceSide::rim;
}

}  // namespace

SolidSurface read_solid_surface(const std::string& path) {
  const auto grid = read_grid(path);
  std::vector<Point> points(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) points[i][k] = static_cast<float>(grid->GetPoint(static_cast<vtkIdType>(i))[k]);
  SolidSurface surface;
  surface.copies = copies_of(points);
  std::vector<int> number(points.size(), -1), nodes;
  for (const OuterFace& face : outer_faces(cells_of(*grid, nodes_of_cell, path))) {
    surface.sides.push_back(static_cast<std::uint16_t>(side_of(face, points, surface.copies)));
    for (const int node : face.nodes) {
      int& own = number[static_cast<std::size_t>(node)];
      if (own < 0) {
        own = static_cast<int>(nodes.size());
        nodes.push_back(node);
      }
      surface.faces.push_back(static_cast<std::uint16_t>(own));
    }
  }
  if (nodes.size() > most_nodes) refuse_vtu(path, "has more than 65536 nodes on its surface");
  for (const int node : nodes) surface.points.push_back(points[static_cast<std::size_t>(node)]);
  for (const auto& [name, values] : nodal_fields(*grid))
    for (const int node : nodes) surface.nodal[name].push_back(values[static_cast<std::size_t>(node)]);
  return surface;
}

}  // namespace parison::tools
