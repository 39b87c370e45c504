#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "thermal/system.hpp"

namespace parison::thermal {

/// Unknowns of the vertices of a slave edge, first and last, and of the master edge that it faces.
using Coupling = std::array<Index, 4>;

inline Coupling coupling_of(const HeatSegment& segment) {
  return {segment.unknowns[0], segment.unknowns[1], segment.unknowns[3], segment.unknowns[4]};
}

/// Couplings of the interface, ascending.
std::vector<Coupling> present_couplings(const HeatSystem& system);

/// The unknowns of all boundary edges, body after body, by their first vertex.
class EdgeChain {
 public:
  explicit EdgeChain(const HeatSystem& system);
  /// Whether the couplings are between edges of these.
  bool holds(const std::vector<Coupling>& couplings) const;
  /// Unknowns of a coupling's edges, as HeatSegment has them.
  std::array<Index, 6> unknowns(const Coupling& coupling) const;
  /// The couplings and those that would follow if the bodies slid along each other or the contact grew: edges a few
  /// further along either chain. Ascending.
  std::vector<Coupling> widen(const std::vector<Coupling>& couplings) const;

 private:
  Index edge_between(Index first, Index last) const;  ///< -1 for none
  Index along(Index edge, int steps) const;

  std::vector<std::array<Index, 3>> edges_;
  std::vector<Index> boundary_id_;  ///< counted through all bodies
  std::vector<Index> starting_at_;  ///< edge by its first unknown, -1 for none
};

}  // namespace parison::thermal
