// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/wall_thickness.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include "core/mesh/element.hpp"
#include "remesh/mesher/fans.hpp"

namespace parison::remesh {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Point edge_point(const Mesh& mesh, const std::array<Index, 3>& edge, double s) {
  const auto n = core::edge_shape(s);
  return n[0] * mesh.nodes[edge[0]] + n[1] * mesh.nodes[edge[1]] + n[2] * mesh.nodes[edge[2]];
}

Point edge_derivative(const Mesh& mesh, const std::array<Index, 3>& edge, double s) {
  const auto d = core::edge_shape_derivative(s);
  return d[0] * mesh.nodes[edge[0]] + d[1] * mesh.nodes[edge[1]] + d[2] * mesh.nodes[edge[2]];
}

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

/// Finds where rays leave a body, by an R-tree of the boxes of its boundary edges. The tree is asked for what meets the
/// box of a ray: a test of the ray itself costs more than the edges that it would exclude.
class BoundaryRays {
 public:
  explicit BoundaryRays(const Mesh& mesh) : mesh_(mesh) {
    std::vector<IndexedBox> boxes;
    boxes.reserve(mesh.boundary_edges().size());
    for (const core::BoundaryEdge& edge : mesh.boundary_edges())
      boxes.emplace_back(box_of(mesh, edge.nodes), static_cast<Index>(boxes.size()));
    edges_ = decltype(edges_)(boxes);
    const BoostBox all = edges_.bounds();
    extent_ = boost::geometry::distance(all.min_corner(), all.max_corner());
  }

  struct Hit {
    double distance = infinity;  ///< m
    Index edge = -1;
  };

  /// First edge at which the ray along a unit vector from a node leaves the body; edges of that node do not count.
  /// Edges beyond `reach`, m, may be missed. It is sought as far as `expected` first, m, which must be above 0: the box
  /// of a long ray meets many edges.
  Hit first_exit(Index from, const Point& direction, double reach, double expected) const {
    constexpr double farther = 4;
    const double whole = std::min(reach, extent_);
    for (double length = std::min(expected, whole);; length = std::min(farther * length, whole)) {
      const Hit hit = first_exit_within(length, from, direction);
      if (length == whole || hit.distance <= length) return hit;
    }
  }

 private:
  Hit first_exit_within(double length, Index from, const Point& direction) const {
    const Point start = mesh_.nodes[from], end = start + length * direction;
    Hit hit;
    const Point low = start.cwiseMin(end), high = start.cwiseMax(end);
    edges_.query(index::intersects(BoostBox{{low[0], low[1]}, {high[0], high[1]}}),
                 boost::make_function_output_iterator(
                     [&](const IndexedBox& box) { try_edge(from, direction, box.second, hit); }));
    return hit;
  }

  void try_edge(Index from, const Point& direction, Index i, Hit& hit) const {
    const auto& edge = mesh_.boundary_edges()[i].nodes;
    if (edge[0] == from || edge[1] == from || edge[2] == from) return;
    const Point start = mesh_.nodes[from], left(-direction[1], direction[0]);
    const double a = left.dot(mesh_.nodes[edge[0]] - start), b = left.dot(mesh_.nodes[edge[1]] - start);
    const double slack = 1e-9 * std::abs(b - a);
    // A ray that leaves sees the edge pass from right to left.
    if (a > slack || b < -slack || b <= a) return;
    double s = a / (a - b);
    for (int pass = 0; pass < 4; ++pass) {
      const double derivative = left.dot(edge_derivative(mesh_, edge, s));
      if (derivative > 0) s = std::clamp(s - left.dot(edge_point(mesh_, edge, s) - start) / derivative, 0.0, 1.0);
    }
    const double distance = direction.dot(edge_point(mesh_, edge, s) - start);
    const bool nearer = distance < hit.distance || (distance == hit.distance && i < hit.edge);
    if (distance > 0 && nearer) hit = {distance, i};
  }

  const Mesh& mesh_;
  double extent_ = 0;  ///< m: no chord of the body is longer
  index::rtree<IndexedBox, index::quadratic<8>> edges_;
};

/// Whether a body goes on as its mirror image behind boundaries of some kind.
using Mirrors = bool (*)(core::BoundaryKind);

bool is_symmetry(core::BoundaryKind kind) {
  return kind == core::BoundaryKind::symmetry;
}

bool passes_no_heat(core::BoundaryKind kind) {
  return is_symmetry(kind) || kind == core::BoundaryKind::insulated || kind == core::BoundaryKind::fixed;
}

/// Sum of the outward unit normals of the edges that meet at each node; zero inside and on mirrors.
std::vector<Point> surface_normals(const Mesh& mesh, Mirrors mirrors) {
  std::vector<Point> normals(mesh.nodes.size(), Point::Zero());
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    if (mirrors(mesh.kind_of(edge))) continue;
    constexpr std::array<double, 3> places{0, 1, 0.5};
    for (int k = 0; k < 3; ++k) {
      const Point along = edge_derivative(mesh, edge.nodes, places[k]).normalized();
      normals[edge.nodes[k]] += Point(along[1], -along[0]);
    }
  }
  return normals;
}

