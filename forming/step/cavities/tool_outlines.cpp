// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/cavities/tool_outlines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parison::forming {

namespace {

/// The segments of one tool and what they are.
struct Segments {
  const OutlinedTool& tool;
  core::Geometry geometry;

  Index count() const { return static_cast<Index>(tool.profile->segments.size()); }
  const core::Segment& at(Index i) const { return tool.profile->segments[(i + count()) % count()]; }
  bool contact(Index i) const { return tool.contact_boundaries[at(i).boundary_id]; }
  bool symmetry(Index i) const {
    const auto& segment = at(i);
    const double on_axis = 1e-9 * core::size(*tool.profile);
    if (geometry == core::Geometry::axisymmetric && std::max(segment.start[0], segment.end[0]) < on_axis) return true;
    return tool.symmetry_boundaries[segment.boundary_id];
  }
};

void add_chords(const core::Segment& segment, const Point& shift, double chord, double sagitta,
                std::vector<Point>& points) {
  double step = chord;
  if (segment.is_arc) step = std::min(step, std::sqrt(8 * segment.radius * sagitta));
  const int count = std::max(1, static_cast<int>(std::ceil(core::length(segment) / step - 1e-9)));
  for (int i = 1; i <= count; ++i) points.push_back(core::point_at(segment, double(i) / count) + shift);
}

/// The run that begins with segment `first`.
OutlineRun run_from(const Segments& segments, Index first, double chord, double sagitta) {
  const Point shift = segments.tool.offset * core::axis_direction();
  OutlineRun run{segments.tool.tool, {segments.at(first).start + shift}, false, {}, {}};
  Index last = first;
  for (;; ++last) {
    add_chords(segments.at(last), shift, chord, sagitta, run.points);
    if (!segments.contact(last + 1) || last + 1 == first + segments.count()) break;
  }
  run.closed = segments.contact(last + 1);
  if (run.closed) return run;
  // The tool's own symmetry line runs with the tool on its left; the gap goes on the other way.
  if (segments.symmetry(first - 1)) run.open_line_before = core::tangent_at(segments.at(first - 1), 1);
  if (segments.symmetry(last + 1)) run.open_line_after = -core::tangent_at(segments.at(last + 1), 0);
  return run;
}

}  // namespace

Point ToolOutlines::point(const OutlinePlace& place) const {
  const auto& points = runs[place.run].points;
  return points[place.chord] + place.t * (points[place.chord + 1] - points[place.chord]);
}

ToolOutlines::Nearest ToolOutlines::nearest(Index run, const Point& x) const {
  Nearest best{{run, 0, 0}, std::numeric_limits<double>::infinity()};
  const auto& points = runs[run].points;
  for (Index c = 0; c < runs[run].chord_count(); ++c) {
    const Point along = points[c + 1] - points[c];
    const double t = std::clamp((x - points[c]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double distance = (points[c] + t * along - x).norm();
    if (distance < best.distance) best = {{run, c, t}, distance};
  }
  return best;
}

ToolOutlines tool_outlines(const std::vector<OutlinedTool>& tools, core::Geometry geometry, double chord,
                           double sagitta) {
  ToolOutlines outlines;
  for (const auto& tool : tools) {
    const Segments segments{tool, geometry};
    bool any_end = false;
    for (Index i = 0; i < segments.count(); ++i) {
      if (!segments.contact(i) || segments.contact(i - 1)) continue;
      any_end = true;
      outlines.runs.push_back(run_from(segments, i, chord, sagitta));
    }
    if (!any_end && segments.contact(0)) outlines.runs.push_back(run_from(segments, 0, chord, sagitta));
  }
  return outlines;
}

}  // namespace parison::forming
