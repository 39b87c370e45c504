// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/remeshing/surface_transfer.hpp"

#include <algorithm>
#include <limits>

#include "forming/step/contact/contact_geometry.hpp"

namespace parison::forming {

namespace {

/// Nearest point found so far: its squared distance, m2, and the field there.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  double value = 0;
};

/// Looks at the straight line between two nodes.
void consider(const core::Mesh& old, const Eigen::VectorXd& field, core::Index first, core::Index last,
              const core::Point& x, Nearest& nearest) {
  const core::Point along = old.nodes[last] - old.nodes[first], from = x - old.nodes[first];
  const double length = along.squaredNorm();
  const double s = length > 0 ? std::clamp(from.dot(along) / length, 0.0, 1.0) : 0;
  const double distance = (from - s * along).squaredNorm();
  if (distance < nearest.distance) nearest = {distance, (1 - s) * field[first] + s * field[last]};
}

}  // namespace

Eigen::VectorXd carry_along_surface(const core::Mesh& old, const Eigen::VectorXd& field, const core::Mesh& mesh) {
  Eigen::VectorXd carried = Eigen::VectorXd::Zero(mesh.node_count());
  const auto touches = core::boundaries_of_kind(old, core::BoundaryKind::contact);
  for (const core::Index node : contact_nodes(mesh)) {
    Nearest nearest;
    for (const core::BoundaryEdge& edge : old.boundary_edges()) {
      if (!touches[edge.boundary_id]) continue;
      consider(old, field, edge.nodes[0], edge.nodes[2], mesh.nodes[node], nearest);
      consider(old, field, edge.nodes[2], edge.nodes[1], mesh.nodes[node], nearest);
    }
    carried[node] = nearest.value;
  }
  return carried;
}

}  // namespace parison::forming
