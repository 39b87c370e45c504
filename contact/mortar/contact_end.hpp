#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <vector>

#include "contact/mortar/mortar.hpp"

namespace parison::contact {

/// Where a contact ends on an edge of the slave, one of whose vertices is in contact; by parameters of the edge.
struct ContactEnd {
  double end;   ///< at the vertex in contact or beyond it
  double free;  ///< the other vertex, 0 or 1
  double gap;   ///< of that one, m
  double bend;  ///< share of that gap which grows with the square of the distance from the end; the rest is linear

  /// Gap at s, m.
  double operator()(double s) const {
    const double u = (s - end) / (free - end);
    return u > 0 ? gap * u * (1 + bend * (u - 1)) : 0;
  }
};

/// Finds where contacts end on the edges of a slave. Glass lands node by node, and a quadratic edge cannot be flat in
/// contact and bent beyond it; so the edge at the end of a contact is a chord that shows neither. But glass leaves a
/// tool without a kink: behind the end its gap grows with the square of the distance, and the root of the gap is a
/// straight line. That through the free vertex of the edge and the node behind it leads to the end. Where it leads to
/// before the vertex in contact, the contact ends there, with the parabola through the three nodes as the gap, and with
/// a straight line where that is bent towards the tool.
class ContactEndFinder {
 public:
  explicit ContactEndFinder(const Surface& slave);
  /// On an edge of the slave by its number. `master` has to say which nodes touch it.
  std::optional<ContactEnd> operator()(std::size_t edge, const Master& master) const;

 private:
  const Surface& slave_;
  std::vector<Index> starting_, ending_;  ///< edges by their first and last node, -1 for none
};

}  // namespace parison::contact
