#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "thermal/couplings.hpp"

namespace parison::thermal {

/// Order in which the unknowns of a heat system are eliminated: minimum degree on the graph of the vertices, each mid-side
/// node before the first vertex of its edge.
std::vector<Index> elimination_order(const HeatSystem& system, const std::vector<Coupling>& couplings);

}  // namespace parison::thermal
