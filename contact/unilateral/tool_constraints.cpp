// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/unilateral/tool_constraints.hpp"

#include <algorithm>
#include <cmath>

#include "core/mesh/tolerances.hpp"

namespace parison::contact {

using core::Index;
using core::Point;
using core::Segment;

namespace {

constexpr double smooth_angle = M_PI / 9;  ///< 20 degrees: joints that turn less are smooth, closer normals are one
constexpr double end_tolerance = 1e-9;     ///< slack at a segment's ends, in its lengths
/// A constrained point is at most this many reaches away from a segment's bounding box: one next to it, one past its
/// end.
constexpr double max_off = 2;

/// Angle by which the outline turns from a segment to the next, rad; positive at a convex corner of the tool.
double turn_between(const Segment& before, const Segment& after) {
  const Point in = core::tangent_at(before, 1), out = core::tangent_at(after, 0);
  return std::atan2(core::cross(in, out), in.dot(out));
}

/// The segments of an outline without those that are shorter than a joint and much shorter than both neighbours.
std::vector<Index> without_slivers(const core::Profile& outline) {
  constexpr double much = 0.1;
  const double joint = core::tolerance::junction * core::size(outline);
  const auto count = static_cast<Index>(outline.segments.size());
  std::vector<Index> kept;
  for (Index i = 0; i < count; ++i) {
    const double length = core::length(outline.segments[i]);
    const double before = core::length(outline.segments[i > 0 ? i - 1 : count - 1]);
    const double after = core::length(outline.segments[i + 1 < count ? i + 1 : 0]);
    if (length > joint || length > much * std::min(before, after)) kept.push_back(i);
  }
  return kept;
}

/// Whether the open straight line between a and b crosses a segment.
bool crosses(const Segment& segment, const Point& a, const Point& b) {
  constexpr double margin = 1e-6;
  const auto inside = [&](double u) { return u > margin && u < 1 - margin; };
  const Point path = b - a;
  if (!segment.is_arc) {
    const Point along = segment.end - segment.start, offset = segment.start - a;
    const double determinant = core::cross(path, along);
    if (determinant == 0) return false;
    const double t = core::cross(offset, path) / determinant;
    return inside(core::cross(offset, along) / determinant) && t >= 0 && t <= 1;
  }
  const Point arm = a - segment.centre;
  const double half = arm.dot(path) / path.squaredNorm();
  const double root = half * half - (arm.squaredNorm() - segment.radius * segment.radius) / path.squaredNorm();
  if (!(root > 0)) return false;
  for (const double u : {-half - std::sqrt(root), -half + std::sqrt(root)}) {
    const double t = core::projected_parameter(segment, a + u * path);
    if (inside(u) && t >= 0 && t <= 1) return true;
  }
  return false;
}

/// Whether a point is certainly farther than `reach` from the straight line or circle that a segment is a part of.
bool is_off_curve(const Segment& segment, const Point& x, double reach) {
  constexpr double rounding = 1e-6;  // of the reach, more than the gap of a constraint is off by
  const double far = (1 + rounding) * reach;
  if (segment.is_arc) return std::abs((x - segment.centre).norm() - segment.radius) > far;
  const Point along = segment.end - segment.start;
  const double area = core::cross(along, x - segment.start);
  return area * area > far * far * along.squaredNorm();
}

}  // namespace

const double smooth_cosine = std::cos(smooth_angle);

/// The search for the constraints of one point.
struct ToolConstraints::Query {
  const std::vector<BoundedSegment>& segments;
  const Point& x;
  double reach;
  double coincident;  ///< m

