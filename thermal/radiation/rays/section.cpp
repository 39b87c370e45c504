// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/rays/section.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace parison::thermal {

namespace {

constexpr Index leaf = 3;         ///< facets of a box that is not divided
constexpr double overlap = 1e-9;  ///< of neighbouring facets, of their length
constexpr double flat = 1e-4;     ///< radial part of the normal below which a facet counts as a plane across the axis
constexpr double resolution = 1e-9;  ///< smallest distance between two places of the surface, of the body's size

Point edge_point(const core::Mesh& mesh, const core::BoundaryEdge& edge, double s) {
  const auto shape = core::edge_shape(s);
  return shape[0] * mesh.nodes[edge.nodes[0]] + shape[1] * mesh.nodes[edge.nodes[1]] +
         shape[2] * mesh.nodes[edge.nodes[2]];
}

}  // namespace

Section::Section(const core::Mesh& mesh, Geometry geometry)
    : mesh_(mesh), geometry_(geometry), tiny_(resolution * core::size(mesh)) {
  for (std::size_t e = 0; e < mesh.boundary_edges().size(); ++e) {
    const core::BoundaryEdge& edge = mesh.boundary_edges()[e];
    std::array<Point, 3> x;
    for (int i = 0; i < 3; ++i) x[i] = edge_point(mesh, edge, 0.5 * i);
    const bool on_axis = geometry == Geometry::axisymmetric && std::max({x[0][0], x[1][0], x[2][0]}) < tiny_;
    first_facet_.push_back(on_axis ? -1 : static_cast<Index>(facets_.size()));
    if (on_axis) continue;
    for (int i = 0; i < 2; ++i) {
      const Point along = x[i + 1] - x[i];
      facets_.push_back({x[i], along, Point(along[1], -along[0]).normalized(), static_cast<Index>(e), 0.5 * i});
    }
  }
  add_box(0, static_cast<Index>(facets_.size()));
}

Index Section::add_box(Index first, Index last) {
  const auto at = static_cast<Index>(boxes_.size());
  Box box{facets_[first].from, facets_[first].from, first, last, -1, -1};
  for (Index f = first; f < last; ++f)
    for (const Point& x : {facets_[f].from, Point(facets_[f].from + facets_[f].along)}) {
      box.low = box.low.cwiseMin(x);
      box.high = box.high.cwiseMax(x);
    }
  box.low.array() -= tiny_;
  box.high.array() += tiny_;
  boxes_.push_back(box);
  if (last - first <= leaf) return at;
  const Index middle = (first + last) / 2, left = add_box(first, middle), right = add_box(middle, last);
  boxes_[at].left = left;
  boxes_[at].right = right;
  return at;
}

Point Section::project(const Eigen::Vector3d& x) const {
  return {geometry_ == Geometry::axisymmetric ? std::sqrt(x[0] * x[0] + x[1] * x[1]) : x[0], x[2]};
}

/// By the range of z, which bounds the distance, and that of the radius over the distances that are left.
bool Section::may_meet(const Ray& ray, const Box& box, double nearest) const {
  const double dz = ray.direction[2], z = ray.origin[2];
  double from = 0, to = nearest;
  if (std::abs(dz) > 1e-12) {
    const double a = (box.low[1] - z) / dz, b = (box.high[1] - z) / dz;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
    if (from > to) return false;
  } else if (z < box.low[1] || z > box.high[1]) {
    return false;
  }
  const double dx = ray.direction[0], dy = ray.direction[1], x = ray.origin[0], y = ray.origin[1];
  if (geometry_ == Geometry::planar) {
    const double a = x + from * dx, b = x + to * dx;
    return std::max(a, b) >= box.low[0] && std::min(a, b) <= box.high[0];
  }
  const double square = dx * dx + dy * dy, half = x * dx + y * dy, constant = x * x + y * y;
  const auto radius2 = [&](double t) { return constant + t * (2 * half + t * square); };
  const double vertex = square > 0 ? std::clamp(-half / square, from, to) : from;
  return std::max(radius2(from), radius2(to)) >= box.low[0] * std::abs(box.low[0]) &&
         radius2(vertex) <= box.high[0] * box.high[0];
}

