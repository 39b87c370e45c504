#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "core/mesh/point.hpp"

namespace parison::core {

/// The vertices of a graph in an order of elimination that keeps the fill of a factorisation small. An edge may be
/// named more than once and in either direction.
///
/// By approximate minimum degree (P. Amestoy, T. Davis, I. Duff, SIAM J. Matrix Anal. Appl. 17 (1996) 886-905).
std::vector<Index> minimum_degree_order(Index size, const std::vector<std::array<Index, 2>>& edges);

/// By approximate minimum fill (P. Amestoy's AMF in MUMPS; the idea: E. Rothberg & S. Eisenstat, SIAM J. Matrix Anal.
/// Appl. 19 (1998) 682-695). Vertices with equal fill are taken by descending `layer`, one for each, such as the
/// distance from the boundary of a mesh: so the quadratic cells of glass need a fifth to a quarter less operations than
/// by minimum degree; of seven numberings that were tried this was the best. Throws RunError where memory does not
/// suffice.
std::vector<Index> minimum_fill_order(const std::vector<Index>& layer, const std::vector<std::array<Index, 2>>& edges);

/// By nested dissection (METIS: G. Karypis & V. Kumar, SIAM J. Sci. Comput. 20 (1998) 359-392), each subtree of the
/// elimination contiguous: for graphs of bodies in space. Throws RunError where memory does not suffice.
std::vector<Index> nested_dissection_order(Index size, const std::vector<std::array<Index, 2>>& edges);

}  // namespace parison::core
