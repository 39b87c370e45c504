#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "thermal/system.hpp"

namespace parison::thermal {

/// Coupling of a slave edge and a master edge in the matrix: unknowns of the first and last vertex of each.
using Coupling = std::array<Index, 4>;

inline Coupling coupling_of(const HeatSegment& segment) {
  return {segment.unknowns[0], segment.unknowns[1], segment.unknowns[3], segment.unknowns[4]};
}

/// Couplings of the system's interface, sorted.
std::vector<Coupling> present_couplings(const HeatSystem& system);

/// Boundary edges of all bodies, found by the unknown of their first vertex, with their neighbours along the boundary.
class EdgeChain {
 public:
  explicit EdgeChain(const HeatSystem& system);
  /// Whether all couplings are between edges of these bodies.
  bool holds(const std::vector<Coupling>& couplings) const;
  /// Unknowns of a coupling's edges, ordered as in HeatSegment.
  std::array<Index, 6> unknowns(const Coupling& coupling) const;
  /// The couplings and those that sliding or growing contact is likely to need next, between edges one further along
  /// either boundary. Sorted.
  std::vector<Coupling> widen(const std::vector<Coupling>& couplings) const;

 private:
  Index edge_between(Index first, Index last) const;  ///< -1 for none
  Index neighbour(Index edge, int steps) const;

  std::vector<std::array<Index, 3>> edges_;
  std::vector<Index> boundary_id_;  ///< by edge, counted through all bodies
  std::vector<Index> starting_at_;  ///< edge by the unknown of its first vertex, -1 for none
};

}  // namespace parison::thermal
