#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::remesh {

/// The cells around each vertex of a mesh.
struct Fans {
  std::vector<core::Index> start, cell;  ///< of vertex v: cell[start[v]] ... cell[start[v + 1] - 1]
};
Fans fans_of(const core::Mesh& mesh);

}  // namespace parison::remesh
