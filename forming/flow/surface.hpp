#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "forming/flow/problem.hpp"

namespace parison::flow {

/// Contributions of one boundary edge to its nodes (first, last, mid).
struct SurfaceEdge {
  std::array<double, 3> area;  ///< int N_i dA, m2
  std::array<Point, 3> load;   ///< surface tension and gas pressure, N; zero on boundaries that are not free
};

/// Areas and loads of all boundary edges. Surface tension is the weak form of the Laplace-Beltrami operator, - int
/// gamma grad_s . w dA for a test velocity w, which needs no curvature (K. Ruschak, 1980, Int. J. Numer. Methods Eng.
/// 15, 639-648; E. Baensch, 2001, Numer. Math. 88, 203-235); gas pressure is - int p n.w dA.
std::vector<SurfaceEdge> surface_edges(const Problem& problem);

bool wholly_in_contact(const core::BoundaryEdge& edge, const std::vector<bool>& in_contact);

/// Load of surface tension and gas pressure, N, two per node, over the edges with at least one node out of contact.
Eigen::VectorXd surface_load(const core::Mesh& mesh, const std::vector<SurfaceEdge>& edges,
                             const std::vector<bool>& in_contact);

/// Contact area of each node in contact, m2: the integral of its shape function over the edges with all three nodes in
/// contact, or over all its edges where there is none.
Eigen::VectorXd contact_areas(const core::Mesh& mesh, const std::vector<SurfaceEdge>& edges,
                              const std::vector<bool>& in_contact);

}  // namespace parison::flow
