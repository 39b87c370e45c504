// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "forming/report/cooling/residual_stress.hpp"
#include "forming/solid/solid_memory.hpp"
#include "forming/state/sample.hpp"
#include "forming/step/cooling/cooling_step.hpp"

namespace parison::forming {

namespace {

/// Stress-optical coefficient of soda-lime glass, 1/Pa: 2.6 brewster (assumed; 2.4 to 2.7 are quoted).
constexpr double stress_optical = 2.6e-12;
/// Retardation of a temper number: 7.27 degrees of an analyser at 565 nm, m.
constexpr double per_number = 22.8e-9;
/// Thickness for which a real temper number stands, m (ASTM C148).
constexpr double standard_thickness = 4.06e-3;

/// Places along the axis at which the surface passes a distance from it, m, from below.
std::vector<double> crossings(const core::Mesh& mesh, double radius, int up) {
  std::vector<double> places;
  const auto add = [&](const Point& a, const Point& b) {
    if ((a[0] <= radius) == (b[0] <= radius)) return;
    places.push_back(a[1] + (b[1] - a[1]) * (radius - a[0]) / (b[0] - a[0]));
  };
  for (const auto& edge : mesh.boundary_edges()) {
    if (mesh.kind_of(edge) == BoundaryKind::symmetry) continue;
    add(mesh.nodes[edge.nodes[0]], mesh.nodes[edge.nodes[2]]);
    add(mesh.nodes[edge.nodes[2]], mesh.nodes[edge.nodes[1]]);
  }
  std::sort(places.begin(), places.end(), [&](double a, double b) { return up * a < up * b; });
  return places;
}

/// Integral of the difference of radial and hoop stress between two heights, Pa m.
double difference_along(const core::Mesh& mesh, const Eigen::VectorXd& stress, double radius, double from, double to) {
  constexpr int parts = 24;
  std::vector<Point> points;
  for (int i = 0; i < parts; ++i) points.emplace_back(radius, from + (to - from) * (i + 0.5) / parts);
  const Eigen::MatrixXd at = sample(mesh, stress, 4, points);
  return (at.col(0) - at.col(2)).mean() * std::abs(to - from);
}

}  // namespace

std::size_t BaseView::largest() const {
  const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  return static_cast<std::size_t>(std::max_element(retardation.begin(), retardation.end(), smaller) -
                                  retardation.begin());
}

BaseView base_view(const Scene& scene, const GlassState& glass, int up) {
  constexpr int places = 60;
  constexpr double wall_begins = 3;  // times the base near the axis, along the light
  BaseView view;
  const Eigen::VectorXd stress = nodal_stress(glass);
  if (stress.size() == 0 || scene.geometry != core::Geometry::axisymmetric) return view;
  double widest = 0;
  for (const Point& x : glass.mesh.nodes) widest = std::max(widest, x[0]);
  for (int i = 0; i < places; ++i) {
    const double radius = widest * (i + 0.5) / places;
    const std::vector<double> through = crossings(glass.mesh, radius, up);
    if (through.size() < 2) break;
    const double thickness = std::abs(through[1] - through[0]);
    if (!view.thickness.empty() && thickness > wall_begins * view.thickness.front()) break;
    view.radius.push_back(radius);
    view.thickness.push_back(thickness);
    view.retardation.push_back(stress_optical * difference_along(glass.mesh, stress, radius, through[0], through[1]));
  }
  return view;
}

BaseView base_view(const SolidState& solid, int up) {
  constexpr double steep = 0.7;  // cosine of the lean of a column: what leans more is wall
  BaseView view;
  if (!remembers(solid)) return view;
  const NodalTensors stress = nodal_stress(solid);
  const auto& nodes = solid.glass.mesh.nodes;
  double lowest = -std::numeric_limits<double>::infinity(), highest = lowest;
  for (const auto& x : nodes) lowest = std::max(lowest, -up * x[2]), highest = std::max(highest, up * x[2]);
  struct Ray {
    double radius, thickness, retardation, on_diagonal;
    core::Vector3 at;
  };
  std::vector<Ray> rays;
  for (const auto& column : solid.columns) {
    const core::Vector3 outer = nodes[column.back()], through = nodes[column.front()] - outer;
    const double half_way = 0.5 * (highest - lowest);  // the wall from there on is not of the base
    if (up * through[2] < steep * through.norm() || up * outer[2] > half_way) continue;
    double normal = 0, shear = 0;
    for (std::size_t i = 0; i + 2 < column.size(); i += 2) {  // Simpson's rule in each cell
      const double length = std::abs(nodes[column[i + 2]][2] - nodes[column[i]][2]) / 6;
      for (const auto& [node, weight] :
           {std::pair(column[i], 1.0), std::pair(column[i + 1], 4.0), std::pair(column[i + 2], 1.0)}) {
        normal += weight * length * (stress(0, node) - stress(1, node));
        shear += weight * length * stress(5, node);
      }
    }
    rays.push_back({std::hypot(outer[0], outer[1]), std::abs(through[2]),
                    stress_optical * std::hypot(normal, 2 * shear), stress_optical * 2 * shear, outer});
  }
  std::sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) { return a.radius < b.radius; });
  for (const Ray& ray : rays) {
    view.radius.push_back(ray.radius);
    view.thickness.push_back(ray.thickness);
    view.retardation.push_back(ray.retardation);
    view.at.push_back(ray.at);
    view.on_diagonal.push_back(ray.on_diagonal);
  }
  view.sector = 2 * M_PI * solid.share;
  return view;
}

double apparent_temper_number(double retardation) {
  return std::abs(retardation) / per_number;
}

double real_temper_number(double retardation, double thickness) {
  return apparent_temper_number(retardation) * standard_thickness / thickness;
}

}  // namespace parison::forming
