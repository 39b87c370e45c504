// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/contour/contour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/numbers.hpp"
#include "core/mesh/element.hpp"
#include "forming/report/files/history.hpp"
#include "forming/report/process/mould_filling.hpp"
#include "remesh/wall/surface_rays.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {

namespace {

using core::Point;

/// An edge as a curve x(s), s from 0 to 1.
struct Curve {
  std::array<Point, 3> nodes;  ///< first, last, mid-side

  Point at(double s) const {
    const auto shape = core::edge_shape(s);
    return shape[0] * nodes[0] + shape[1] * nodes[1] + shape[2] * nodes[2];
  }
  double axial_derivative(double s) const {
    const auto shape = core::edge_shape_derivative(s);
    return shape[0] * nodes[0][1] + shape[1] * nodes[1][1] + shape[2] * nodes[2][1];
  }
};

Curve curve_of(const core::Mesh& mesh, const core::BoundaryEdge& edge) {
  return {{mesh.nodes[edge.nodes[0]], mesh.nodes[edge.nodes[1]], mesh.nodes[edge.nodes[2]]}};
}

/// Real places where the axial coordinate of the curve is `level`, also beyond its ends.
std::vector<double> all_roots(const Curve& curve, double level) {
  const double first = curve.nodes[0][1], last = curve.nodes[1][1], mid = curve.nodes[2][1];
  const double a = 2 * (first + last - 2 * mid), b = 4 * mid - 3 * first - last, c = first - level;
  if (std::abs(a) <= 1e-12 * std::abs(b)) return {-c / b};
  const double discriminant = b * b - 4 * a * c;
  if (discriminant <= 0) return {};
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  if (q == 0) return {q / a};
  return {std::min(q / a, c / q), std::max(q / a, c / q)};
}

/// Where within the edge its axial coordinate is `level`, rising. Which side its ends are on says how often, so that
/// edges that share a vertex agree: an end on the level counts as above it.
std::vector<double> roots(const Curve& curve, double level) {
  const double first = curve.nodes[0][1], last = curve.nodes[1][1];
  const std::vector<double> found = all_roots(curve, level);
  if ((first >= level) == (last >= level)) {
    const bool inside = found.size() == 2 && found[0] > 0 && found[1] < 1;
    return inside ? found : std::vector<double>{};
  }
  double nearest = (level - first) / (last - first), distance = 1;
  for (const double s : found)
    if (const double off = std::abs(s - std::clamp(s, 0.0, 1.0)); off < distance) nearest = s, distance = off;
  return {std::clamp(nearest, 0.0, 1.0)};
}

/// Integral of pi r^2, or x times 1 m, over the axial coordinate between two places of the edge, m3.
double swept(const Curve& curve, core::Geometry geometry, double from, double to) {
  double sum = 0;
  for (const core::EdgeRulePoint& at : core::edge_rule(3)) {
    const double s = from + (to - from) * at.s, x = curve.at(s)[0];
    const double section = geometry == core::Geometry::axisymmetric ? M_PI * x * x : x;
    sum += at.weight * (to - from) * section * curve.axial_derivative(s);
  }
  return sum;
}

}  // namespace

double volume_beyond(const core::Mesh& mesh, core::Geometry geometry, double level, int up) {
  long double sum = 0;  // the two sides of a thin wall all but cancel
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    const Curve curve = curve_of(mesh, edge);
    // all roots, not `roots`: an edge may begin on the level, bulge beyond it and come back
    std::vector<double> ends{0};
    for (const double s : all_roots(curve, level))
      if (s > 0 && s < 1) ends.push_back(s);
    ends.push_back(1);
    for (std::size_t i = 1; i < ends.size(); ++i)
      if (up * (curve.at(0.5 * (ends[i - 1] + ends[i]))[1] - level) > 0)
        sum += swept(curve, geometry, ends[i - 1], ends[i]);
  }
  return static_cast<double>(sum);
}

