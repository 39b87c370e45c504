#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "contact/tool_constraints.hpp"

namespace parison::contact {

/// A tool as it stands in space.
struct PlacedTool {
  const core::Profile* profile;
  std::vector<bool> contact_pieces;
  double offset;  ///< along the axis, m
};

/// Where the contact pieces of one tool end on the start of another's: the parting line of two tools.
struct ToolJoint {
  core::Index before, after;               ///< of the placed tools, in the sense of their outlines
  core::Segment segment_before, segment_after;  ///< in space
};

/// All joints of the tools, whose ends are nearer to each other than 1e-5 m.
std::vector<ToolJoint> tool_joints(const std::vector<PlacedTool>& tools);

/// A constraint of the tool at `tool`, an index into the placed tools.
struct JointConstraint {
  core::Index tool;
  GapConstraint constraint;
};

/// What a joint constrains beyond its two segments: in a hollow one each segment goes on past the joint, within `reach`; where the
/// joint sticks out of the tools its point itself keeps the glass away.
std::vector<JointConstraint> joint_constraints(const ToolJoint& joint, const core::Point& x, double reach);

}  // namespace parison::contact
