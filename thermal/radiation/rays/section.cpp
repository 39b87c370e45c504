// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/rays/section.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace parison::thermal {

namespace {

constexpr double resolution = 1e-9;  ///< smallest distance between two places of the surface, of the body's size

Point edge_point(const SectionEdge& edge, double s) {
  const auto shape = core::edge_shape(s);
  return shape[0] * edge[0] + shape[1] * edge[1] + shape[2] * edge[2];
}

std::vector<SectionEdge> edges_of(const core::Mesh& mesh) {
  std::vector<SectionEdge> edges;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    edges.push_back({mesh.nodes[edge.nodes[0]], mesh.nodes[edge.nodes[1]], mesh.nodes[edge.nodes[2]]});
  return edges;
}

/// Two for each edge; those of an edge on the axis count as -1.
std::vector<Facet> facets_of(const std::vector<SectionEdge>& edges, double tiny, Geometry geometry,
                             std::vector<Index>& first_facet) {
  std::vector<Facet> facets;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    std::array<Point, 3> x;
    for (int i = 0; i < 3; ++i) x[i] = edge_point(edges[e], 0.5 * i);
    const bool on_axis = geometry == Geometry::axisymmetric && std::max({x[0][0], x[1][0], x[2][0]}) < tiny;
    first_facet.push_back(on_axis ? -1 : static_cast<Index>(facets.size()));
    if (on_axis) continue;
    for (int i = 0; i < 2; ++i) {
      const Point along = x[i + 1] - x[i];
      facets.push_back({x[i], along, Point(along[1], -along[0]).normalized(), static_cast<Index>(e), 0.5 * i});
    }
  }
  return facets;
}

}  // namespace

Section::Section(const core::Mesh& mesh, Geometry geometry)
    : Section(edges_of(mesh), core::size(mesh), geometry, false) {}

Section::Section(std::vector<SectionEdge> edges, double size, Geometry geometry, bool both_sides)
    : edges_(std::move(edges)),
      geometry_(geometry),
      facets_(facets_of(edges_, resolution * size, geometry, first_facet_)),
      tree_(facets_, geometry, resolution * size, both_sides) {}

Point Section::project(const Eigen::Vector3d& x) const {
  return {geometry_ == Geometry::axisymmetric ? std::sqrt(x[0] * x[0] + x[1] * x[1]) : x[0], x[2]};
}

std::optional<Hit> Section::first_hit(const Ray& ray, Index from_facet, double sense) const {
  const FacetHit found = tree_.first_hit(ray, from_facet, sense);
  if (found.facet < 0) return std::nullopt;
  const Facet& facet = facets_[found.facet];
  const double share = (project(ray.at(found.distance)) - facet.from).dot(facet.along) / facet.along.squaredNorm();
  return Hit{found.distance, facet.edge, facet.s + 0.5 * std::clamp(share, 0.0, 1.0), found.facet, found.from_behind};
}

Eigen::Vector3d Section::turned(const Point& v, const Eigen::Vector3d& x) const {
  if (geometry_ == Geometry::planar) return {v[0], 0, v[1]};
  const double r = std::sqrt(x[0] * x[0] + x[1] * x[1]);
  if (r == 0) return {v[0], 0, v[1]};
  return {v[0] * x[0] / r, v[0] * x[1] / r, v[1]};
}

Eigen::Vector3d Section::normal(Index e, double s, const Eigen::Vector3d& x) const {
  const auto slope = core::edge_shape_derivative(s);
  const Point along = slope[0] * edges_[e][0] + slope[1] * edges_[e][1] + slope[2] * edges_[e][2];
  return turned(Point(along[1], -along[0]).normalized(), x);
}

Eigen::Vector3d Section::facet_normal(Index facet, const Eigen::Vector3d& x) const {
  return turned(facets_[facet].normal, x);
}

Index Section::facet_at(Index edge, double s) const {
  return first_facet_[edge] < 0 ? -1 : first_facet_[edge] + (s < 0.5 ? 0 : 1);
}

Eigen::Vector3d Section::point(Index edge, double s) const {
  const Facet& facet = facets_[facet_at(edge, s)];
  const Point x = facet.from + 2 * (s - facet.s) * facet.along;
  return {x[0], 0, x[1]};
}

}  // namespace parison::thermal
