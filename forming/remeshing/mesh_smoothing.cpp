// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/remeshing/mesh_smoothing.hpp"

#include "forming/step/contact/contact_geometry.hpp"

namespace parison::forming {

void smooth_displacement(const core::Mesh& from, core::Mesh& mesh) {
  constexpr int sweeps = 20;
  std::vector<bool> on_surface(mesh.nodes.size(), false);
  for (const Index node : surface_nodes(mesh)) on_surface[node] = true;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    std::vector<Point> sum(mesh.nodes.size(), Point::Zero());
    std::vector<int> count(mesh.nodes.size(), 0);
    for (const auto& cell : mesh.cells()) {
      Point mean = Point::Zero();
      for (const Index node : cell) mean += (mesh.nodes[node] - from.nodes[node]) / cell.size();
      for (const Index node : cell) sum[node] += mean, ++count[node];
    }
    for (Index n = 0; n < mesh.node_count(); ++n)
      if (!on_surface[n]) mesh.nodes[n] = from.nodes[n] + sum[n] / count[n];
  }
}

}  // namespace parison::forming
