#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "thermal/radiation/rays/facet_tree.hpp"

namespace parison::thermal {

/// Smallest cosine to a facet with which a ray starts or goes on.
inline constexpr double grazing = 1e-4;

/// Where a ray leaves the body.
struct Hit {
  double distance;  ///< m
  Index edge;       ///< boundary edge of the mesh
  double s;         ///< along it
  Index facet;
  bool from_behind = false;  ///< met against its normal: the ray was not where the body is
};

/// The k-th place of the unit square, evenly filled: the R2 sequence of M. Roberts, of multiples of the powers of the
/// inverse plastic number.
inline std::array<double, 2> spread_place(long k) {
  constexpr double first = 0.7548776662466927, second = 0.5698402909980532;
  return {std::fmod(0.5 + static_cast<double>(k) * first, 1.0), std::fmod(0.5 + static_cast<double>(k) * second, 1.0)};
}

/// First, last and mid point of a quadratic edge in the section, the body on its left.
using SectionEdge = std::array<Point, 3>;

/// The surface of a body, as the rays inside it meet it: each boundary edge is two straight facets, turned around the
/// axis to frusta, with the normals of the quadratic edge.
class Section {
 public:
  Section(const core::Mesh& mesh, Geometry geometry);
  /// The same of a region of this size, m, within given edges, which need not close it. With `both_sides` a ray also
  /// meets edges from behind.
  Section(std::vector<SectionEdge> edges, double size, Geometry geometry, bool both_sides);

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
  std::optional<Hit> first_hit(const Ray& ray, Index from_facet, double sense) const;
  Eigen::Vector3d turned(const Point& in_section, const Eigen::Vector3d& x) const;

  std::vector<SectionEdge> edges_;
  Geometry geometry_;
  std::vector<Index> first_facet_;  ///< by boundary edge; -1 on the axis
  std::vector<Facet> facets_;
  FacetTree tree_;
};

}  // namespace parison::thermal
