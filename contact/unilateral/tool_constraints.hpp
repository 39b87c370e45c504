#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "contact/box.hpp"
#include "core/mesh/profile.hpp"

namespace parison::contact {

/// Unilateral constraint of a point of the glass (A. Signorini 1933; P. Wriggers, Computational Contact Mechanics, 2nd
/// ed. 2006, chapter 4): a displacement u must satisfy gap + normal . u >= 0. Gap and normal are those of the
/// closest-point projection onto the tool's exact profile.
struct GapConstraint {
  double gap;           ///< m; negative where the point is inside the tool
  core::Point normal;   ///< unit, from the tool into the free space
  core::Index segment;  ///< index into the segments of the tool's profile
};

/// Normals of one tool with a larger cosine between them belong to a smooth part of its outline (20 degrees).
extern const double smooth_cosine;

/// The constraints that the contact boundaries of a tool put on points nearer than `reach`, m: at most core::dim,
/// smallest gap first. A segment constrains the points that project onto it. In a re-entrant corner both segments
/// constrain a point, around a convex corner the corner point does. Smoothly joined segments give one constraint. The
/// end points of the contact boundaries give none. A segment of some micrometres between two long ones, as rounded
/// coordinates leave it, counts as the joint of these: its plane says nothing about the outline a millimetre away. The
/// profile must outlive this object.
class ToolConstraints {
 public:
  ToolConstraints(const core::Profile& tool, const std::vector<bool>& contact_boundaries);
  std::vector<GapConstraint> operator()(const core::Point& x, double reach) const;
  /// Whether no point of a box is within `reach`, m, of the boxes around the segments of the contact boundaries.
  bool is_beyond(const Box& box, double reach) const;

 private:
  struct Query;
  /// A segment and its joint with the next one.
  struct BoundedSegment {
    const core::Segment* segment;
    core::Index index;  ///< in the profile
    Box bounds;
    bool in_contact;                     ///< belongs to a contact boundary
    double length;                       ///< m
    double slack;                        ///< length beyond its ends that still counts as on the segment, m
    bool reentrant_after, smooth_after;  ///< kind of the joint
    core::Point normal_after;            ///< at the joint, unit: the mean of both segments' normals
  };
  std::vector<BoundedSegment> segments_;
  Box in_contact_;     ///< contains the contact boundaries
  double coincident_;  ///< distance of points that count as one, m
};

/// Of constraints whose normals differ by less than 20 degrees keeps the one with the smallest gap, and of all those
/// the core::dim smallest. For the constraints of one tool or of several.
void merge_constraints(std::vector<GapConstraint>& constraints);

}  // namespace parison::contact
