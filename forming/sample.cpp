// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/sample.hpp"

#include "core/element.hpp"
#include "remesh/cell_grid.hpp"

namespace parison::forming {

using core::Index;

Eigen::MatrixXd sample(const core::Mesh& mesh, const Eigen::VectorXd& field, Index components,
                       const std::vector<core::Point>& points) {
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(static_cast<Index>(points.size()), components);
  if (points.empty()) return values;
  const remesh::CellGrid grid(mesh);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto found = grid.find(points[p]);
    const auto shape = core::triangle_shape(found.at[0], found.at[1]);
    for (int i = 0; i < 6; ++i)
      values.row(p) += shape[i] * field.segment(components * mesh.cells[found.cell][i], components).transpose();
  }
  return values;
}

}  // namespace parison::forming
