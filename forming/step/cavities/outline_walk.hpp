#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/step/cavities/tool_outlines.hpp"

namespace parison::forming {

/// A place where contact with the glass begins again: the walk ends there.
struct WalkTarget {
  OutlinePlace place;
  Index arc;   ///< of exposed glass surface that starts there
  Index node;  ///< of the glass
};

/// Where exposed glass surface starts at a symmetry line.
struct LineTarget {
  Point point, direction;  ///< of the line, away from the glass
  Index arc;
};

/// A straight piece of a walk, along a tool or (tool -1) across a gap or along a symmetry line.
struct WalkPiece {
  Index tool;
  Point from, to;
};

/// A walk along the outlines of tools; `arc` is that of the target which it reached, -1 where it leads to the open.
struct Walk {
  Index arc = -1;
  std::vector<WalkPiece> pieces;
};

/// What a walk may meet.
struct WalkScene {
  const ToolOutlines& outlines;
  double seal_gap;  ///< narrower gaps between tools are closed, m
  std::vector<WalkTarget> targets;
  std::vector<LineTarget> line_targets;
};

/// Walks from a place on a tool, with the tool on the left. `from_node` is the node of the glass there: the walk does
/// not end where it begins.
Walk walk_outlines(const WalkScene& scene, const OutlinePlace& from, Index from_node);

/// Walks from a point of a symmetry line in the direction of the gap.
Walk walk_line(const WalkScene& scene, const Point& from, const Point& direction);

}  // namespace parison::forming
