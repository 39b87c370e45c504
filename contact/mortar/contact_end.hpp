#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <optional>
#include <vector>

#include "contact/mortar/mortar.hpp"

namespace parison::contact {

/// Where a contact ends on an edge of the slave, one of whose vertices is in contact; by parameters of the edge.
struct ContactEnd {
  double end;    ///< at the vertex in contact or beyond it
  double free;   ///< the other vertex, 0 or 1
  double gap;    ///< of that one, m
  double power;  ///< of the distance from the end with which the gap grows

  /// Gap at s, m.
  double operator()(double s) const {
    const double u = (s - end) / (free - end);
    return u > 0 ? gap * std::pow(u, power) : 0;
  }
};

/// Finds where contacts end on the edges of a slave. Glass lands node by node, and a quadratic edge cannot be flat in
/// contact and bent beyond it; so the edge at the end of a contact is a chord that shows neither. But glass leaves a
/// tool without a kink. Near the end of a thick body's contact the gap grows with the distance to the power 3/2, as
/// that of two bodies by Hertz does (K. L. Johnson, Contact Mechanics, 1985), and far from it or for a shell with its
/// square, as any smooth curve leaves its tangent. The power between these with which the three nodes behind the edge's
/// free vertex stand on one curve leads to the end. Where it leads to before the vertex in contact, the contact ends
/// there, and the power is that of the curve through there and the first two of the nodes; a gap that opens with a kink
/// remains the chord's.
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
