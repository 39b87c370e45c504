#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "remesh/mesher/triangulate.hpp"

namespace parison::remesh {

/// A mesh, or the reason why there is none.
struct MeshedOutline {
  core::Mesh mesh;
  std::string reason;
};

/// Quadratic triangles inside the outline with exactly its edges. Node i is vertex i, boundary edge i is edge i; an
/// edge that would invert its cell is straightened. Where the body has a thermal skin its first cells are thinner.
MeshedOutline mesh_outline(const Outline& outline, const std::vector<core::MeshBoundary>& boundaries,
                           const SizeField& size, const Mesher& mesher = triangulate, bool has_skin = false);

}  // namespace parison::remesh
