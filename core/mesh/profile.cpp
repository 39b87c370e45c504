// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/profile.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/uniform_grid.hpp"

namespace parison::core {

namespace {

Point on_circle(const Segment& arc, double angle) {
  return arc.centre + arc.radius * Point(std::cos(angle), std::sin(angle));
}

std::vector<Point> chords_of(const Segment& segment, double chord, double sagitta) {
  double step = chord;
  if (segment.is_arc) step = std::min(step, std::sqrt(8 * segment.radius * sagitta));
  const int count = std::max(1, static_cast<int>(std::ceil(length(segment) / step - 1e-9)));
  std::vector<Point> points;
  points.reserve(count);
  for (int i = 0; i < count; ++i) points.push_back(point_at(segment, double(i) / count));
  return points;
}

}  // namespace

Point point_at(const Segment& segment, double t) {
  if (t == 0) return segment.start;
  if (t == 1) return segment.end;
  if (segment.is_arc) return on_circle(segment, segment.from + t * (segment.to - segment.from));
  return segment.start + t * (segment.end - segment.start);
}

Point tangent_at(const Segment& segment, double t) {
  if (!segment.is_arc) return (segment.end - segment.start).normalized();
  const double angle = segment.from + t * (segment.to - segment.from);
  const double sense = segment.to > segment.from ? 1 : -1;
  return sense * Point(-std::sin(angle), std::cos(angle));
}

Point normal_at(const Segment& segment, double t) {
  const Point tangent = tangent_at(segment, t);
  return {tangent[1], -tangent[0]};
}

double length(const Segment& segment) {
  return segment.is_arc ? segment.radius * std::abs(segment.to - segment.from) : (segment.end - segment.start).norm();
}

double projected_parameter(const Segment& segment, const Point& x) {
  if (!segment.is_arc) {
    const Point along = segment.end - segment.start;
    return (x - segment.start).dot(along) / along.squaredNorm();
  }
  const Point arm = x - segment.centre;
  const double middle = 0.5 * (segment.from + segment.to);
  // Angle counted from the arc's middle, so that the cut lies opposite to it.
  const double angle = middle + std::remainder(std::atan2(arm[1], arm[0]) - middle, 2 * M_PI);
  return (angle - segment.from) / (segment.to - segment.from);
}

double closest_parameter(const Segment& segment, const Point& x) {
  const double t = projected_parameter(segment, x);
  if (t >= 0 && t <= 1) return t;
  return (x - segment.start).squaredNorm() <= (x - segment.end).squaredNorm() ? 0.0 : 1.0;
}

double beyond_start(const Segment& segment, const Point& x) {
  return -projected_parameter(segment, x) * length(segment);
}

double beyond_end(const Segment& segment, const Point& x) {
  return (projected_parameter(segment, x) - 1) * length(segment);
}

double size(const Profile& profile) {
  std::vector<Point> points;
  for (const Segment& segment : profile.segments)
    for (const double t : {0.0, 0.5}) points.push_back(point_at(segment, t));
  const auto box = bounding_box(points);
  return (box.high - box.low).norm();
}

double signed_area(const Profile& profile) {
  double sum = 0;
  for (const auto& segment : profile.segments) {
    sum += 0.5 * cross(segment.start, segment.end);
    const double turn = segment.to - segment.from;
    if (segment.is_arc) sum += 0.5 * segment.radius * segment.radius * (turn - std::sin(turn));
  }
  return sum;
}

Profile reversed(const Profile& profile) {
  Profile result = profile;
  std::reverse(result.segments.begin(), result.segments.end());
  for (auto& segment : result.segments) {
    std::swap(segment.start, segment.end);
    std::swap(segment.from, segment.to);
  }
  return result;
}

namespace {

/// Whether x lies on the left of a chord from a to b. A point on it counts as inside where the body lies on its right,
/// so on the axis, or above it.
bool is_left(const Point& a, const Point& b, const Point& x) {
  const double side = cross(b - a, x - a);
  if (side != 0) return side > 0;
  return b[1] < a[1] || (a[1] == b[1] && a[0] < b[0]);
}

/// Contribution of a segment to the winding number of an outline about x: its chord counts where it crosses the ray
/// from x to the right, and an arc also where x lies between it and its chord.
int winding(const Segment& segment, const Point& x) {
  const Point &a = segment.start, &b = segment.end;
  const bool rises = a[1] <= x[1] && x[1] < b[1], falls = b[1] <= x[1] && x[1] < a[1];
  const bool in_circle = segment.is_arc && (x - segment.centre).squaredNorm() < segment.radius * segment.radius;
  if (!rises && !falls && !in_circle) return 0;
  const bool left = is_left(a, b, x);
  const int chord = rises && left ? 1 : falls && !left ? -1 : 0;
  const bool turns_left = segment.to > segment.from;  // then the arc lies on the right of its chord
  return chord + (in_circle && turns_left != left ? (turns_left ? 1 : -1) : 0);
}

}  // namespace

bool contains(const Profile& profile, const Point& x) {
  int turns = 0;
  for (const auto& segment : profile.segments) turns += winding(segment, x);
  return turns > 0;
}

namespace {

/// Whether a point, seen from the centre, lies between the ends of an arc of less than half a turn.
bool faces_minor_arc(const Segment& arc, const Point& arm) {
  const double turn = arc.to - arc.from, side = turn > 0 ? 1 : -1;
  return std::abs(turn) < M_PI && side * cross(arc.start - arc.centre, arm) >= 0 &&
         side * cross(arm, arc.end - arc.centre) >= 0;
}

}  // namespace

double distance(const Segment& segment, const Point& x, double known) {
  if (segment.is_arc) {
    const Point arm = x - segment.centre;
    const double off = std::abs(arm.norm() - segment.radius);
    if (off >= known || faces_minor_arc(segment, arm)) return std::min(known, off);
  }
  return std::min(known, (x - point_at(segment, closest_parameter(segment, x))).norm());
}

double distance(const Profile& profile, const Point& x) {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& segment : profile.segments) best = distance(segment, x, best);
  return best;
}

