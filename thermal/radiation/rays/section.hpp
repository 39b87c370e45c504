#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/mesh/element.hpp"

namespace parison::thermal {

using core::Geometry;
using core::Index;
using core::Point;

/// Half-line in space: x and y span the planes across the axis and z is along it; of a slab y is the depth.
struct Ray {
  Eigen::Vector3d origin, direction;  ///< m; of length 1

  Eigen::Vector3d at(double distance) const { return origin + distance * direction; }
};

/// Where a ray leaves the body.
struct Hit {
  double distance;  ///< m
  Index edge;       ///< boundary edge of the mesh
  double s;         ///< along it
  Index facet;
};

/// The surface of a body, as the rays inside it meet it: each boundary edge is two straight facets, turned around the
/// axis to frusta, with the normals of the quadratic edge.
class Section {
 public:
  Section(const core::Mesh& mesh, Geometry geometry);

  /// Coordinates in the section of a point in space.
  Point project(const Eigen::Vector3d& x) const;
  /// Where a ray that begins inside or on a facet leaves the body; none where it slips through a gap of round-off.
  std::optional<Hit> leave(const Ray& ray, Index from_facet) const { return first_hit(ray, from_facet, 1); }
  /// Where a ray that begins outside or on a facet enters the body; none where it does not.
  std::optional<Hit> enter(const Ray& ray, Index from_facet) const { return first_hit(ray, from_facet, -1); }
  /// Outward unit normal in space at a place of a boundary edge, turned to a point there.
  Eigen::Vector3d normal(Index edge, double s, const Eigen::Vector3d& x) const;
  /// The same of the straight facet.
  Eigen::Vector3d facet_normal(Index facet, const Eigen::Vector3d& x) const;
  /// Facet of an edge at s, and the point on it, in the plane y = 0.
  Index facet_at(Index edge, double s) const;
  Eigen::Vector3d point(Index edge, double s) const;

 private:
  struct Facet {
    Point from, along, normal;  ///< normal outward, of length 1
    Index edge;
    double s;  ///< of its first end
  };
  struct Box {
    Point low, high;
    Index first, last;  ///< of its facets, without the last
    Index left, right;  ///< boxes inside; none below a leaf
  };
  Index add_box(Index first, Index last);
  bool may_meet(const Ray& ray, const Box& box, double nearest) const;
  /// The nearest facet whose normal has a positive product with `sense` times the direction.
  std::optional<Hit> first_hit(const Ray& ray, Index from_facet, double sense) const;
  void meet(const Ray& ray, Index facet, Index from_facet, double sense, std::optional<Hit>& nearest) const;
  Eigen::Vector3d turned(const Point& in_section, const Eigen::Vector3d& x) const;

  const core::Mesh& mesh_;
  Geometry geometry_;
  double tiny_;  ///< m
  std::vector<Facet> facets_;
  std::vector<Index> first_facet_;  ///< by boundary edge; -1 on the axis
  std::vector<Box> boxes_;
};

}  // namespace parison::thermal
