#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Which pieces of the glass mesh the last stage with a pressure loads with it, be it 0: the inner side of the container.
std::vector<bool> loaded_pieces(const Scene& scene, const core::Mesh& glass);

/// A boundary edge with its place along a stretch of the surface.
struct ChainEdge {
  Index edge;     ///< index into Mesh::boundary
  double start;   ///< arc length from the stretch's start to its first node, m
  double length;  ///< m
};

/// The boundary edges on wanted pieces in the order of walking them, from where they begin; further parts go on counting.
std::vector<ChainEdge> walk_surface(const core::Mesh& mesh, const std::vector<bool>& wanted_pieces);

}  // namespace parison::forming
