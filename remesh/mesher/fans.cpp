// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/mesher/fans.hpp"

#include <numeric>

namespace parison::remesh {

using core::Index;

Fans fans_of(const core::Mesh& mesh) {
  Fans fans{std::vector<Index>(mesh.vertex_count() + 1, 0), std::vector<Index>(3 * mesh.cells().size())};
  for (const auto& cell : mesh.cells())
    for (int i = 0; i < 3; ++i) ++fans.start[cell[i] + 1];
  std::partial_sum(fans.start.begin(), fans.start.end(), fans.start.begin());
  std::vector<Index> place(fans.start.begin(), fans.start.end() - 1);
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int i = 0; i < 3; ++i) fans.cell[place[mesh.cells()[c][i]]++] = c;
  return fans;
}

}  // namespace parison::remesh
