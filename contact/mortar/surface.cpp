// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/mortar/surface.hpp"

namespace parison::contact {

Surface make_surface(Index body, const core::Mesh& mesh, const std::vector<bool>& boundaries_in_contact,
                     const Point& displacement) {
  Surface surface{body, {}};
  surface.edges.reserve(mesh.boundary_edges().size());
  for (const auto& edge : mesh.boundary_edges()) {
    if (!boundaries_in_contact[edge.boundary_id]) continue;
    surface.edges.push_back({edge.nodes, {}});
    for (int i = 0; i < 3; ++i) surface.edges.back().x[i] = mesh.nodes[edge.nodes[i]] + displacement;
  }
  return surface;
}

}  // namespace parison::contact
