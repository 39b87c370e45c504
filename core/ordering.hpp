#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "core/point.hpp"

namespace parison::core {

/// Order in which to eliminate the unknowns of a graph with little fill: approximate minimum degree. An edge may be named
/// more than once and in either direction.
std::vector<Index> minimum_degree_order(Index size, const std::vector<std::array<Index, 2>>& edges);

}  // namespace parison::core
