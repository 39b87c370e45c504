// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/curve.hpp"

#include <algorithm>

#include "core/mesh/element.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;
using Edge = std::array<Index, 3>;

Point point_on(const Mesh& mesh, const Edge& edge, double s) {
  const auto n = core::edge_shape(s);
  return n[0] * mesh.nodes[edge[0]] + n[1] * mesh.nodes[edge[1]] + n[2] * mesh.nodes[edge[2]];
}

Point derivative(const Mesh& mesh, const Edge& edge, double s) {
  const auto d = core::edge_shape_derivative(s);
  return d[0] * mesh.nodes[edge[0]] + d[1] * mesh.nodes[edge[1]] + d[2] * mesh.nodes[edge[2]];
}

Point tangent(const Mesh& mesh, const Edge& edge, double s) {
  return derivative(mesh, edge, s).normalized();
}

Point outward_normal(const Mesh& mesh, const Edge& edge, double s) {
  const Point along = tangent(mesh, edge, s);
  return {along[1], -along[0]};
}

std::vector<Point> normal_sums(const Mesh& mesh, const std::vector<bool>& counts) {
  constexpr std::array<double, 3> ends{0, 1, 0.5};
  std::vector<Point> normals(mesh.nodes.size(), Point::Zero());
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    for (int k = 0; k < 3 && counts[edge.boundary_id]; ++k)
      normals[edge.nodes[k]] += outward_normal(mesh, edge.nodes, ends[k]);
  return normals;
}

double arc_length(const Mesh& mesh, const Edge& edge, double s) {
  double sum = 0;
  for (const core::EdgeRulePoint& at : core::edge_rule(5))
    sum += at.weight * s * derivative(mesh, edge, at.s * s).norm();
  return sum;
}

double at_arc_length(const Mesh& mesh, const Edge& edge, double length) {
  double s = length / arc_length(mesh, edge, 1);
  for (int pass = 0; pass < 4; ++pass) {
    const double speed = derivative(mesh, edge, s).norm();
    if (speed > 0) s = std::clamp(s - (arc_length(mesh, edge, s) - length) / speed, 0.0, 1.0);
  }
  return s;
}

double closest_on(const Mesh& mesh, const Edge& edge, const Point& x) {
  double s = 0.5, best = (point_on(mesh, edge, s) - x).norm();
  for (const double start : {0.0, 0.25, 0.75, 1.0}) {
    const double gap = (point_on(mesh, edge, start) - x).norm();
    if (gap < best) best = gap, s = start;
  }
  for (int pass = 0; pass < 6; ++pass) {
    const Point d = derivative(mesh, edge, s);
    s = std::clamp(s + d.dot(x - point_on(mesh, edge, s)) / d.squaredNorm(), 0.0, 1.0);
  }
  return s;
}

double turning(const Point& before, const Point& after) {
  return std::atan2(before[0] * after[1] - before[1] * after[0], before.dot(after));
}

std::vector<Link> boundary_links(const Mesh& mesh) {
  const auto count = static_cast<Index>(mesh.boundary_edges().size());
  std::vector<Link> links(count);
  for (Index start = 0; start < count;) {
    Index last = start;
    while (mesh.boundary_edges()[last].nodes[1] != mesh.boundary_edges()[start].nodes[0]) ++last;
    for (Index i = start; i <= last; ++i) {
      links[i].previous = i == start ? last : i - 1;
      links[i].next = i == last ? start : i + 1;
      links[i].kink = turning(tangent(mesh, mesh.boundary_edges()[links[i].previous].nodes, 1),
                              tangent(mesh, mesh.boundary_edges()[i].nodes, 0));
    }
    start = last + 1;
  }
  return links;
}

Mesh without_collapsed_edges(Mesh mesh, const std::vector<bool>& contact) {
  constexpr double collapsed = 0.01, short_in_air = 0.1;  // largest chord, in chords of the shorter neighbour
  const std::vector<Link> links = boundary_links(mesh);
  const auto chord = [&](Index i) {
    const Edge& edge = mesh.boundary_edges()[i].nodes;
    return (mesh.nodes[edge[1]] - mesh.nodes[edge[0]]).norm();
  };
  std::vector<core::BoundaryEdge> kept;
  std::vector<bool> leaves(links.size(), false);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Index previous = links[i].previous, next = links[i].next;
    const Edge& own = mesh.boundary_edges()[i].nodes;
    const bool in_air = !contact.empty() && std::none_of(own.begin(), own.end(), [&](Index n) { return contact[n]; });
    const double most = (in_air ? short_in_air : collapsed) * std::min(chord(previous), chord(next));
    if (leaves[previous] || leaves[next] || chord(static_cast<Index>(i)) > most) continue;
    const Edge& nodes = mesh.boundary_edges()[i].nodes;
    const Index boundary_id = mesh.boundary_edges()[i].boundary_id;
    leaves[i] = true;
    if (mesh.boundary_edges()[previous].boundary_id == boundary_id)
      mesh.edit().boundary_edges[previous].nodes[1] = nodes[1];
    else if (mesh.boundary_edges()[next].boundary_id == boundary_id)
      mesh.edit().boundary_edges[next].nodes[0] = nodes[0];
    else
      leaves[i] = false;
  }
  for (std::size_t i = 0; i < links.size(); ++i)
    if (!leaves[i]) kept.push_back(mesh.boundary_edges()[i]);
  mesh.edit().boundary_edges = std::move(kept);
  return mesh;
}

}  // namespace parison::remesh