/// The frustum is n_r r = g with g linear along the ray: a quadratic equation for the distance.
void Section::meet(const Ray& ray, Index f, Index from_facet, double sense, std::optional<Hit>& nearest) const {
  const Facet& facet = facets_[f];
  const Eigen::Vector3d &o = ray.origin, &d = ray.direction;
  const double nr = facet.normal[0], nz = facet.normal[1];
  const double g0 = nr * facet.from[0] - nz * (o[2] - facet.from[1]), g1 = -nz * d[2];
  std::array<double, 2> roots{-1, -1};
  if (geometry_ == Geometry::planar) {
    const double rate = nr * d[0] - g1;
    if (sense * rate > 0) roots[0] = (g0 - nr * o[0]) / rate;
  } else if (std::abs(nr) < flat) {
    if (g1 != 0) {
      roots[0] = -g0 / g1;
      for (int i = 0; i < 2; ++i)
        roots[0] =
            (nr * std::sqrt(std::pow(o[0] + roots[0] * d[0], 2) + std::pow(o[1] + roots[0] * d[1], 2)) - g0) / g1;
    }
  } else {
    const double a = nr * nr * (d[0] * d[0] + d[1] * d[1]) - g1 * g1,
                 b = nr * nr * (o[0] * d[0] + o[1] * d[1]) - g0 * g1,
                 c = nr * nr * (o[0] * o[0] + o[1] * o[1]) - g0 * g0, square = b * b - a * c;
    if (square < 0) return;
    const double q = -(b + std::copysign(std::sqrt(square), b));
    roots = {a != 0 ? q / a : -1, q != 0 ? c / q : -1};
  }
  const double length2 = facet.along.squaredNorm();
  for (const double t : roots) {
    if (!(t > (f == from_facet ? 1e3 * tiny_ : tiny_)) || (nearest && t >= nearest->distance)) continue;
    const Eigen::Vector3d x = ray.at(t);
    const Point at = project(x);
    const double share = (at - facet.from).dot(facet.along) / length2;
    if (share < -overlap || share > 1 + overlap) continue;
    if (std::abs((at - facet.from).dot(facet.normal)) > 1e-6 * std::sqrt(length2) + tiny_)
      continue;  // other half of the cone
    if (sense * facet_normal(f, x).dot(d) <= 0) continue;
    nearest = Hit{t, facet.edge, facet.s + 0.5 * std::clamp(share, 0.0, 1.0), f};
  }
}

std::optional<Hit> Section::first_hit(const Ray& ray, Index from_facet, double sense) const {
  std::optional<Hit> nearest;
  std::array<Index, 64> stack;
  int depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const Box& box = boxes_[stack[--depth]];
    if (!may_meet(ray, box, nearest ? nearest->distance : std::numeric_limits<double>::max() / 4)) continue;
    if (box.left < 0) {
      for (Index f = box.first; f < box.last; ++f) meet(ray, f, from_facet, sense, nearest);
    } else {
      stack[depth++] = box.left;
      stack[depth++] = box.right;
    }
  }
  return nearest;
}

Eigen::Vector3d Section::turned(const Point& v, const Eigen::Vector3d& x) const {
  if (geometry_ == Geometry::planar) return {v[0], 0, v[1]};
  const double r = std::sqrt(x[0] * x[0] + x[1] * x[1]);
  if (r == 0) return {v[0], 0, v[1]};
  return {v[0] * x[0] / r, v[0] * x[1] / r, v[1]};
}

Eigen::Vector3d Section::normal(Index e, double s, const Eigen::Vector3d& x) const {
  const core::BoundaryEdge& edge = mesh_.boundary_edges()[e];
  const auto slope = core::edge_shape_derivative(s);
  const Point along = slope[0] * mesh_.nodes[edge.nodes[0]] + slope[1] * mesh_.nodes[edge.nodes[1]] +
                      slope[2] * mesh_.nodes[edge.nodes[2]];
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
