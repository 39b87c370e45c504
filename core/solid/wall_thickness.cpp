// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/wall_thickness.hpp"

namespace parison::core {

Eigen::VectorXd wall_thickness(const HexMesh& mesh) {
  std::vector<Index> outward(mesh.nodes.size(), -1);  // the next node through the wall
  std::vector<char> has_inner(mesh.nodes.size(), 0);
  for (const auto& cell : mesh.cells)
    for (int n = 0; n < 18; ++n) {
      outward[cell[n]] = cell[n + 9];
      has_inner[cell[n + 9]] = 1;
    }
  Eigen::VectorXd thickness = Eigen::VectorXd::Zero(mesh.node_count());
  for (Index inner = 0; inner < mesh.node_count(); ++inner) {
    if (has_inner[inner]) continue;
    double sum = 0;
    for (Index n = inner; outward[n] >= 0; n = outward[n]) sum += (mesh.nodes[outward[n]] - mesh.nodes[n]).norm();
    for (Index n = inner; n >= 0; n = outward[n]) thickness[n] = sum;
  }
  return thickness;
}

}  // namespace parison::core