std::vector<double> outline_crossings(const core::Mesh& mesh, double level) {
  std::vector<double> crossings;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    const Curve curve = curve_of(mesh, edge);
    for (const double s : roots(curve, level)) crossings.push_back(curve.at(s)[0]);
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

namespace {

const char* name_of(remesh::SurfacePart side) {
  switch (side) {
    case remesh::SurfacePart::outer:
      return "outer";
    case remesh::SurfacePart::inner:
      return "inner";
    case remesh::SurfacePart::rim:
      return "rim";
    case remesh::SurfacePart::none:
      break;
  }
  return "surface";
}

/// The side of each node; a node between a rim and a side is of the side.
std::vector<remesh::SurfacePart> sides_of_nodes(const core::Mesh& mesh, const remesh::WallSides& sides) {
  std::vector<remesh::SurfacePart> side(mesh.nodes.size(), remesh::SurfacePart::none);
  for (const remesh::SurfacePart wanted :
       {remesh::SurfacePart::rim, remesh::SurfacePart::inner, remesh::SurfacePart::outer})
    for (std::size_t edge = 0; edge < sides.part.size(); ++edge)
      if (sides.part[edge] == wanted)
        for (const Index node : mesh.boundary_edges()[edge].nodes) side[node] = wanted;
  return side;
}

/// Thickness at the nodes: of the outer side as in the profile, of the inner side by rays that meet the outer one.
std::vector<double> thickness_at_nodes(const std::vector<remesh::SurfacePart>& side, const ThicknessProfile& profile) {
  std::vector<double> thickness(side.size(), core::none);
  for (std::size_t n = 0; n < thickness.size(); ++n)
    if (const remesh::Ray& ray = profile.rays[n]; side[n] == remesh::SurfacePart::inner && ray.ends() &&
                                                  profile.sides.part[ray.edge] == remesh::SurfacePart::outer &&
                                                  ray.facing >= remesh::facing_sides)
      thickness[n] = ray.length;
  for (std::size_t i = 0; i < profile.rows.size(); ++i) thickness[profile.nodes[i]] = profile.rows[i].thickness;
  return thickness;
}

std::vector<bool> without_symmetry(const core::Mesh& mesh) {
  std::vector<bool> wanted;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    wanted.push_back(mesh.kind_of(edge) != BoundaryKind::symmetry);
  return wanted;
}

/// Thickness on the outer side at a place along the axis, where the outer side is widest; NaN off the wall.
double outer_thickness(const std::vector<ContourPoint>& points, double axial) {
  double radius = -1, thickness = core::none;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const ContourPoint &a = points[i - 1], &b = points[i];
    const double low = std::min(a.position[1], b.position[1]), high = std::max(a.position[1], b.position[1]);
    if (a.side != remesh::SurfacePart::outer || b.side != remesh::SurfacePart::outer || axial < low || axial > high ||
        low == high)
      continue;
    const double t = (axial - a.position[1]) / (b.position[1] - a.position[1]);
    if (const double r = (1 - t) * a.position[0] + t * b.position[0]; r > radius)
      radius = r, thickness = (1 - t) * a.thickness + t * b.thickness;
  }
  return thickness;
}

/// The distance of the slices of glass so high, m.
double slice_distance(double height) {
  constexpr double least_rows = 50;
  return core::millimetre * std::pow(10, std::floor(std::log10(height / core::millimetre / least_rows) + 1e-9));
}

}  // namespace

std::vector<ContourPoint> contour(const Scene& scene, const State& state, const ThicknessProfile& profile) {
  const core::Mesh& mesh = state.glass.mesh;
  const std::vector<remesh::SurfacePart> side = sides_of_nodes(mesh, profile.sides);
  const std::vector<double> thickness = thickness_at_nodes(side, profile);
  std::vector<ContourPoint> points;
  std::vector<bool> seen(mesh.nodes.size(), false);
  int loop = 0;
  const auto add = [&](Index node, double arc) {
    if (seen[node]) return;
    seen[node] = true;
    points.push_back({loop, side[node], arc, mesh.nodes[node], thickness[node],
                      scene.has_heat() ? state.glass.temperature[node] : core::none});
  };
  Index end = -1;
  for (const ChainEdge& edge : walk_edges(mesh, without_symmetry(mesh))) {
    const auto& [first, last, mid] = mesh.boundary_edges()[edge.edge].nodes;
    if (end >= 0 && first != end) ++loop;
    end = last;
    add(first, edge.start);
    add(mid, edge.start + 0.5 * edge.length);
    add(last, edge.start + edge.length);
  }
  return points;
}

std::vector<HeightRow> height_rows(const Scene& scene, const State& state, const std::vector<ContourPoint>& points) {
  const core::Mesh& mesh = state.glass.mesh;
  const GlassShape shape = glass_shape(scene, state);
  const int up = upwards(scene, state);
  const double height = shape.high - shape.low, foot = up > 0 ? shape.low : shape.high;
  const double distance = slice_distance(height), mass = glass_facts(scene, state).mass,
               density = mass / core::volume(mesh, scene.geometry);
  const double edge = 1e-6 * height;  // the slices at the ends are taken so far inside
  std::vector<HeightRow> rows;
  for (int i = 0; i * distance < height * (1 + 1e-12); ++i) {
    HeightRow row{i * distance, foot + up * i * distance, core::none, core::none, core::none, 0};
    const double inside = std::clamp(row.axial, shape.low + edge, shape.high - edge);
    const std::vector<double> crossings = outline_crossings(mesh, inside);
    if (crossings.size() >= 2) {
      row.outer_radius = crossings.back();
      row.inner_radius = crossings[crossings.size() - 2];
    }
    row.thickness = outer_thickness(points, inside);
    // edges may bulge a little below the lowest node
    row.weight_above = i == 0 ? mass : density * volume_beyond(mesh, scene.geometry, row.axial, up);
    rows.push_back(row);
  }
  return rows;
}

std::string contour_text(const Scene& scene, const State& state, const std::vector<ContourPoint>& points) {
  const GlassShape shape = glass_shape(scene, state);
  const int up = upwards(scene, state);
  const double foot = up > 0 ? shape.low : shape.high;
  std::string text = "loop,side,arc_mm,r_mm,z_mm,height_mm,thickness_mm,T_degC\n";
  for (const ContourPoint& point : points)
    text += fmt::format("{},{},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g}\n", point.loop, name_of(point.side),
                        1e3 * point.arc, 1e3 * point.position[0], 1e3 * point.position[1],
                        1e3 * up * (point.position[1] - foot), 1e3 * point.thickness,
                        point.temperature - thermal::content_reference);
  return text;
}

std::string heights_text(const std::vector<HeightRow>& rows) {
  std::string text = "height_mm,z_mm,r_outer_mm,r_inner_mm,thickness_mm,weight_above_g\n";
  for (const HeightRow& row : rows)
    text += fmt::format("{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g}\n", 1e3 * row.height, 1e3 * row.axial,
                        1e3 * row.outer_radius, 1e3 * row.inner_radius, 1e3 * row.thickness, 1e3 * row.weight_above);
  return text;
}

}  // namespace parison::forming
