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
  Point at(double a, double b) const;
  /// Parts of each edge whose chords miss it by about a thousandth of their length: 1, 2 or 4.
  int parts() const;
  /// Place (a, b) of the face at a point of the plane by Newton's method, from the place given; nothing where the map
  /// cannot be inverted. It may lie outside of the face.
  std::optional<std::array<double, 2>> invert(const Point& at, std::array<double, 2> from = {0.5, 0.5}) const;

 private:
  std::array<Point, 9> nodes_;
};

/// Corners of a polygon, counterclockwise.
using Polygon = std::vector<Point>;
/// The face as a polygon of a plane: bent edges in pieces.
Polygon outline(const ProjectedFace& face);
/// A face that looks against the plane's normal, in convex polygons: one, or more where its edges are bent.
std::vector<Polygon> turned_pieces(const ProjectedFace& face);
double area(const Polygon& polygon);
/// The part of `subject` in a convex polygon (I. E. Sutherland, G. W. Hodgman, Comm. ACM 17 (1974) 32-42).
Polygon clip(const Polygon& subject, const Polygon& convex);
/// Triangles that make up a polygon.
using Triangle = std::array<Point, 3>;
std::vector<Triangle> triangulate(const Polygon& polygon);
/// Whether a convex polygon holds a point.
bool holds(const Polygon& convex, const Point& at);

}  // namespace parison::contact
