// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/wall/wall_coordinates.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "core/linear/cholesky.hpp"
#include "core/mesh/element.hpp"
#include "core/process/run_error.hpp"

namespace parison::remesh {

namespace {

/// Values that a harmonic function has on parts of the boundary, by node.
using Given = std::map<Index, double>;

/// Solves Laplace's equation in the plane of the section; where no value is given the normal derivative is zero.
Eigen::VectorXd harmonic(const core::Mesh& mesh, const Given& given) {
  core::Cliques cliques;
  for (const auto& cell : mesh.cells()) cliques.add(cell.data(), 6);
  auto [matrix, scatter] = core::make_assembly(mesh.node_count(), cliques);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(mesh.node_count());
  constexpr double held = 1e12;  // times the largest entry of a row
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    std::array<double, 36> local{};
    for (const auto& rule : core::triangle_rule(4)) {
      const core::CellPoint point = core::map_cell_point(mesh, c, core::Geometry::planar, rule);
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
          local[static_cast<std::size_t>(6 * i + j)] += point.volume * point.gradient[i].dot(point.gradient[j]);
    }
    for (int i = 0; i < 6; ++i) {
      const auto value = given.find(mesh.cells()[c][i]);
      if (value == given.end()) continue;
      double& diagonal = local[static_cast<std::size_t>(7 * i)];
      load[value->first] += held * diagonal * value->second;
      diagonal *= held;
    }
    core::add_clique(matrix, scatter, c, 6, local.data());
  }
  core::Cholesky cholesky;
  cholesky.analyse(matrix);
  if (!cholesky.factorise(matrix)) throw core::RunError("the section of the parison cannot be followed in space");
  return cholesky.solve(load);
}

void add_edge(const core::BoundaryEdge& edge, double value, Given& given) {
  for (const Index node : edge.nodes) given[node] = value;
}

/// The round end of a wall on which both sides meet.
class RoundEnd {
 public:
  RoundEnd(const core::Mesh& section, std::vector<SurfacePart>& part) : section_(section), part_(part) {}

  /// Makes those edges of either side a rim that run rather across the wall than along it; the last ones anyway.
  void cut() {
    for (const core::BoundaryEdge& edge : section_.boundary_edges())
      for (const int end : {0, 1})
        if (last_edge(SurfacePart::inner, edge.nodes[end]) && last_edge(SurfacePart::outer, edge.nodes[end])) {
          std::array<Index, 2> ends{edge.nodes[end], edge.nodes[end]};
          while (shorten(ends)) {
          }
          return;
        }
  }

 private:
  std::optional<std::size_t> last_edge(SurfacePart part, Index node) const {
    for (std::size_t e = 0; e < part_.size(); ++e)
      if (part_[e] == part && far_node(e, node) >= 0) return e;
    return {};
  }
  /// The other end of an edge; -1 where it does not end at a node.
  Index far_node(std::size_t edge, Index node) const {
    const auto& nodes = section_.boundary_edges()[edge].nodes;
    return nodes[0] == node ? nodes[1] : nodes[1] == node ? nodes[0] : -1;
  }
  bool shorten(std::array<Index, 2>& ends) {
    constexpr double steep = 0.7;  // cosine of 45 degrees
    const Point across = section_.nodes[ends[1]] - section_.nodes[ends[0]];
    bool is_shorter = false;
    for (const int side : {0, 1}) {
      const auto edge = last_edge(side == 0 ? SurfacePart::inner : SurfacePart::outer, ends[side]);
      if (!edge) continue;
      const Index next = far_node(*edge, ends[side]);
      const Point along = section_.nodes[next] - section_.nodes[ends[side]];
      if (std::abs(along.dot(across)) < steep * along.norm() * across.norm()) continue;
      part_[*edge] = SurfacePart::rim;
      ends[side] = next;
      is_shorter = true;
    }
    return is_shorter;
  }

  const core::Mesh& section_;
  std::vector<SurfacePart>& part_;
};

std::vector<SurfacePart> parts_with_rim(const core::Mesh& section, std::vector<SurfacePart> part) {
  if (std::count(part.begin(), part.end(), SurfacePart::rim) == 0) RoundEnd(section, part).cut();
  return part;
}

/// The same cells in harmonic coordinates.
core::Mesh rectangle_of(const core::Mesh& section, const std::vector<SurfacePart>& parts) {
  Given along, across;
  std::array<int, 4> found{};  // edges of the axis, the rim, the inner and the outer side
  for (std::size_t e = 0; e < section.boundary_edges().size(); ++e) {
    const core::BoundaryEdge& edge = section.boundary_edges()[e];
    if (section.kind_of(edge) == core::BoundaryKind::symmetry) add_edge(edge, 0, along), ++found[0];
    if (parts[e] == SurfacePart::rim) add_edge(edge, 1, along), ++found[1];
    if (parts[e] == SurfacePart::inner) add_edge(edge, 0, across), ++found[2];
    if (parts[e] == SurfacePart::outer) add_edge(edge, 1, across), ++found[3];
  }
  constexpr std::array missing{"place on the axis", "rim", "inner side", "outer side"};
  for (std::size_t part = 0; part < found.size(); ++part)
    if (found[part] == 0)
      throw core::RunError(std::string("the parison has no ") + missing[part] +
                           ", so that it is no wall to follow in space");
  core::Mesh rectangle = section;
  const Eigen::VectorXd first = harmonic(section, along), second = harmonic(section, across);
  for (Index n = 0; n < section.node_count(); ++n) rectangle.nodes[n] = {first[n], second[n]};
  return rectangle;
}

}  // namespace

WallCoordinates::WallCoordinates(const core::Mesh& section, const WallSides& sides)
    : section_(&section),
      part_(parts_with_rim(section, sides.part)),
      rectangle_(rectangle_of(section, part_)),
      cells_(rectangle_) {}

core::Point WallCoordinates::place(double along, double across) const {
  const CellGrid::Found found = cells_.find({along, across});
  const auto shape = core::triangle_shape(found.at[0], found.at[1]);
  core::Point at = core::Point::Zero();
  for (int i = 0; i < 6; ++i) at += shape[i] * section_->nodes[section_->cells()[found.cell][i]];
  return at;
}

std::vector<WallCoordinates::SidePoint> WallCoordinates::side(SurfacePart part) const {
  constexpr int pieces = 8;  // of an edge
  const auto& edges = section_->boundary_edges();
  const auto along = [&](Index node) { return rectangle_.nodes[node][0]; };
  std::vector<std::array<Index, 3>> chain;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (part_[e] != part) continue;
    auto nodes = edges[e].nodes;
    if (along(nodes[0]) > along(nodes[1])) std::swap(nodes[0], nodes[1]);
    chain.push_back(nodes);
  }
  std::sort(chain.begin(), chain.end(), [&](const auto& a, const auto& b) { return along(a[2]) < along(b[2]); });
  std::vector<SidePoint> points{{along(chain.front()[0]), section_->nodes[chain.front()[0]]}};
  for (const auto& nodes : chain)
    for (int i = 1; i <= pieces; ++i) {
      const auto shape = core::edge_shape(double(i) / pieces);
      SidePoint point{0, core::Point::Zero()};
      for (int n = 0; n < 3; ++n) {
        point.along += shape[n] * along(nodes[n]);
        point.at += shape[n] * section_->nodes[nodes[n]];
      }
      points.push_back(point);
    }
  return points;
}

}  // namespace parison::remesh
