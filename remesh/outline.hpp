#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/mesh.hpp"
#include "remesh/sizing.hpp"

namespace parison::remesh {

/// The divided boundary of a body to be meshed, body on the left: edge i starts at vertex i, ends at the next one of its
/// loop and bends through mid point i.
struct Outline {
  std::vector<core::Point> vertices, mids;  ///< m
  std::vector<core::Index> pieces;          ///< piece of each edge
  std::vector<core::Index> loop_start{0};   ///< loop k holds vertices loop_start[k] ... loop_start[k+1]-1

  core::Index edge_count() const { return static_cast<core::Index>(vertices.size()); }
};

/// Last vertex of each edge.
std::vector<core::Index> edge_ends(const Outline& outline);

/// Two edges that cross, as indices, or {-1, -1}; each edge is taken as two chords through its mid point.
std::pair<core::Index, core::Index> find_crossing(const Outline& outline);

/// A mesh, or the sentence that says why there is none.
struct MeshedOutline {
  core::Mesh mesh;
  std::string reason;
};

/// Frontal-Delaunay triangles (gmsh) inside the outline with exactly its edges. Node i is vertex i, boundary edge i is edge
/// i; an edge that would fold its cell is straightened. Not for use from several threads at once.
MeshedOutline mesh_outline(const Outline& outline, const std::vector<std::string>& pieces, const SizeField& size);

}  // namespace parison::remesh
