// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/mesher/quality.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/mesh/cell_map.hpp"

namespace parison::remesh {

using core::Index;
using core::Point;

namespace {

/// Lowers `min_quality` to the smallest quality at the six nodes of a cell.
void lower(const core::Mesh& mesh, Index cell, double& min_quality) {
  const auto& [origin, u, v, mid_side_offset] = core::cell_map(mesh, cell);
  const auto& [m, n, p] = mid_side_offset;
  // Both columns of the Jacobian are linear over the cell, so mid-side values are the means of the vertex values.
  std::array<core::Point, 6> along_a{u + 4 * m, u - 4 * m, u + 4 * (n - p)},
      along_b{v + 4 * p, v + 4 * (n - m), v - 4 * p};
  for (int k = 0; k < 3; ++k) {
    along_a[3 + k] = 0.5 * (along_a[k] + along_a[(k + 1) % 3]);
    along_b[3 + k] = 0.5 * (along_b[k] + along_b[(k + 1) % 3]);
  }
  const double root = std::sqrt(3.0);
  for (int k = 0; k < 6; ++k) {
    const core::Point &da = along_a[k], &db = along_b[k];
    const double sides = da.squaredNorm() + db.squaredNorm() - da.dot(db),
                 area = root * (da[0] * db[1] - da[1] * db[0]);
    if (!(area >= min_quality * sides) || sides <= 0)
      min_quality = std::min(min_quality, sides > 0 ? area / sides : 0.0);
  }
}

}  // namespace

double cell_quality(const core::Mesh& mesh, Index cell) {
  double min_quality = 1;
  lower(mesh, cell, min_quality);
  return min_quality;
}

double min_quality(const core::Mesh& mesh) {
  double min_quality = 1;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) lower(mesh, cell, min_quality);
  return min_quality;
}

Quality quality(const core::Mesh& mesh) {
  Quality result{1, 1, 0, -1};
  std::vector<double> all(mesh.cell_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    all[cell] = cell_quality(mesh, cell);
    result.mean += all[cell] / mesh.cell_count();
    if (result.min_quality_cell < 0 || all[cell] < result.min) {
      result.min = all[cell];
      result.min_quality_cell = cell;
    }
  }
  if (all.empty()) return result;
  std::nth_element(all.begin(), all.begin() + all.size() / 2, all.end());
  result.median = all[all.size() / 2];
  return result;
}

}  // namespace parison::remesh
