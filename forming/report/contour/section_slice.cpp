// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/contour/section_slice.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/mesh/element.hpp"

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

}  // namespace parison::forming