  Index count() const { return static_cast<Index>(segments.size()); }
  const Segment& segment(Index i) const { return *segments[i].segment; }
  Index next(Index i) const { return i + 1 < count() ? i + 1 : 0; }
  Index previous(Index i) const { return i > 0 ? i - 1 : count() - 1; }
  bool joined(Index i, Index j) const { return next(i) == j || next(j) == i; }
  bool ends_in_reentrant_tip(Index i, bool at_end) const;
  bool joined_at_reentrant_corner(Index i, Index j) const {
    return (next(i) == j && segments[i].reentrant_after) || (next(j) == i && segments[j].reentrant_after);
  }
  double beyond_start(Index i, double t) const { return -t * segments[i].length; }
  double beyond_end(Index i, double t) const { return (t - 1) * segments[i].length; }
  bool projects_on(Index i, double t) const;
  double distance(Index i) const;
  bool hidden(Index i, const Point& closest_point) const;
  void add_segment(Index i, std::vector<GapConstraint>& found) const;
  void add_joint(Index i, std::vector<GapConstraint>& found) const;
  void add_tip(Index i, std::vector<GapConstraint>& found) const;
  void keep_closest_exterior(std::vector<GapConstraint>& found) const;
};

/// Whether segment i ends, or begins, on the axis as a hollow cone does: with its mirror image beyond the axis it is a
/// re-entrant corner.
bool ToolConstraints::Query::ends_in_reentrant_tip(Index i, bool at_end) const {
  const BoundedSegment& beside = segments[at_end ? next(i) : previous(i)];
  if (beside.in_contact) return false;
  return std::abs(beside.segment->start[0]) <= coincident && std::abs(beside.segment->end[0]) <= coincident &&
         core::normal_at(segment(i), at_end ? 1 : 0)[0] < 0;
}

/// Whether x, whose projection has the parameter t, projects onto segment i. Beyond an end at a re-entrant corner, as
/// far as `reach`, it also does, as long as it is not beyond the far end of the neighbouring segment there; beyond a
/// re-entrant tip on the axis always.
bool ToolConstraints::Query::projects_on(Index i, double t) const {
  const double slack = segments[i].slack, before = beyond_start(i, t), past = beyond_end(i, t);
  if (before <= slack && past <= slack) return true;
  if (past > slack) {
    if (past <= reach && ends_in_reentrant_tip(i, true)) return true;
    const Index j = next(i);
    return past <= reach && segments[j].in_contact && segments[i].reentrant_after &&
           core::beyond_end(segment(j), x) <= 0 && core::beyond_start(segment(j), x) <= reach;
  }
  if (before <= reach && ends_in_reentrant_tip(i, false)) return true;
  const Index j = previous(i);
  return before <= reach && segments[j].in_contact && segments[j].reentrant_after &&
         core::beyond_start(segment(j), x) <= 0 && core::beyond_end(segment(j), x) <= reach;
}

/// Whether another part of the outline lies between x and its closest point on segment i.
bool ToolConstraints::Query::hidden(Index i, const Point& closest_point) const {
  const Box path{x.cwiseMin(closest_point), x.cwiseMax(closest_point)};
  for (Index j = 0; j < count(); ++j)
    if (j != i && overlap(path, segments[j].bounds) && !joined_at_reentrant_corner(i, j) &&
        crosses(segment(j), x, closest_point))
      return true;
  return false;
}

void ToolConstraints::Query::add_segment(Index i, std::vector<GapConstraint>& found) const {
  if (!segments[i].in_contact || is_off_curve(segment(i), x, reach)) return;
  const double t = core::projected_parameter(segment(i), x);
  if (!projects_on(i, t)) return;
  const Point closest_point = core::point_at(segment(i), t), normal = core::normal_at(segment(i), t);
  const double gap = (x - closest_point).dot(normal);
  if (std::abs(gap) <= reach && !hidden(i, closest_point)) found.push_back({gap, normal, segments[i].index});
}

/// Adds the constraint of the joint after segment i to a point that projects onto neither segment.
void ToolConstraints::Query::add_joint(Index i, std::vector<GapConstraint>& found) const {
  const BoundedSegment &before = segments[i], &after = segments[next(i)];
  if (!before.in_contact || !after.in_contact || before.reentrant_after) return;
  const Point joint = before.segment->end, arm = x - joint;
  if (arm.squaredNorm() > reach * reach) return;
  if (core::beyond_end(*before.segment, x) <= before.slack || core::beyond_start(*after.segment, x) <= after.slack)
    return;
  const double distance = arm.norm(), side = arm.dot(before.normal_after) < 0 ? -1 : 1;
  if ((side < 0 && !before.smooth_after) || hidden(i, joint)) return;
  found.push_back({side * distance, distance > 1e-3 * coincident ? Point(side / distance * arm) : before.normal_after,
                   before.index});
}

/// Adds the constraint of a tip on the axis, at the joint after segment i, to a point that does not project onto its
/// face: beyond the axis lies the face's mirror image.
void ToolConstraints::Query::add_tip(Index i, std::vector<GapConstraint>& found) const {
  const BoundedSegment &before = segments[i], &after = segments[next(i)];
  if (before.in_contact == after.in_contact) return;
  const bool ends = before.in_contact;  // the face, which comes to the axis or leaves it
  const BoundedSegment& face = ends ? before : after;
  const Point tip = before.segment->end, along = ends ? after.segment->end : before.segment->start;
  if (std::abs(tip[0]) > coincident || std::abs(along[0]) > coincident) return;
  const Point normal = core::normal_at(*face.segment, ends ? 1 : 0), arm = x - tip;
  if (normal[0] <= 0 || arm.squaredNorm() > reach * reach) return;
  if ((ends ? core::beyond_end(*face.segment, x) : core::beyond_start(*face.segment, x)) <= face.slack) return;
  const Point axial(0, normal[1] < 0 ? -1 : 1);
  if (arm.dot(axial) <= 0 || hidden(ends ? i : next(i), tip)) return;
  const double distance = arm.norm();
  found.push_back({distance, distance > 1e-3 * coincident ? Point(arm / distance) : axial, face.index});
}

/// Distance of x from segment i itself, m: a segment that is extended past a re-entrant corner can have a small gap far
/// from it.
double ToolConstraints::Query::distance(Index i) const {
  const double t = std::clamp(core::projected_parameter(segment(i), x), 0.0, 1.0);
  return (x - core::point_at(segment(i), t)).norm();
}

/// A point inside the tool is projected to the closest point of the outline: of the segments with negative gaps only
/// the nearest one is kept, and its neighbour at a re-entrant corner. At a convex corner one of the two segments is
/// kept. None is where the point lies nearer to a segment that it does not project onto, past the end of the contact
/// boundaries: what it is behind is on the other side of the tool.
void ToolConstraints::Query::keep_closest_exterior(std::vector<GapConstraint>& found) const {
  const auto is_outside = [&](const GapConstraint& c) { return c.gap >= coincident; };
  if (std::all_of(found.begin(), found.end(), is_outside)) return;
  const auto place = [&](const GapConstraint& c) {
    Index i = 0;
    while (segments[i].index != c.segment) ++i;
    return i;
  };
  Index nearest = place(*std::min_element(found.begin(), found.end(), [&](const auto& a, const auto& b) {
    return distance(place(a)) < distance(place(b));
  }));
  double least = distance(nearest) - coincident;
  for (Index i = 0; i < count(); ++i) {
    if (!segments[i].in_contact || !is_near(x, segments[i].bounds, least)) continue;
    if (const double here = distance(i); here < least) nearest = i, least = here;
  }
  const auto needless = [&](const GapConstraint& c) {
    const Index i = place(c);
    if (i == nearest || joined_at_reentrant_corner(i, nearest)) return false;
    return c.gap < (joined(i, nearest) ? coincident : 0.0);
  };
  found.erase(std::remove_if(found.begin(), found.end(), needless), found.end());
}

ToolConstraints::ToolConstraints(const core::Profile& tool, const std::vector<bool>& contact_boundaries)
    : in_contact_(no_box()), coincident_(core::tolerance::coincident * core::size(tool)) {
  const std::vector<Index> kept = without_slivers(tool);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const Segment &segment = tool.segments[kept[k]], &next = tool.segments[kept[k + 1 < kept.size() ? k + 1 : 0]];
    const double turn = turn_between(segment, next);
    const double length = core::length(segment);
    segments_.push_back({&segment, kept[k], bounds(segment), bool(contact_boundaries[segment.boundary_id]), length,
                         end_tolerance * length, turn < -smooth_angle, std::abs(turn) <= smooth_angle,
                         (core::normal_at(segment, 1) + core::normal_at(next, 0)).normalized()});
    if (segments_.back().in_contact) in_contact_ = united(in_contact_, segments_.back().bounds);
  }
}

