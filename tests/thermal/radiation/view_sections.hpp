#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include "thermal/radiation/enclosure/views.hpp"

namespace parison::thermal::test {

/// Straight surface between two points of the section, the air on its left.
struct Surface {
  Point from, to;
};

/// Each surface is one patch, in as many edges.
inline std::vector<ViewEdge> view_edges(const std::vector<Surface>& surfaces, core::Geometry geometry, int count = 1) {
  std::vector<ViewEdge> edges;
  for (std::size_t p = 0; p < surfaces.size(); ++p)
    for (int i = 0; i < count; ++i) {
      const auto at = [&](double k) -> Point {
        return surfaces[p].from + k / count * (surfaces[p].to - surfaces[p].from);
      };
      const Point a = at(i), b = at(i + 1), middle = at(i + 0.5);
      edges.push_back({{a, b, middle}, static_cast<Index>(p), (b - a).norm() * core::depth(geometry, middle)});
    }
  return edges;
}

inline Eigen::ArrayXd areas(const std::vector<ViewEdge>& edges, std::size_t patches) {
  Eigen::ArrayXd area = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(patches));
  for (const ViewEdge& edge : edges) area[edge.patch] += edge.area;
  return area;
}

/// View factor of a disc to a coaxial one at a distance (J. R. Howell's catalogue of configuration factors, C-41).
inline double disc_to_disc(double r1, double r2, double distance) {
  const double a = r1 / distance, b = r2 / distance, x = 1 + (1 + b * b) / (a * a);
  return 0.5 * (x - std::sqrt(x * x - 4 * std::pow(b / a, 2)));
}

/// View factors of the outer of two concentric cylinders of equal length (the same, C-91 and C-92).
inline double outer_to_inner(double inner, double outer, double length) {
  const double R = outer / inner, H = length / inner, A = H * H + R * R - 1, B = H * H - R * R + 1;
  return (1 - (std::acos(B / A) - (std::sqrt((A + 2) * (A + 2) - 4 * R * R) * std::acos(B / (R * A)) +
                                   B * std::asin(1 / R) - 0.5 * M_PI * A) /
                                      (2 * H)) /
                  M_PI) /
         R;
}
inline double outer_to_itself(double inner, double outer, double length) {
  const double R = outer / inner, H = length / inner, s = std::sqrt(4 * R * R + H * H) / H;
  return 1 - 1 / R + 2 / (M_PI * R) * std::atan(2 * std::sqrt(R * R - 1) / H) -
         H / (2 * M_PI * R) *
             (s * std::asin((4 * (R * R - 1) + H * H / (R * R) * (R * R - 2)) / (H * H + 4 * (R * R - 1))) -
              std::asin((R * R - 2) / (R * R)) + 0.5 * M_PI * (s - 1));
}

/// Exact exchange areas over pi, m2, of the rings of a tube of radius 1 and of its end discs' rings, from discs.
inline double ring_to_ring(double r1, double r2, double distance) {
  return r1 > 0 && r2 > 0 ? r1 * r1 * disc_to_disc(r1, r2, distance) : 0;
}

}  // namespace parison::thermal::test
