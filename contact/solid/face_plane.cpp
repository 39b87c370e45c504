// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solid/face_plane.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace parison::contact {

FacePlane::FacePlane(const std::vector<Vector3>& nodes, const core::QuadFace& face) {
  const auto corner = [&](int i) -> const Vector3& { return nodes[face.nodes[i]]; };
  origin = 0.25 * (corner(0) + corner(2) + corner(6) + corner(8));
  const Vector3 diagonal = corner(8) - corner(0);
  normal = diagonal.cross(corner(6) - corner(2)).normalized();
  first = (diagonal - diagonal.dot(normal) * normal).normalized();
  second = normal.cross(first);
}

ProjectedFace::ProjectedFace(const FacePlane& plane, const std::vector<Vector3>& nodes, const core::QuadFace& face) {
  for (int i = 0; i < 9; ++i) nodes_[i] = plane.project(nodes[face.nodes[i]]);
}

std::optional<std::array<double, 2>> ProjectedFace::invert(const Point& at, std::array<double, 2> from) const {
  constexpr int most = 30;
  constexpr double solved = 1e-12, lost = 3, longest = 0.5;  // where an edge has no extent whole steps leave the face
  for (int iteration = 0; iteration < most; ++iteration) {
    const auto shape = core::quad_shape(from[0], from[1]);
    const auto derivative = core::quad_shape_derivative(from[0], from[1]);
    Point off = at, along_a = Point::Zero(), along_b = Point::Zero();
    for (int i = 0; i < 9; ++i) {
      off -= shape[i] * nodes_[i];
      along_a += derivative[i][0] * nodes_[i];
      along_b += derivative[i][1] * nodes_[i];
    }
    const double determinant = core::cross(along_a, along_b);
    double step_a = core::cross(off, along_b) / determinant, step_b = core::cross(along_a, off) / determinant;
    const double shortened = std::min(1.0, longest / std::max(std::abs(step_a), std::abs(step_b)));
    step_a *= shortened;
    step_b *= shortened;
    from[0] += step_a;
    from[1] += step_b;
    if (!(std::abs(from[0] - 0.5) < lost && std::abs(from[1] - 0.5) < lost)) return std::nullopt;
    if (std::abs(step_a) + std::abs(step_b) < solved) return from;
  }
  return std::nullopt;
}

Point ProjectedFace::at(double a, double b) const {
  const auto shape = core::quad_shape(a, b);
  Point at = Point::Zero();
  for (int i = 0; i < 9; ++i) at += shape[i] * nodes_[i];
  return at;
}

int ProjectedFace::parts() const {
  constexpr double straight = 1e-3, hardly_bent = 4e-3;
  double bend = 0;
  for (const auto& [from, mid, to] : {std::array{0, 1, 2}, {2, 5, 8}, {8, 7, 6}, {6, 3, 0}}) {
    const Point chord = nodes_[to] - nodes_[from];
    if (chord.squaredNorm() > 0)
      bend = std::max(bend, std::abs(core::cross(chord, nodes_[mid] - nodes_[from])) / chord.squaredNorm());
  }
  return bend < straight ? 1 : bend < hardly_bent ? 2 : 4;
}

Polygon outline(const ProjectedFace& face) {
  const int parts = face.parts();
  Polygon polygon;
  for (int edge = 0; edge < 4; ++edge)
    for (int k = 0; k < parts; ++k) {
      const double s = static_cast<double>(k) / parts;
      polygon.push_back(edge == 0   ? face.at(s, 0)
                        : edge == 1 ? face.at(1, s)
                        : edge == 2 ? face.at(1 - s, 1)
                                    : face.at(0, 1 - s));
    }
  return polygon;
}

std::vector<Polygon> turned_pieces(const ProjectedFace& face) {
  const int parts = face.parts();
  std::vector<Polygon> pieces;
  for (int j = 0; j < parts; ++j)
    for (int i = 0; i < parts; ++i) {
      const double a = static_cast<double>(i) / parts, b = static_cast<double>(j) / parts, step = 1.0 / parts;
      pieces.push_back({face.at(a, b), face.at(a, b + step), face.at(a + step, b + step), face.at(a + step, b)});
    }
  return pieces;
}

double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) twice += core::cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return 0.5 * twice;
}

namespace {

/// Square of the length up to which an edge is one of a face whose nodes coincide, up to round-off.
double negligible_edge(const Polygon& polygon) {
  double longest = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    longest = std::max(longest, (polygon[(i + 1) % polygon.size()] - polygon[i]).squaredNorm());
  return 1e-20 * longest;
}

}  // namespace

Polygon clip(const Polygon& subject, const Polygon& convex) {
  const double shortest = negligible_edge(convex);
  Polygon result = subject, kept;
  for (std::size_t e = 0; e < convex.size() && !result.empty(); ++e) {
    const Point& from = convex[e];
    const Point along = convex[(e + 1) % convex.size()] - from;
    if (along.squaredNorm() <= shortest) continue;
    kept.clear();
    for (std::size_t i = 0; i < result.size(); ++i) {
      const Point &here = result[i], &next = result[(i + 1) % result.size()];
      const double left = core::cross(along, here - from), left_next = core::cross(along, next - from);
      if (left >= 0) kept.push_back(here);
      if ((left > 0 && left_next < 0) || (left < 0 && left_next > 0))
        kept.push_back(here + left / (left - left_next) * (next - here));
    }
    result.swap(kept);
  }
  return result;
}

std::vector<Triangle> triangulate(const Polygon& polygon) {
  const auto next = [&](std::size_t i) { return polygon[(i + 1) % polygon.size()]; };
  bool convex = true;
  Point middle = Point::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    middle += polygon[i] / static_cast<double>(polygon.size());
    const Point along = next(i) - polygon[i];
    convex = convex && core::cross(along, next(i + 1) - next(i)) >= -1e-12 * along.squaredNorm();
  }
  std::vector<Triangle> triangles;
  if (convex)
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) triangles.push_back({polygon[0], polygon[i], polygon[i + 1]});
  else
    for (std::size_t i = 0; i < polygon.size(); ++i) triangles.push_back({middle, polygon[i], next(i)});
  return triangles;
}

bool holds(const Polygon& convex, const Point& at) {
  const double shortest = negligible_edge(convex);
  for (std::size_t e = 0; e < convex.size(); ++e) {
    const Point along = convex[(e + 1) % convex.size()] - convex[e];
    if (along.squaredNorm() > shortest && core::cross(along, at - convex[e]) < 0) return false;
  }
  return true;
}

}  // namespace parison::contact
