#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "core/symmetric_matrix.hpp"

namespace parison::core {

/// The unknowns in the order of their elimination, and about how many operations a factorisation takes.
struct EliminationOrder {
  std::vector<Index> unknown;
  double operations;
};

/// Order in which to eliminate the unknowns of a graph with little fill: approximate minimum degree. An edge may be named
/// more than once and in either direction.
EliminationOrder minimum_degree_order(Index size, const std::vector<std::array<Index, 2>>& edges);

/// The same for a matrix. Unknowns with one pattern are ordered as one vertex and follow one another by their numbers.
EliminationOrder minimum_degree_order(const SymmetricMatrix& matrix);

}  // namespace parison::core
