#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <vector>

#include "contact/unilateral/tool_constraints.hpp"

namespace parison::contact {

/// A tool at its position.
struct PlacedTool {
  const core::Profile* profile;
  std::vector<bool> contact_boundaries;  ///< one flag for each boundary of the profile
  double offset;                         ///< along the axis, m
};

/// Point at which the contact boundaries of one tool end and those of another begin: the parting line of two tools.
struct ToolJoint {
  core::Index before, after;                    ///< indices of the tools, in the direction of their outlines
  core::Segment segment_before, segment_after;  ///< at the tools' positions
};

/// All joints of the tools: ends that are less than 1e-5 m apart.
std::vector<ToolJoint> tool_joints(const std::vector<PlacedTool>& tools);

/// A constraint with the tool it belongs to.
struct JointConstraint {
  core::Index tool;  ///< index into the placed tools
  GapConstraint constraint;
};

/// Constraints of a joint for points within `reach`, m, of it. At a re-entrant joint each segment is extended past the
/// joint, as far as the other one reaches: beyond its far end the wall may turn away. At a convex joint the joint
/// itself is the closest point of those that project onto neither segment.
std::vector<JointConstraint> joint_constraints(const ToolJoint& joint, const core::Point& x, double reach);

/// T-junction of two tools: the contact boundaries of one end on a contact boundary of the other, as the wall of a ring
/// does on a plate.
struct ToolTJunction {
  core::Index tool;       ///< the tool that ends there, an index into the placed tools
  core::Segment segment;  ///< its last segment, at the tool's position
  bool at_end;            ///< the junction is at the segment's end, otherwise at its start
};
std::vector<ToolTJunction> tool_t_junctions(const std::vector<PlacedTool>& tools);

/// The ending segment is extended past the junction, within `reach`, m. Without that, glass that penetrates the other
/// tool a little could pass beneath the ending one.
std::optional<JointConstraint> t_junction_constraint(const ToolTJunction& t_junction, const core::Point& x,
                                                     double reach);

}  // namespace parison::contact
