#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>
#include <vector>

#include "core/solid/quad_face.hpp"

namespace parison::contact {

using core::Index;
using core::Point;
using core::Vector3;

/// The mean plane of a face: its coordinates are counterclockwise as seen from outside.
struct FacePlane {
  Vector3 origin, first, second, normal;  ///< m; unit vectors

  FacePlane(const std::vector<Vector3>& nodes, const core::QuadFace& face);
  Point project(const Vector3& at) const { return {(at - origin).dot(first), (at - origin).dot(second)}; }
  double height(const Vector3& at) const { return (at - origin).dot(normal); }
};

/// A face, projected along the normal of a plane.
class ProjectedFace {
 public:
  ProjectedFace(const FacePlane& plane, const std::vector<Vector3>& nodes, const core::QuadFace& face);
  const Point& node(int i) const { return nodes_[i]; }
  /// Place (a, b) of the face at a point of the plane by Newton's method, from the place given; nothing where the map
  /// cannot be inverted. It may lie outside of the face.
  std::optional<std::array<double, 2>> invert(const Point& at, std::array<double, 2> from = {0.5, 0.5}) const;

 private:
  std::array<Point, 9> nodes_;
};

/// Corners of a polygon, counterclockwise.
using Polygon = std::vector<Point>;
/// The face as a polygon of a plane: its corners, and the middle of edges that are bent by more than a thousandth.
/// `turned`: of a face that looks against the normal.
Polygon outline(const ProjectedFace& face, bool turned);
double area(const Polygon& polygon);
/// The part of `subject` in a convex polygon (I. E. Sutherland, G. W. Hodgman, Comm. ACM 17 (1974) 32-42).
Polygon clip(const Polygon& subject, const Polygon& convex);
/// Whether a convex polygon holds a point.
bool holds(const Polygon& convex, const Point& at);

}  // namespace parison::contact
