// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/cell_grid.hpp"

#include <algorithm>
#include <cmath>

#include "core/element.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

constexpr double inside = 1e-10;  ///< slack of the reference coordinates

/// Nearest point of the reference triangle, near enough for points that are hardly outside.
std::array<double, 2> clamp_to_cell(const std::array<double, 2>& at) {
  const std::array<double, 3> share{std::max(0.0, 1 - at[0] - at[1]), std::max(0.0, at[0]), std::max(0.0, at[1])};
  const double sum = share[0] + share[1] + share[2];
  return {share[1] / sum, share[2] / sum};
}

}  // namespace

Box cell_box(const Mesh& mesh, Index cell) {
  Box box{mesh.nodes[mesh.cells[cell][0]], mesh.nodes[mesh.cells[cell][0]]};
  for (const Index node : mesh.cells[cell]) {
    box.low = box.low.cwiseMin(mesh.nodes[node]);
    box.high = box.high.cwiseMax(mesh.nodes[node]);
  }
  const Point margin = Point::Constant(0.1 * (box.high - box.low).maxCoeff());
  return {box.low - margin, box.high + margin};
}

CellGrid::CellGrid(const Mesh& mesh) : mesh_(mesh) {
  low_ = mesh.nodes[0];
  Point high = low_;
  for (const Point& x : mesh.nodes) low_ = low_.cwiseMin(x), high = high.cwiseMax(x);
  const Point extent = high - low_;
  bin_ = std::max(std::sqrt(extent.prod() / mesh.cell_count()), extent.maxCoeff() / 1000);
  for (int k = 0; k < core::dim; ++k) count_[k] = static_cast<int>(extent[k] / bin_) + 1;
  bins_.resize(static_cast<std::size_t>(count_[0]) * count_[1]);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    boxes_.push_back(cell_box(mesh, cell));
    for (int j = place(boxes_[cell].low, 1); j <= place(boxes_[cell].high, 1); ++j)
      for (int i = place(boxes_[cell].low, 0); i <= place(boxes_[cell].high, 0); ++i)
        bins_[static_cast<std::size_t>(j) * count_[0] + i].push_back(cell);
  }
}

int CellGrid::place(const Point& x, int axis) const {
  return std::clamp(static_cast<int>(std::floor((x[axis] - low_[axis]) / bin_)), 0, count_[axis] - 1);
}

CellGrid::Found CellGrid::find(const Point& x) const {
  const int column = place(x, 0), row = place(x, 1);
  Found best;
  const Box here{x, x};
  for (const Index cell : bins_[static_cast<std::size_t>(row) * count_[0] + column])
    if (boxes_[cell].meets(here) && try_cell(cell, x, best)) return best;
  for (int ring = 0; ring <= std::max(count_[0], count_[1]); ++ring) {
    for (int j = std::max(0, row - ring); j <= std::min(count_[1] - 1, row + ring); ++j)
      for (int i = std::max(0, column - ring); i <= std::min(count_[0] - 1, column + ring); ++i) {
        if (std::max(std::abs(i - column), std::abs(j - row)) < ring) continue;
        for (const Index cell : bins_[static_cast<std::size_t>(j) * count_[0] + i])
          if (try_cell(cell, x, best)) return best;
      }
    if (best.cell >= 0 && best.miss <= ring * bin_) break;
  }
  return best;
}

/// Keeps the cell when it is nearer than the best so far; true when it holds the point.
bool CellGrid::try_cell(Index cell, const Point& x, Found& best) const {
  const Box& box = boxes_[cell];
  if ((x - x.cwiseMax(box.low).cwiseMin(box.high)).norm() >= best.miss) return false;
  const auto at = core::invert_cell_map(mesh_, cell, x);
  if (!std::isfinite(at[0] + at[1])) return false;
  const auto clamped = clamp_to_cell(at);
  if (std::min({at[0], at[1], 1 - at[0] - at[1]}) > -inside) {
    best = {cell, clamped, 0};
    return true;
  }
  const auto shape = core::triangle_shape(clamped[0], clamped[1]);
  Point reached = Point::Zero();
  for (int k = 0; k < 6; ++k) reached += shape[k] * mesh_.nodes[mesh_.cells[cell][k]];
  const double miss = (reached - x).norm();
  if (miss < best.miss) best = {cell, clamped, miss};
  return false;
}

void CellGrid::near(const Box& box, std::vector<Index>& cells) const {
  cells.clear();
  for (int j = place(box.low, 1); j <= place(box.high, 1); ++j)
    for (int i = place(box.low, 0); i <= place(box.high, 0); ++i)
      for (const Index cell : bins_[static_cast<std::size_t>(j) * count_[0] + i])
        if (boxes_[cell].meets(box) && std::find(cells.begin(), cells.end(), cell) == cells.end()) cells.push_back(cell);
}

}  // namespace parison::remesh