/// For each vertex the nearest node with a finite value, found by a front that advances from vertex to vertex in the
/// order of distance (E. W. Dijkstra, Numer. Math. 1 (1959) 269-271); -1 without such a node.
std::vector<Index> sources_of_vertices(const Mesh& mesh, const Eigen::VectorXd& value) {
  struct Front {
    double distance;  ///< squared
    Index vertex, source;
    bool operator>(const Front& other) const {
      return std::tie(distance, vertex) > std::tie(other.distance, other.vertex);
    }
  };
  std::vector<double> reached(mesh.vertex_count(), infinity);
  std::vector<Index> source(mesh.vertex_count(), -1);
  const auto reach = [&](Index vertex, Index from) {
    const double distance = (mesh.nodes[vertex] - mesh.nodes[from]).squaredNorm();
    const bool nearer = distance < reached[vertex];
    if (nearer) reached[vertex] = distance, source[vertex] = from;
    return nearer;
  };
  for (const auto& cell : mesh.cells())
    for (const Index node : cell)
      if (std::isfinite(value[node]))
        for (int i = 0; i < 3; ++i) reach(cell[i], node);
  std::vector<Front> first;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (source[v] >= 0) first.push_back({reached[v], v, source[v]});
  std::priority_queue<Front, std::vector<Front>, std::greater<>> fronts(std::greater<>(), std::move(first));
  const Fans fans = fans_of(mesh);
  while (!fronts.empty()) {
    const Front front = fronts.top();
    fronts.pop();
    if (front.source != source[front.vertex]) continue;
    for (Index k = fans.start[front.vertex]; k < fans.start[front.vertex + 1]; ++k)
      for (int i = 0; i < 3; ++i) {
        const Index vertex = mesh.cells()[fans.cell[k]][i];
        if (source[vertex] != front.source && reach(vertex, front.source))
          fronts.push({reached[vertex], vertex, front.source});
      }
  }
  return source;
}

}  // namespace

void spread_inward(const Mesh& mesh, Eigen::VectorXd& value) {
  std::vector<Index> source = sources_of_vertices(mesh, value);
  source.resize(mesh.nodes.size(), -1);
  for (const auto& cell : mesh.cells())
    for (int i = 0; i < 3; ++i) {  // a mid-side node takes the nearer of its ends' sources
      const Index node = cell[3 + i], a = source[cell[i]], b = source[cell[(i + 1) % 3]];
      if (a < 0 || b < 0) continue;
      const double from_a = (mesh.nodes[node] - mesh.nodes[a]).squaredNorm();
      const double from_b = (mesh.nodes[node] - mesh.nodes[b]).squaredNorm();
      source[node] = std::tie(from_a, a) < std::tie(from_b, b) ? a : b;
    }
  for (Index i = 0; i < mesh.node_count(); ++i)
    if (!std::isfinite(value[i]) && source[i] >= 0) value[i] = value[source[i]];
}

namespace {

Wall wall_between(const Mesh& mesh, double reach, Mirrors mirrors, const std::vector<bool>& only = {}) {
  const BoundaryRays rays(mesh);
  Wall wall{Eigen::VectorXd::Constant(mesh.node_count(), infinity), std::vector<Index>(mesh.nodes.size(), -1),
            surface_normals(mesh, mirrors)};
  constexpr double likely = 1.5;  // times the thickness beside: a node's own is no greater as a rule
  double beside = infinity;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    for (const Index node : edge.nodes) {
      if (!only.empty() && !only[node]) continue;
      if (mirrors(mesh.kind_of(edge)) || wall.far_edge[node] >= 0 || wall.normal[node].norm() < 1e-6) continue;
      wall.normal[node].normalize();
      const BoundaryRays::Hit hit = rays.first_exit(node, -wall.normal[node], reach, likely * beside);
      if (hit.edge < 0) continue;
      beside = hit.distance;
      wall.far_edge[node] = hit.edge;
      wall.thickness[node] = (mirrors(mesh.kind_of(mesh.boundary_edges()[hit.edge])) ? 2 : 1) * hit.distance;
    }
  }
  return wall;
}

}  // namespace

Wall surface_wall(const Mesh& mesh, double reach, const std::vector<bool>& only) {
  return wall_between(mesh, reach, is_symmetry, only);
}

Eigen::VectorXd wall_thickness(const Mesh& mesh) {
  Eigen::VectorXd thickness = wall_between(mesh, infinity, passes_no_heat).thickness;
  spread_inward(mesh, thickness);
  return thickness;
}

}  // namespace parison::remesh