std::pair<Index, Index> find_self_crossing(const Profile& profile) {
  std::vector<Point> points;
  std::vector<Index> segment_of;
  double size = 0;
  for (const auto& segment : profile.segments) size += length(segment);
  for (Index s = 0; s < static_cast<Index>(profile.segments.size()); ++s)
    for (const auto& x : chords_of(profile.segments[s], size, 1e-4 * size)) {
      points.push_back(x);
      segment_of.push_back(s);
    }
  std::vector<Chord> chords;
  const auto count = static_cast<Index>(points.size());
  chords.reserve(points.size());
  for (Index i = 0; i < count; ++i) chords.push_back({points[i], points[(i + 1) % count], i, (i + 1) % count});
  const auto [first, second] = find_crossing(chords);
  return first < 0 ? std::pair<Index, Index>{-1, -1} : std::pair{segment_of[first], segment_of[second]};
}

std::vector<Point> polyline(const Profile& profile, double chord, double sagitta) {
  std::vector<Point> points;
  for (const auto& segment : profile.segments)
    for (const auto& x : chords_of(segment, chord, sagitta)) points.push_back(x);
  return points;
}

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using ChordBox = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const Chord*>;

Kernel::Segment_2 segment(const Chord& chord) {
  return {Kernel::Point_2(chord.a[0], chord.a[1]), Kernel::Point_2(chord.b[0], chord.b[1])};
}

bool meet(const Chord& p, const Chord& q) {
  return p.from == q.from || p.from == q.to || p.to == q.from || p.to == q.to;
}

}  // namespace

std::pair<Index, Index> find_crossing(const std::vector<Chord>& chords) {
  std::vector<ChordBox> boxes;
  boxes.reserve(chords.size());
  for (const auto& chord : chords) boxes.emplace_back(segment(chord).bbox(), &chord);
  constexpr Index none = std::numeric_limits<Index>::max();
  std::pair<Index, Index> lowest{none, none};
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const ChordBox& one, const ChordBox& other) {
    const Chord &p = *one.handle(), &q = *other.handle();
    if (meet(p, q) || !CGAL::do_intersect(segment(p), segment(q))) return;
    lowest =
        std::min(lowest, std::pair<Index, Index>(std::minmax(Index(&p - chords.data()), Index(&q - chords.data()))));
  });
  return lowest.first == none ? std::pair<Index, Index>{-1, -1} : lowest;
}

}  // namespace parison::core