std::vector<GapConstraint> ToolConstraints::operator()(const Point& x, double reach) const {
  if (!is_near(x, in_contact_, max_off * reach)) return {};
  const Query query{segments_, x, reach, coincident_};
  std::vector<GapConstraint> found;
  for (Index i = 0; i < query.count(); ++i) {
    if (!is_near(x, segments_[i].bounds, max_off * reach)) continue;
    query.add_segment(i, found);
    query.add_joint(i, found);
    query.add_tip(i, found);
  }
  query.keep_closest_exterior(found);
  merge_constraints(found);
  return found;
}

bool ToolConstraints::is_beyond(const Box& box, double reach) const {
  const Box within = inflated(box, reach);
  return !overlap(within, in_contact_) || std::none_of(segments_.begin(), segments_.end(), [&](const auto& segment) {
    return segment.in_contact && overlap(within, segment.bounds);
  });
}

void merge_constraints(std::vector<GapConstraint>& constraints) {
  if (constraints.size() < 2) return;
  std::stable_sort(constraints.begin(), constraints.end(), [](const auto& a, const auto& b) { return a.gap < b.gap; });
  std::vector<GapConstraint> kept;
  for (const auto& c : constraints) {
    const auto parallel = [&](const GapConstraint& k) { return k.normal.dot(c.normal) > smooth_cosine; };
    if (static_cast<int>(kept.size()) < core::dim && std::none_of(kept.begin(), kept.end(), parallel))
      kept.push_back(c);
  }
  constraints = kept;
}

}  // namespace parison::contact
