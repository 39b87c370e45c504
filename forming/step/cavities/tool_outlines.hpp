#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <vector>

#include "core/mesh/point.hpp"
#include "core/mesh/profile.hpp"

namespace parison::forming {

using core::Index;
using core::Point;

/// A tool at its position, as the search for cavities sees it.
struct OutlinedTool {
  Index tool;                            ///< index into Scene::tools
  const core::Profile* profile;          ///< in the tool's frame
  std::vector<bool> contact_boundaries;  ///< one flag for each boundary of the profile
  std::vector<bool> symmetry_boundaries;
  double offset;  ///< along the axis, m
};

/// Consecutive contact boundaries of a tool as chords, the tool on their left.
struct OutlineRun {
  Index tool;
  std::vector<Point> points;  ///< m; closed runs repeat their first point
  bool closed = false;
  /// Direction in which the symmetry line leaves the run at its start and at its end, away from the tool; none where
  /// the neighbour is no symmetry line.
  std::optional<Point> open_line_before, open_line_after;

  Index chord_count() const { return static_cast<Index>(points.size()) - 1; }
};

/// A point on a run: at `t` in [0, 1] of a chord.
struct OutlinePlace {
  Index run, chord;
  double t;
};

/// The contact boundaries of tools at their positions.
struct ToolOutlines {
  std::vector<OutlineRun> runs;

  Point point(const OutlinePlace& place) const;
  /// The place of a run nearest to x, and its distance, m.
  struct Nearest {
    OutlinePlace place;
    double distance;
  };
  Nearest nearest(Index run, const Point& x) const;
};

/// `chord` and `sagitta` bound the length of the chords and their distance from the profile, m. In an axisymmetric
/// scene segments on the axis are symmetry lines whatever their boundary is called.
ToolOutlines tool_outlines(const std::vector<OutlinedTool>& tools, core::Geometry geometry, double chord,
                           double sagitta);

}  // namespace parison::forming
