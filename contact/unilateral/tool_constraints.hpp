#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "contact/box.hpp"
#include "core/mesh/profile.hpp"

namespace parison::contact {

/// A half-space that a tool leaves to a point of the glass.
struct GapConstraint {
  double gap;           ///< m; negative where the point is inside the tool
  core::Point normal;   ///< unit, from the tool into the free space
  core::Index segment;  ///< of the tool's profile
};

/// The constraints (at most core::dim) that the contact boundaries of a tool put on points nearer than a reach, m,
/// smallest gap first. A segment constrains what projects on it; in a re-entrant corner both neighbours do, round a
/// sharp corner the corner itself; smoothly joined segments give one constraint; where the contact boundaries end, the
/// end point gives none. The tool outlives it.
class ToolConstraints {
 public:
  ToolConstraints(const core::Profile& tool, const std::vector<bool>& contact_boundaries);
  std::vector<GapConstraint> operator()(const core::Point& x, double reach) const;

 private:
  struct Query;
  /// A segment and the joint behind it.
  struct BoundedSegment {
    const core::Segment* segment;
    Box bounds;
    bool in_contact;
    double slack;  ///< m, beyond an end that still counts as on the segment
    bool reentrant_after, smooth_after;
    core::Point normal_after;  ///< unit, the mean of both sides
  };
  std::vector<BoundedSegment> segments_;
  Box in_contact_;  ///< that holds the boundaries in contact
};

/// Drops, of normals within 20 degrees, the larger gaps, and keeps the core::dim smallest; for one tool or the union of
/// several.
void merge_constraints(std::vector<GapConstraint>& constraints);

}  // namespace parison::contact
