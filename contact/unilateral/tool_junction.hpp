#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <vector>

#include "contact/unilateral/tool_constraints.hpp"

namespace parison::contact {

/// A tool as it stands in space.
struct PlacedTool {
  const core::Profile* profile;
  std::vector<bool> contact_boundaries;
  double offset;  ///< along the axis, m
};

/// Where the contact boundaries of one tool end on the start of another's: the parting line of two tools.
struct ToolJoint {
  core::Index before, after;                    ///< of the placed tools, in the sense of their outlines
  core::Segment segment_before, segment_after;  ///< in space
};

/// All joints of the tools, whose ends are nearer to each other than 1e-5 m.
std::vector<ToolJoint> tool_joints(const std::vector<PlacedTool>& tools);

/// A constraint of the tool at `tool`, an index into the placed tools.
struct JointConstraint {
  core::Index tool;
  GapConstraint constraint;
};

/// What a joint constrains beyond its two segments: in a hollow one each segment goes on past the joint, within
/// `reach`; where the joint sticks out of the tools its point itself keeps the glass away.
std::vector<JointConstraint> joint_constraints(const ToolJoint& joint, const core::Point& x, double reach);

/// Where the contact of one tool ends on the face of another, as a ring's wall on a plate.
struct ToolTJunction {
  core::Index tool;       ///< that ends, of the placed tools
  core::Segment segment;  ///< its last one, in space
  bool at_end;            ///< of the segment; else at its start
};
std::vector<ToolTJunction> tool_t_junctions(const std::vector<PlacedTool>& tools);

/// The segment of a foot goes on beyond it within `reach`: glass that lies a little inside the other tool does not pass
/// under it.
std::optional<JointConstraint> t_junction_constraint(const ToolTJunction& t_junction, const core::Point& x,
                                                     double reach);

}  // namespace parison::contact
