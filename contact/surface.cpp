// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/surface.hpp"

#include "core/element.hpp"

namespace parison::contact {

namespace {

Point combine(const SurfaceEdge& edge, const std::array<double, 3>& factor) {
  return factor[0] * edge.x[0] + factor[1] * edge.x[1] + factor[2] * edge.x[2];
}

}  // namespace

Surface make_surface(Index body, const core::Mesh& mesh, const std::vector<bool>& pieces_in_contact,
                     const Point& displacement) {
  Surface surface{body, {}};
  for (const auto& edge : mesh.boundary) {
    if (!pieces_in_contact[edge.piece]) continue;
    surface.edges.push_back({edge.nodes, {}});
    for (int i = 0; i < 3; ++i) surface.edges.back().x[i] = mesh.nodes[edge.nodes[i]] + displacement;
  }
  return surface;
}

Point position(const SurfaceEdge& edge, double s) {
  return s == 0 ? edge.x[0] : s == 1 ? edge.x[1] : combine(edge, core::edge_shape(s));
}

Point slope(const SurfaceEdge& edge, double s) {
  return combine(edge, core::edge_shape_derivative(s));
}

Point normal(const SurfaceEdge& edge, double s) {
  const Point along = slope(edge, s).normalized();
  return {along[1], -along[0]};
}

}  // namespace parison::contact
