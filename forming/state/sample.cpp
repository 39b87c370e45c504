// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/state/sample.hpp"

#include <algorithm>

#include "core/mesh/cell_map.hpp"
#include "core/mesh/element.hpp"
#include "remesh/transfer/overlay.hpp"

namespace parison::forming {

using core::Index;

namespace {

/// The cell that contains a point, by a search over all cells; none when the point lies outside or on the border.
remesh::CellGrid::Found find_inside(const core::Mesh& mesh, const core::Point& x) {
  remesh::CellGrid::Found found;
  for (Index cell = 0; cell < mesh.cell_count() && found.cell < 0; ++cell) {
    const core::Box box = remesh::cell_box(mesh, cell);
    if (!box.meets({x, x})) continue;
    const auto at = core::invert_cell_map(mesh, cell, x);
    if (std::min({at[0], at[1], 1 - at[0] - at[1]}) >= 0) found = {cell, at, 0};
  }
  return found;
}

}  // namespace

double sample(const core::Mesh& mesh, const Eigen::VectorXd& field, const core::Point& point) {
  const auto found = find_inside(mesh, point);
  if (found.cell < 0) return sample(mesh, field, 1, {point})(0, 0);
  const auto shape = core::triangle_shape(found.at[0], found.at[1]);
  double value = 0;
  for (int i = 0; i < 6; ++i) value += shape[i] * field[mesh.cells()[found.cell][i]];
  return value;
}

Eigen::MatrixXd sample(const core::Mesh& mesh, const Eigen::VectorXd& field, Index components,
                       const std::vector<core::Point>& points) {
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(static_cast<Index>(points.size()), components);
  if (points.empty()) return values;
  const remesh::CellGrid grid(mesh);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto found = grid.find(points[p]);
    const auto shape = core::triangle_shape(found.at[0], found.at[1]);
    for (int i = 0; i < 6; ++i)
      values.row(p) += shape[i] * field.segment(components * mesh.cells()[found.cell][i], components).transpose();
  }
  return values;
}

}  // namespace parison::forming
