#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/mesh/profile.hpp"

namespace parison::forming {

/// The mirror image about the line through two points of a path of points (which have only an end), lines and arcs,
/// drawn from its end to its start: it goes on where a path ends on the line.
std::vector<core::Segment> mirrored(const std::vector<core::Segment>& path, const core::Point& first,
                                    const core::Point& second);

/// Makes a segment the arc between its ends that turns by an angle, positive to the left.
void bend(core::Segment& segment, double turn);

/// A plane rational B-spline.
struct Spline {
  std::size_t degree;
  std::vector<double> knots;            ///< rising, as many as points and degree and 1 together
  std::vector<Eigen::Vector3d> points;  ///< x w, y w (m) and the weight w
};

/// Lines and arcs within `tolerance`, m, of a spline: its knots are ends of theirs, so that its corners stay corners.
/// A spline of degree 1 comes as its lines.
std::vector<core::Segment> arcs_of_spline(const Spline& spline, double tolerance);

/// A place on a plane curve and the derivative with respect to its parameter.
struct CurvePoint {
  core::Point x, derivative;
};
using PlaneCurve = std::function<CurvePoint(double)>;

/// Distance that arcs may have from a curve in a drawing of some size, m: 1 um, and less in drawings below 66 mm.
double curve_tolerance(double size);

/// Arcs and lines with a common tangent wherever two meet (biarcs: K. M. Bolton, Computer-Aided Design 7 (1975) 89-92)
/// that stay within `tolerance`, m, of a curve between two parameters.
std::vector<core::Segment> arcs_of(const PlaneCurve& curve, double from, double to, double tolerance);

/// The cubic with given ends and derivatives over the parameter from 0 to 1.
PlaneCurve cubic(const CurvePoint& start, const CurvePoint& end);

/// How a smooth curve ends: along a direction of any length other than zero, or none for that of the parabola through
/// its first (last) three points.
struct CurveEnds {
  std::optional<core::Point> start, end;
  bool closed = false;  ///< goes on from the last point to the first, as smooth there as elsewhere
};

/// The smooth curve through two or more points, of which no two neighbours are the same: cubics over the chords with
/// continuous curvature; arcs within `tolerance`.
std::vector<core::Segment> smooth_through(std::vector<core::Point> points, double tolerance,
                                          const CurveEnds& ends = {});

}  // namespace parison::forming
