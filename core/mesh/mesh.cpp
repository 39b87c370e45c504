// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include "core/mesh/cell_batch.hpp"
#include "core/mesh/uniform_grid.hpp"

namespace parison::core {

namespace {

/// Chains boundary edges loop by loop, starting each loop at the lowest remaining edge.
std::vector<BoundaryEdge> chained(const std::vector<BoundaryEdge>& edges) {
  std::map<Index, std::size_t> starting_at;
  for (std::size_t i = 0; i < edges.size(); ++i) starting_at[edges[i].nodes[0]] = i;
  std::vector<BoundaryEdge> result;
  result.reserve(edges.size());
  std::vector<bool> used(edges.size(), false);
  for (std::size_t first = 0; first < edges.size(); ++first) {
    for (std::size_t i = first; !used[i];) {
      used[i] = true;
      result.push_back(edges[i]);
      const auto next = starting_at.find(edges[i].nodes[1]);
      if (next == starting_at.end()) break;
      i = next->second;
    }
  }
  return result;
}

/// Shape functions at the points of a rule, and their weights.
template <int points>
struct Rule {
  CellShapes<6, points> shapes;
  std::array<double, points> weight;

  explicit Rule(int degree) {
    const auto& rule = triangle_rule(degree);
    assert(rule.size() == points);
    for (int q = 0; q < points; ++q) {
      set_shapes(rule[q].a, rule[q].b, q, shapes);
      weight[q] = rule[q].weight;
    }
  }
};

/// Weight times measure, m3, and the value of a field at the points of a rule, [point], in the cells of a batch.
template <int points>
struct FieldAtPoints {
  std::array<VectorizedArray, points> measure, value;
};
template <int points>
[[gnu::always_inline]] inline void set_field(const Rule<points>& rule, const Mesh& mesh, const Depth& depth,
                                             const Eigen::VectorXd& nodal, Index batch, FieldAtPoints<points>& field) {
  BatchIndices<6> nodes;
  NodeVectors x;
  UnknownValues<6> at_nodes;
  MappedPoint<VectorizedArray> at;
  set_nodes(mesh.cells(), batch, nodes);
  gather(mesh.nodes.front().data(), nodes, x);
  gather(nodal.data(), nodes, at_nodes);
  for (int q = 0; q < points; ++q) {
    map_point(rule.shapes, q, x, at);
    depth.set(at.position[0], field.measure[q]);
    field.measure[q] *= rule.weight[q] * at.determinant;
    interpolate(rule.shapes.value, q, at_nodes, field.value[q]);
  }
}

[[gnu::target_clones("avx2", "default")]] void set_field_of_batch(const Rule<6>& rule, const Mesh& mesh,
                                                                  const Depth& depth, const Eigen::VectorXd& nodal,
                                                                  Index batch, FieldAtPoints<6>& field) {
  set_field(rule, mesh, depth, nodal, batch, field);
}

/// Integrals of a field and of one, lane by lane.
struct MeanIntegrals {
  VectorizedArray content{}, volume{};
};
[[gnu::target_clones("avx2", "default")]] void set_mean_integrals(const Rule<12>& rule, const Mesh& mesh,
                                                                  const Depth& depth, const Eigen::VectorXd& nodal,
                                                                  MeanIntegrals& sums) {
  FieldAtPoints<12> field;
  for (Index batch = 0; batch < batch_count(mesh.cell_count()); ++batch) {
    set_field(rule, mesh, depth, nodal, batch, field);
    for (auto& measure : field.measure)
      for (int lane = filled_lanes(mesh.cell_count(), batch); lane < batch_size; ++lane) measure[lane] = 0;
    for (std::size_t q = 0; q < field.measure.size(); ++q) {
      sums.content += field.measure[q] * field.value[q];
      sums.volume += field.measure[q];
    }
  }
}

}  // namespace

Topology& Mesh::edit() {
  if (topology_.use_count() > 1) topology_ = std::make_shared<Topology>(*topology_);
  return *topology_;
}

BoundaryChain::BoundaryChain(const Mesh& mesh)
    : next(mesh.boundary_edges().size()), previous(mesh.boundary_edges().size()) {
  const auto& edges = mesh.boundary_edges();
  const auto count = static_cast<Index>(edges.size());
  for (Index e = 0, first = 0; e < count; ++e) {
    const bool chained = e + 1 < count && edges[e + 1].nodes[0] == edges[e].nodes[1];
    next[e] = chained ? e + 1 : first;
    if (!chained) first = e + 1;
  }
  for (Index e = 0; e < count; ++e) previous[next[e]] = e;
}

std::vector<bool> boundaries_of_kind(const Mesh& mesh, BoundaryKind kind) {
  std::vector<bool> flags;
  for (const MeshBoundary& boundary : mesh.boundaries()) flags.push_back(boundary.kind == kind);
  return flags;
}

Index find_boundary(const Mesh& mesh, const std::string& name) {
  const auto& all = mesh.boundaries();
  const auto found = std::find_if(all.begin(), all.end(), [&](const MeshBoundary& each) { return each.name == name; });
  return found == all.end() ? -1 : static_cast<Index>(found - all.begin());
}

Mesh make_quadratic_mesh(const std::vector<Point>& vertices, const std::vector<std::array<Index, 3>>& triangles) {
  struct Side {
    Index middle, count, cell, first, last;
  };
  Mesh mesh;
  mesh.nodes = vertices;
  mesh.edit().vertex_count = static_cast<Index>(vertices.size());
  mesh.edit().boundaries = {"boundary"};
  mesh.edit().cells.reserve(triangles.size());
  std::map<std::pair<Index, Index>, Side> sides;
  for (const auto& triangle : triangles) {
    std::array<Index, 6> cell{triangle[0], triangle[1], triangle[2], 0, 0, 0};
    for (int k = 0; k < 3; ++k) {
      const Index a = triangle[k], b = triangle[(k + 1) % 3];
      auto [it, is_new] = sides.try_emplace(std::minmax(a, b), Side{mesh.node_count(), 0, mesh.cell_count(), a, b});
      if (is_new) mesh.nodes.push_back(0.5 * (vertices[a] + vertices[b]));
      ++it->second.count;
      cell[3 + k] = it->second.middle;
    }
    mesh.edit().cells.push_back(cell);
  }
  std::vector<BoundaryEdge> boundary;
  for (const auto& [ends, side] : sides)
    if (side.count == 1) boundary.push_back({{side.first, side.last, side.middle}, side.cell, 0});
  mesh.edit().boundary_edges = chained(boundary);
  return mesh;
}

Eigen::VectorXd from_vertices(const Mesh& mesh, const Eigen::VectorXd& vertex_values) {
  Eigen::VectorXd nodal(mesh.node_count());
  nodal.head(mesh.vertex_count()) = vertex_values;
  for (const auto& cell : mesh.cells())
    for (int k = 0; k < 3; ++k) nodal[cell[3 + k]] = 0.5 * (nodal[cell[k]] + nodal[cell[(k + 1) % 3]]);
  return nodal;
}

double size(const Mesh& mesh) {
  const Box box = bounding_box(mesh.nodes);
  return (box.high - box.low).norm();
}

double volume(const Mesh& mesh, Geometry geometry) {
  // Gauss: the depth's integral over the first coordinate flows out through the boundary; degree 5 on a quadratic edge.
  struct Place {
    double weight;
    std::array<double, 3> shape, derivative;
  };
  static const std::vector<Place> places = [] {
    std::vector<Place> made;
    for (const auto& at : edge_rule(3)) made.push_back({at.weight, edge_shape(at.s), edge_shape_derivative(at.s)});
    return made;
  }();
  const double fraction = geometry == Geometry::axisymmetric ? 0.5 : 1.0;
  long double sum = 0;  // the two sides of a thin wall all but cancel
  for (const BoundaryEdge& edge : mesh.boundary_edges())
    for (const Place& at : places) {
      double first = 0, rise = 0;  // the first coordinate and the derivative of the second
      for (int i = 0; i < 3; ++i) {
        const Point& x = mesh.nodes[edge.nodes[i]];
        first += at.shape[i] * x[0];
        rise += at.derivative[i] * x[1];
      }
      sum += fraction * at.weight * depth(geometry, {first, 0}) * first * rise;
    }
  return static_cast<double>(sum);
}

double mean_wall(const Mesh& mesh) {
  double area = 0, outline = 0;
  for (const BoundaryEdge& edge : mesh.boundary_edges()) {
    const Point &a = mesh.nodes[edge.nodes[0]], &b = mesh.nodes[edge.nodes[1]];
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    if (mesh.kind_of(edge) != BoundaryKind::symmetry) outline += (b - a).norm();
  }
  return 2 * std::abs(area) / outline;
}

double integral(const Mesh& mesh, Geometry geometry, const Eigen::VectorXd& nodal,
                const std::function<double(double)>& function) {
  static const Rule<6> rule(4);
  const Depth depth(geometry);
  FieldAtPoints<6> field;
  double sum = 0;
  for (Index batch = 0; batch < batch_count(mesh.cell_count()); ++batch) {
    set_field_of_batch(rule, mesh, depth, nodal, batch, field);
    for (int lane = 0; lane < filled_lanes(mesh.cell_count(), batch); ++lane)
      for (int q = 0; q < 6; ++q) sum += field.measure[q][lane] * function(field.value[q][lane]);
  }
  return sum;
}

double integral(const Mesh& mesh, Geometry geometry, const Eigen::VectorXd& first, const Eigen::VectorXd& second,
                const std::function<double(double, double)>& function) {
  static const Rule<6> rule(4);
  const Depth depth(geometry);
  FieldAtPoints<6> one, other;
  double sum = 0;
  for (Index batch = 0; batch < batch_count(mesh.cell_count()); ++batch) {
    set_field_of_batch(rule, mesh, depth, first, batch, one);
    set_field_of_batch(rule, mesh, depth, second, batch, other);
    for (int lane = 0; lane < filled_lanes(mesh.cell_count(), batch); ++lane)
      for (int q = 0; q < 6; ++q) sum += one.measure[q][lane] * function(one.value[q][lane], other.value[q][lane]);
  }
  return sum;
}

double volume_mean(const Mesh& mesh, Geometry geometry, const Eigen::VectorXd& nodal) {
  static const Rule<12> rule(6);
  const double base = nodal[0];  // a uniform field has its own value as the mean
  MeanIntegrals sums;
  set_mean_integrals(rule, mesh, Depth(geometry), nodal.array() - base, sums);
  return base + sum(sums.content, batch_size) / sum(sums.volume, batch_size);
}

}  // namespace parison::core
