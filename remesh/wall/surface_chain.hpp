#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/mesh/mesh.hpp"
#include "remesh/wall/surface_rays.hpp"

namespace parison::remesh {

/// Past the last boundary edge of the loop that begins at edge `begin`.
Index loop_end(const core::Mesh& mesh, Index begin);

/// Boundary edges between symmetry boundaries in the order of the boundary, or a whole loop of them. Its positions are
/// its nodes, counted from the first edge's start: the mid-side node of edge k is position 2k + 1.
struct SurfaceChain {
  std::vector<Index> edges;  ///< boundary edges
  bool closed;

  Index edge_count() const { return static_cast<Index>(edges.size()); }
  Index position_count() const { return 2 * edge_count() + (closed ? 0 : 1); }
  Index node(const core::Mesh& mesh, Index position) const;
};

std::vector<SurfaceChain> surface_chains(const core::Mesh& mesh, const std::vector<bool>& symmetry_boundaries);

/// A ray from one position of the surface to another where the two face each other as the sides of a wall.
struct SurfacePair {
  Index chain, position, far_chain, far_position;
  double length;   ///< of the surface around its start, m
  bool to_itself;  ///< to the mirror image of where it began
};
/// The pairs among all positions. Left out are rays with less than four fifths of their length as room around their
/// middle (they run along a wall) and those that cross their neighbours (they go through the centre of a round body).
std::vector<SurfacePair> surface_pairs(const core::Mesh& mesh, const std::vector<SurfaceChain>& chains,
                                       const std::vector<Ray>& rays);

/// First and last positions, on a chain, of its two sides; positions of a closed chain count from `start` on.
struct ChainCut {
  Index start;  ///< position, even
  Index first[2], last[2];
};
/// The cut that parts the greatest length of pairs on one chain; `found` is false where there are none.
ChainCut best_cut(const SurfaceChain& chain, const std::vector<SurfacePair>& pairs, bool& found);

}  // namespace parison::remesh
