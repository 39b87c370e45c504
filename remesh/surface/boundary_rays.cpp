// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/boundary_rays.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "remesh/surface/curve.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

namespace index = boost::geometry::index;
using BoostPoint = boost::geometry::model::point<double, core::dim, boost::geometry::cs::cartesian>;
using BoostBox = boost::geometry::model::box<BoostPoint>;
using IndexedBox = std::pair<BoostBox, Index>;

/// Box around a quadratic edge, a tenth wider on every side than around its nodes.
BoostBox box_of(const Mesh& mesh, const std::array<Index, 3>& edge) {
  const Point &a = mesh.nodes[edge[0]], &b = mesh.nodes[edge[1]], &c = mesh.nodes[edge[2]];
  Point low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  const double widened = 0.1 * (high - low).maxCoeff();
  return {{low[0] - widened, low[1] - widened}, {high[0] + widened, high[1] + widened}};
}

std::vector<IndexedBox> boxes_of(const Mesh& mesh) {
  std::vector<IndexedBox> boxes;
  boxes.reserve(mesh.boundary_edges().size());
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    boxes.emplace_back(box_of(mesh, edge.nodes), static_cast<Index>(boxes.size()));
  return boxes;
}

}  // namespace

struct BoundaryRays::Tree {
  index::rtree<IndexedBox, index::quadratic<8>> edges;
};

BoundaryRays::BoundaryRays(const Mesh& mesh, double grazing)
    : mesh_(mesh), grazing_(grazing), tree_(new Tree{decltype(Tree::edges)(boxes_of(mesh))}) {
  const BoostBox all = tree_->edges.bounds();
  extent_ = boost::geometry::distance(all.min_corner(), all.max_corner());
}

BoundaryRays::~BoundaryRays() = default;

BoundaryRays::Hit BoundaryRays::first_exit(const Ray& ray, double reach, double expected) const {
  constexpr double farther = 4;
  const double whole = std::min(reach, extent_);
  for (double length = std::min(expected, whole);; length = std::min(farther * length, whole)) {
    const Point end = ray.start + length * ray.direction;
    const Point low = ray.start.cwiseMin(end), high = ray.start.cwiseMax(end);
    Hit hit;
    // The box of the ray: a test of the ray itself costs more than the edges that it would exclude.
    tree_->edges.query(
        index::intersects(BoostBox{{low[0], low[1]}, {high[0], high[1]}}),
        boost::make_function_output_iterator([&](const IndexedBox& box) { try_edge(ray, box.second, hit); }));
    if (length == whole || hit.distance <= length) return hit;
  }
}

void BoundaryRays::try_edge(const Ray& ray, Index i, Hit& hit) const {
  const auto& edge = mesh_.boundary_edges()[i].nodes;
  if (i == ray.edge || std::find(edge.begin(), edge.end(), ray.node) != edge.end()) return;
  const Point left(-ray.direction[1], ray.direction[0]);
  const double a = left.dot(mesh_.nodes[edge[0]] - ray.start), b = left.dot(mesh_.nodes[edge[1]] - ray.start);
  const double slack = 1e-9 * std::abs(b - a);
  // A ray that leaves sees the edge pass from right to left.
  if (a > slack || b < -slack || b <= a) return;
  if (grazing_ > 0 && b - a <= grazing_ * (mesh_.nodes[edge[1]] - mesh_.nodes[edge[0]]).norm()) return;
  double s = a / (a - b);
  for (int pass = 0; pass < 4; ++pass) {
    const double slope = left.dot(derivative(mesh_, edge, s));
    if (slope > 0) s = std::clamp(s - left.dot(point_on(mesh_, edge, s) - ray.start) / slope, 0.0, 1.0);
  }
  const double distance = ray.direction.dot(point_on(mesh_, edge, s) - ray.start);
  const bool nearer = distance < hit.distance || (distance == hit.distance && i < hit.edge);
  if (distance > 0 && nearer) hit = {distance, i, s};
}

}  // namespace parison::remesh
