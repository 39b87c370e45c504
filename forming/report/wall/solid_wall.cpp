// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/wall/solid_wall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/solid/cell_table.hpp"
#include "core/solid/hex_geometry.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {

namespace {

using core::Vector3;

constexpr int rule_points = 3;  // along a face

/// Places of a surface with their normals.
struct SurfaceSamples {
  std::vector<Vector3> at, normal;
};

/// Of each face, at the points of a fine rule: between them the tangent plane is the surface.
SurfaceSamples samples_of(const core::HexMesh& mesh, const std::vector<core::HexFace>& faces) {
  constexpr int fine = 5;
  SurfaceSamples samples;
  for (const core::HexFace& face : faces)
    for (const auto& point : core::map_hex_face(core::face_nodes(mesh, face), face, fine)) {
      samples.at.push_back(point.position);
      samples.normal.push_back(point.normal);
    }
  return samples;
}

/// Distance from a place to a surface, m, by the tangent plane of its nearest sample.
double distance_to(const SurfaceSamples& samples, const Vector3& at) {
  std::size_t nearest = 0;
  double least = HUGE_VAL;
  for (std::size_t s = 0; s < samples.at.size(); ++s)
    if (const double square = (samples.at[s] - at).squaredNorm(); square < least) {
      least = square;
      nearest = s;
    }
  return std::abs((samples.at[nearest] - at).dot(samples.normal[nearest]));
}

/// The outer side that belongs to each of its nodes, m2, and the share of it near a tool.
std::map<Index, double> areas_of(const SolidState& solid, double& near_tools) {
  constexpr double near = 2e-4;  // m
  std::map<Index, double> areas;
  double area = 0, near_area = 0;
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    if (solid.heat_faces[f].boundary_id != static_cast<Index>(SolidSide::outer)) continue;
    const auto numbers = core::face_node_numbers(solid.glass.mesh, solid.faces[f]);
    const core::HexFaceNodes nodes = core::face_nodes(solid.glass.mesh, solid.faces[f]);
    for (const auto& point : core::map_hex_face(nodes, solid.faces[f], rule_points)) {
      area += point.area;
      for (int i = 0; i < 9; ++i) areas[numbers[static_cast<std::size_t>(i)]] += point.area * point.shape[i];
    }
    if (solid.glass.contact.empty()) continue;
    const auto points = core::map_hex_face(nodes, solid.faces[f], flow::contact_points_along);
    for (std::size_t p = 0; p < points.size(); ++p)
      if (solid.glass.contact[f * flow::contact_points_per_face + p].gap < near) near_area += points[p].area;
  }
  near_tools = near_area / area;
  return areas;
}

/// Volume inside of the inner side up to a plane across the axis at its rim, m3: by Gauss' theorem with the field
/// (x, y, 0)/2, of which nothing passes through that plane and planes through the axis.
double inside_of(const SolidState& solid) {
  double volume = 0;
  for (const core::HexFace& face : faces_of(solid, SolidSide::inner))
    for (const auto& point : core::map_hex_face(core::face_nodes(solid.glass.mesh, face), face, rule_points))
      volume -= 0.5 * point.area * (point.position[0] * point.normal[0] + point.position[1] * point.normal[1]);
  return volume;
}

}  // namespace

SolidWall solid_wall(const SolidState& solid) {
  const core::HexMesh& mesh = solid.glass.mesh;
  const SurfaceSamples inner = samples_of(mesh, faces_of(solid, SolidSide::inner));
  SolidWall wall;
  const std::map<Index, double> areas = areas_of(solid, wall.near_tools);
  double area = 0, sum = 0;
  for (const auto& column : solid.columns) {
    const Index outer = column.back(), opposite = column.front();
    wall.points.push_back({outer, opposite, mesh.nodes[outer], distance_to(inner, mesh.nodes[outer]),
                           solid.glass.temperature[outer], solid.glass.temperature[opposite], areas.at(outer)});
    area += wall.points.back().area;
    sum += wall.points.back().area * wall.points.back().thickness;
  }
  std::sort(wall.points.begin(), wall.points.end(), [](const SolidWallPoint& a, const SolidWallPoint& b) {
    return std::make_pair(a.at[2], std::atan2(a.at[1], a.at[0])) <
           std::make_pair(b.at[2], std::atan2(b.at[1], b.at[0]));
  });
  const auto thinner = [](const SolidWallPoint& a, const SolidWallPoint& b) { return a.thickness < b.thickness; };
  const auto [least, most] = std::minmax_element(wall.points.begin(), wall.points.end(), thinner);
  wall.thinnest = static_cast<std::size_t>(least - wall.points.begin());
  wall.thickest = static_cast<std::size_t>(most - wall.points.begin());
  wall.capacity = inside_of(solid) / solid.share;
  wall.mean = sum / area;
  return wall;
}

SolidExtent extent_of(const SolidState& solid) {
  SolidExtent extent{HUGE_VAL, -HUGE_VAL, 0};
  for (const Vector3& at : solid.glass.mesh.nodes) {
    extent.low = std::min(extent.low, at[2]);
    extent.high = std::max(extent.high, at[2]);
    extent.radius = std::max(extent.radius, std::hypot(at[0], at[1]));
  }
  return extent;
}

double whole_volume(const SolidState& solid) {
  return core::cell_volumes(solid.glass.mesh).sum() / solid.share;
}

double mean_temperature(const SolidState& solid) {
  const core::CellTable& table = core::hexahedron_table();
  Eigen::VectorXd local(table.nodes());
  double sum = 0;
  for (std::size_t c = 0; c < solid.glass.mesh.cells.size(); ++c) {
    const auto& cell = solid.glass.mesh.cells[c];
    for (Index n = 0; n < table.nodes(); ++n) local[n] = solid.glass.temperature[cell[static_cast<std::size_t>(n)]];
    sum += solid.point_mass.segment(static_cast<Index>(c) * table.points(), table.points()).dot(table.shape * local);
  }
  return sum / solid.point_mass.sum();
}

std::string solid_wall_csv(const SolidWall& wall) {
  std::string text = "x_mm,y_mm,z_mm,angle_deg,thickness_mm,outer_temperature_degC,inner_temperature_degC\n";
  for (const SolidWallPoint& point : wall.points)
    text += fmt::format("{:.4f},{:.4f},{:.4f},{:.3f},{:.4f},{:.2f},{:.2f}\n", 1e3 * point.at[0], 1e3 * point.at[1],
                        1e3 * point.at[2], std::atan2(point.at[1], point.at[0]) * 180 / M_PI, 1e3 * point.thickness,
                        point.outer_temperature - thermal::content_reference,
                        point.inner_temperature - thermal::content_reference);
  return text;
}

}  // namespace parison::forming
