#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <utility>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "core/mesh/point.hpp"

namespace parison::core {

/// Straight line or circular arc from start to end; the body lies on the left.
struct Segment {
  Point start, end;  ///< m
  bool is_arc = false;
  Point centre = Point::Zero();
  double radius = 0;        ///< m
  double from = 0, to = 0;  ///< angles of start and end, rad; to > from turns counterclockwise
  Index boundary_id = 0;    ///< index into Profile::boundaries
};

/// Closed outline of a body, counterclockwise (body on the left), exact geometry.
struct Profile {
  std::vector<Segment> segments;
  std::vector<std::string> boundary_names;
};

/// Point of a segment at t in [0, 1], uniform in arc length.
Point point_at(const Segment& segment, double t);
/// Unit tangent in the direction start to end.
Point tangent_at(const Segment& segment, double t);
/// Outward unit normal (to the right of the tangent, away from the body).
Point normal_at(const Segment& segment, double t);
/// Arc length, m.
double length(const Segment& segment);
/// Parameter t of the point of the segment closest to x, in [0, 1].
double closest_parameter(const Segment& segment, const Point& x);
/// The same without the end limits: below 0 or above 1 when x projects beyond an end.
double projected_parameter(const Segment& segment, const Point& x);
/// How far x projects beyond the segment's start (end), m; negative where it projects before.
double beyond_start(const Segment& segment, const Point& x);
double beyond_end(const Segment& segment, const Point& x);

/// Size of the body, m: the diagonal of the box around its outline.
double size(const Profile& profile);
/// Signed area of the cross-section, m2; positive when counterclockwise.
double signed_area(const Profile& profile);
/// The outline in the opposite direction.
Profile reversed(const Profile& profile);
/// Whether x lies inside the outline, by its winding number about x. Points of the outline count as inside where the
/// body lies on their right, such as those of the axis, or above them.
bool contains(const Profile& profile, const Point& x);
/// Distance from x to a segment, m, at most `known`.
double distance(const Segment& segment, const Point& x, double known);
/// Distance from x to the outline, m.
double distance(const Profile& profile, const Point& x);
/// Two segments that cross or touch, as indices, or {-1, -1} where the outline is simple.
std::pair<Index, Index> find_self_crossing(const Profile& profile);
/// Chords of the outline with at most `chord` length and `sagitta` deviation; first point of each segment included.
std::vector<Point> polyline(const Profile& profile, double chord, double sagitta);

/// Straight part of an outline. `from` and `to` name its ends; chords that meet share a name.
struct Chord {
  Point a, b;  ///< m
  Index from, to;
};

/// Two chords that cross or touch although they do not meet at an end, by exact predicates; the lowest such pair of
/// indices, or {-1, -1} where the outline is simple.
std::pair<Index, Index> find_crossing(const std::vector<Chord>& chords);

}  // namespace parison::core
