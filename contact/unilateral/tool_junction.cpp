// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/unilateral/tool_junction.hpp"

#include <algorithm>

#include "core/mesh/tolerances.hpp"

namespace parison::contact {

using core::Index;
using core::Point;
using core::Segment;

namespace {

Segment shifted(Segment segment, double offset) {
  const Point shift = offset * core::axis_direction();
  segment.start += shift;
  segment.end += shift;
  segment.centre += shift;
  return segment;
}

/// The segments at which the contact boundaries of a tool end (`last`) or begin, at the tool's position.
std::vector<Segment> end_segments(const PlacedTool& tool, bool last) {
  const auto& segments = tool.profile->segments;
  const std::size_t count = segments.size();
  std::vector<Segment> found;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t neighbour = last ? (i + 1) % count : (i + count - 1) % count;
    if (tool.contact_boundaries[segments[i].boundary_id] && !tool.contact_boundaries[segments[neighbour].boundary_id])
      found.push_back(shifted(segments[i], tool.offset));
  }
  return found;
}

/// Whether a point lies on a contact boundary of a tool, away from the ends of its segments.
bool lies_on(const PlacedTool& tool, const Point& x) {
  const Point local = x - tool.offset * core::axis_direction();
  const auto& segments = tool.profile->segments;
  const double joined = core::tolerance::junction * core::size(*tool.profile);
  return std::any_of(segments.begin(), segments.end(), [&](const Segment& segment) {
    return tool.contact_boundaries[segment.boundary_id] && core::distance(segment, local, 2 * joined) < joined &&
           core::beyond_start(segment, local) < -joined && core::beyond_end(segment, local) < -joined;
  });
}

}  // namespace

std::vector<ToolJoint> tool_joints(const std::vector<PlacedTool>& tools) {
  std::vector<ToolJoint> joints;
  for (std::size_t a = 0; a < tools.size(); ++a)
    for (std::size_t b = 0; b < tools.size(); ++b) {
      if (a == b) continue;
      const double joined = core::tolerance::junction * core::size(*tools[a].profile);
      for (const Segment& before : end_segments(tools[a], true))
        for (const Segment& after : end_segments(tools[b], false))
          if ((before.end - after.start).norm() < joined) joints.push_back({Index(a), Index(b), before, after});
    }
  return joints;
}

std::vector<JointConstraint> joint_constraints(const ToolJoint& joint, const Point& x, double reach) {
  const Segment &before = joint.segment_before, &after = joint.segment_after;
  const Point arm_before = x - before.end, arm_after = x - after.start;
  if (arm_before.squaredNorm() > reach * reach) return {};
  const Point in = core::tangent_at(before, 1), out = core::tangent_at(after, 0);
  const double past = core::beyond_end(before, x), ahead = core::beyond_start(after, x);
  std::vector<JointConstraint> found;
  if (in[0] * out[1] - in[1] * out[0] < 0) {
    const Point normal_before = core::normal_at(before, 1), normal_after = core::normal_at(after, 0);
    if (past > 0 && core::beyond_end(after, x) <= 0)
      found.push_back({joint.before, {arm_before.dot(normal_before), normal_before, -1}});
    if (ahead > 0 && core::beyond_start(before, x) <= 0)
      found.push_back({joint.after, {arm_after.dot(normal_after), normal_after, -1}});
  } else if (past > 0 && ahead > 0 && arm_before.norm() > 0) {
    found.push_back({joint.after, {arm_before.norm(), arm_before.normalized(), -1}});
  }
  return found;
}

std::vector<ToolTJunction> tool_t_junctions(const std::vector<PlacedTool>& tools) {
  std::vector<ToolTJunction> t_junctions;
  for (std::size_t a = 0; a < tools.size(); ++a)
    for (const bool at_end : {false, true})
      for (const Segment& segment : end_segments(tools[a], at_end)) {
        const Point end = at_end ? segment.end : segment.start;
        for (std::size_t b = 0; b < tools.size(); ++b)
          if (a != b && lies_on(tools[b], end)) t_junctions.push_back({Index(a), segment, at_end});
      }
  return t_junctions;
}

std::optional<JointConstraint> t_junction_constraint(const ToolTJunction& t_junction, const Point& x, double reach) {
  const Segment& segment = t_junction.segment;
  const Point arm = x - (t_junction.at_end ? segment.end : segment.start);
  if (arm.squaredNorm() > reach * reach) return std::nullopt;
  if (!((t_junction.at_end ? core::beyond_end(segment, x) : core::beyond_start(segment, x)) > 0)) return std::nullopt;
  const Point normal = core::normal_at(segment, t_junction.at_end ? 1 : 0);
  return JointConstraint{t_junction.tool, {arm.dot(normal), normal, -1}};
}

}  // namespace parison::contact
