#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <vector>

#include "core/mesh/profile.hpp"

namespace parison::forming {

/// A place on a plane curve and the derivative with respect to its parameter.
struct CurvePoint {
  core::Point x, derivative;
};
using PlaneCurve = std::function<CurvePoint(double)>;

/// Arcs and lines with a common tangent wherever two meet (biarcs: K. M. Bolton, Computer-Aided Design 7 (1975) 89-92)
/// that stay within `tolerance`, m, of a curve between two parameters.
std::vector<core::Segment> arcs_of(const PlaneCurve& curve, double from, double to, double tolerance);

/// The cubic with given ends and derivatives over the parameter from 0 to 1.
PlaneCurve cubic(const CurvePoint& start, const CurvePoint& end);

/// The smooth curve through three or more points: cubics over the chords with continuous curvature, at the ends as the
/// parabola through three points begins; arcs within `tolerance`.
std::vector<core::Segment> smooth_through(const std::vector<core::Point>& points, double tolerance);

}  // namespace parison::forming
