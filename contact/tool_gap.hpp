#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <vector>

#include "contact/box_tree.hpp"
#include "core/profile.hpp"

namespace parison::contact {

/// A half-space that a tool leaves to a point of the glass.
struct GapConstraint {
  double gap;           ///< m; negative where the point is inside the tool
  core::Point normal;   ///< unit, from the tool into the free space
  core::Index segment;  ///< of the tool's profile
};

/// The constraints (at most core::dim) that the contact pieces of a tool put on a point nearer than `reach`, m,
/// smallest gap first. A segment constrains what projects on it; in a hollow corner both neighbours do, round a sharp
/// corner the corner itself; smoothly joined segments give one constraint; where the contact pieces end, the end point
/// gives none.
std::vector<GapConstraint> gap_constraints(const core::Profile& tool, const std::vector<bool>& contact_pieces,
                                           const core::Point& x, double reach);

/// Drops, of normals within 20 degrees, the larger gaps, and keeps the core::dim smallest; for one tool or the union of
/// several.
void merge_constraints(std::vector<GapConstraint>& constraints);

/// Distance from points to a tool's contact pieces, m, negative inside the tool; +infinity without contact pieces and where
/// they are further away than `reach`. The tool outlives it.
class ToolGap {
 public:
  ToolGap(const core::Profile& tool, const std::vector<bool>& contact_pieces, double reach);
  double operator()(const core::Point& x) const;

 private:
  struct Piece {
    Box bounds;
    const core::Segment* segment;
  };
  const core::Profile* tool_;
  double reach_;
  std::vector<Piece> pieces_;
  Box in_reach_;
};

/// The same for one point.
double signed_gap(const core::Profile& tool, const std::vector<bool>& contact_pieces, const core::Point& x,
                  double reach = std::numeric_limits<double>::infinity());

}  // namespace parison::contact
