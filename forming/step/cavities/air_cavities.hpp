#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "forming/step/cavities/outline_walk.hpp"

namespace parison::forming {

/// A cavity that glass and tools seal.
struct AirCavity {
  std::vector<Index> edges;       ///< exposed boundary edges of the glass
  double volume = 0;              ///< m3
  double exposed_area = 0;        ///< of those edges, m2
  std::vector<double> tool_area;  ///< change of the volume per metre of each tool along the axis, m2
};

/// What the air in a cavity sees of the glass and the tools.
struct ExposedGlass {
  const core::Mesh& mesh;
  core::Geometry geometry;
  std::vector<bool> exposed;  ///< per boundary edge: of the surface, and not in contact with all its nodes
  /// Tool in contact with each node, -1 where none is.
  const std::vector<Index>& contact_tool;
};

/// Flags of the edges that are neither symmetry planes nor fixed and have a node without contact.
std::vector<bool> exposed_edges(const core::Mesh& mesh, const std::vector<Index>& contact_tool);

/// The sealed cavities. `tool_count` is the length of AirCavity::tool_area; `seal_gap`, m, as in WalkScene.
std::vector<AirCavity> air_cavities(const ExposedGlass& glass, const ToolOutlines& outlines, Index tool_count,
                                    double seal_gap);

}  // namespace parison::forming
