// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/surface.hpp"

#include <algorithm>

#include "core/mesh/element.hpp"

namespace parison::flow {

using core::dim;

bool wholly_in_contact(const core::BoundaryEdge& edge, const std::vector<bool>& in_contact) {
  return std::all_of(edge.nodes.begin(), edge.nodes.end(), [&](Index node) { return in_contact[node]; });
}

std::vector<SurfaceEdge> surface_edges(const Problem& problem) {
  const auto& mesh = *problem.mesh;
  std::vector<SurfaceEdge> edges;
  edges.reserve(mesh.boundary_edges().size());
  for (const auto& edge : mesh.boundary_edges()) {
    const auto& condition = problem.boundary_conditions[edge.boundary_id];
    const bool free = condition.kind == BoundaryCondition::Kind::free;
    SurfaceEdge result{{}, {Point::Zero(), Point::Zero(), Point::Zero()}};
    for (const auto& rule : core::edge_rule(3)) {
      const auto at = core::map_edge_point(mesh, edge.nodes, problem.geometry, rule);
      const auto derivative = core::edge_shape_derivative(rule.s);
      Point along = Point::Zero();
      for (int i = 0; i < 3; ++i) along += derivative[i] * mesh.nodes[edge.nodes[i]];
      const double tension = problem.material->surface_tension * at.area;
      for (int i = 0; i < 3; ++i) {
        result.area[i] += at.area * at.shape[i];
        if (!free) continue;
        result.load[i] -= condition.pressure * at.area * at.shape[i] * at.normal;
        result.load[i] -= tension * derivative[i] / along.norm() * at.tangent;
        result.load[i][0] -= tension * core::hoop(problem.geometry, at.position) * at.shape[i];
      }
    }
    edges.push_back(result);
  }
  return edges;
}

Eigen::VectorXd surface_load(const core::Mesh& mesh, const std::vector<SurfaceEdge>& edges,
                             const std::vector<bool>& in_contact) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(dim * mesh.node_count());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (wholly_in_contact(mesh.boundary_edges()[e], in_contact)) continue;
    for (int i = 0; i < 3; ++i) load.segment<dim>(dim * mesh.boundary_edges()[e].nodes[i]) += edges[e].load[i];
  }
  return load;
}

Eigen::VectorXd contact_areas(const core::Mesh& mesh, const std::vector<SurfaceEdge>& edges,
                              const std::vector<bool>& in_contact) {
  Eigen::VectorXd area = Eigen::VectorXd::Zero(mesh.node_count()), any = area;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto& nodes = mesh.boundary_edges()[e].nodes;
    auto& sum = wholly_in_contact(mesh.boundary_edges()[e], in_contact) ? area : any;
    for (int i = 0; i < 3; ++i) sum[nodes[i]] += edges[e].area[i];
  }
  for (const auto& edge : mesh.boundary_edges())
    for (const Index node : edge.nodes)
      if (in_contact[node] && area[node] <= 0) area[node] = std::max(area[node], any[node]);
  return area;
}

}  // namespace parison::flow
