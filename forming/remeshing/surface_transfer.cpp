// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/remeshing/surface_transfer.hpp"

#include <algorithm>
#include <limits>

#include "core/mesh/element.hpp"
#include "forming/step/contact/contact_geometry.hpp"

namespace parison::forming {

namespace {

/// Nearest point found so far: its squared distance, m2, its edge and where on that.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  const core::BoundaryEdge* edge = nullptr;
  double s = 0;
};

/// Looks at one half of an edge, from s = `begin`, as the straight line between two nodes.
void consider(const core::Mesh& old, const core::BoundaryEdge& edge, core::Index first, core::Index last, double begin,
              const core::Point& x, Nearest& nearest) {
  const core::Point along = old.nodes[last] - old.nodes[first], from = x - old.nodes[first];
  const double length = along.squaredNorm();
  const double s = length > 0 ? std::clamp(from.dot(along) / length, 0.0, 1.0) : 0;
  const double distance = (from - s * along).squaredNorm();
  if (distance < nearest.distance) nearest = {distance, &edge, begin + 0.5 * s};
}

/// Quadratic along the edge, within the range of its nodes.
double value_at(const Nearest& at, const Eigen::VectorXd& field) {
  if (!at.edge) return 0;
  const Eigen::Vector3d nodal(field[at.edge->nodes[0]], field[at.edge->nodes[1]], field[at.edge->nodes[2]]);
  const auto shape = core::edge_shape(at.s);
  const double value = shape[0] * nodal[0] + shape[1] * nodal[1] + shape[2] * nodal[2];
  return std::clamp(value, nodal.minCoeff(), nodal.maxCoeff());
}

}  // namespace

Eigen::VectorXd carry_along_surface(const core::Mesh& old, const Eigen::VectorXd& field, const core::Mesh& mesh) {
  Eigen::VectorXd carried = Eigen::VectorXd::Zero(mesh.node_count());
  const auto touches = core::boundaries_of_kind(old, core::BoundaryKind::contact);
  for (const core::Index node : contact_nodes(mesh)) {
    Nearest nearest;
    for (const core::BoundaryEdge& edge : old.boundary_edges()) {
      if (!touches[edge.boundary_id]) continue;
      consider(old, edge, edge.nodes[0], edge.nodes[2], 0, mesh.nodes[node], nearest);
      consider(old, edge, edge.nodes[2], edge.nodes[1], 0.5, mesh.nodes[node], nearest);
    }
    carried[node] = value_at(nearest, field);
  }
  return carried;
}

}  // namespace parison::forming
