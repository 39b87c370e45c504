#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include "contact/unilateral/tool_constraints.hpp"
#include "contact/unilateral/tool_gap.hpp"
#include "contact/unilateral/tool_junction.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

struct ToolConstraint {
  Index tool;
  contact::GapConstraint constraint;
};

/// The active tools at the offsets given (m, one for each tool of the scene), and the junctions where they meet.
struct PlacedTools {
  struct Tool {
    Index index;
    const core::Profile* profile;
    Point shift;
    contact::ToolConstraints constraints;
    contact::ToolGap gap;
  };
  std::vector<Tool> tools;
  std::vector<contact::ToolJoint> joints;
  std::vector<contact::ToolTJunction> t_junctions;
  double near;  ///< nodes farther away, m, become contact candidates only if they can move that far within the step
  double coincident;  ///< gap below which a node is in contact from the start of the step, m
  double resting;     ///< depth, m, that a node keeps
  double at_tool;     ///< gap, m, above which a node in contact is not held but comes nearer

  const Tool& of(Index index) const {
    return *std::find_if(tools.begin(), tools.end(), [&](const Tool& tool) { return tool.index == index; });
  }

  /// The constraints of one tool that a point touches at the tool's position in `state`.
  std::vector<contact::GapConstraint> touched(const State& state, Index tool, const Point& x) const;
  /// Depth of a point in a tool at its position in `state`, m; 0 outside.
  double depth_inside(const State& state, Index tool, const Point& x) const;

  PlacedTools(const Scene& scene, const std::vector<Index>& active_tools, const std::vector<double>& offset);
};

/// The tools of the present stage.
std::vector<Index> active_tools(const Scene& scene, const State& state);

/// The same at their present positions.
PlacedTools placed_tools(const Scene& scene, const State& state);

/// The constraints of a point with the smallest gaps, at most core::dim. The glass sees the union of the active tools,
/// so constraints of different tools with nearly the same normal count once.
std::vector<ToolConstraint> node_constraints(const PlacedTools& tools, const Point& x, double reach);

}  // namespace parison::forming
