#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "forming/flow/problem.hpp"

namespace parison::flow {

/// What one boundary edge contributes to its nodes (first, last, mid).
struct SurfaceEdge {
  std::array<double, 3> area;  ///< int N_i dA, m2
  std::array<Point, 3> load;   ///< of surface tension and gas pressure, N; zero on boundaries that are not free
};

/// One for each edge of the mesh's boundary.
std::vector<SurfaceEdge> surface_edges(const Problem& problem);

/// Load of surface tension and gas pressure on the edges that are not pressed against a tool at all three nodes, N, two
/// per node.
Eigen::VectorXd surface_load(const core::Mesh& mesh, const std::vector<SurfaceEdge>& edges,
                             const std::vector<bool>& in_contact);

/// Contact area that belongs to each pressed node, m2: over the edges that are pressed at all three nodes, or over all
/// its edges where none is.
Eigen::VectorXd contact_areas(const core::Mesh& mesh, const std::vector<SurfaceEdge>& edges,
                              const std::vector<bool>& in_contact);

}  // namespace parison::flow
