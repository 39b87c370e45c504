// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/tool_gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parison::contact {

using core::Index;
using core::Point;
using core::Profile;
using core::Segment;

namespace {

constexpr double smooth_angle =
    M_PI / 9;  ///< 20 degrees: joints that turn less are smooth, normals that differ less are one
constexpr double end_tolerance = 1e-9;  ///< of the segment's length: on the end counts as on the segment
constexpr double touching = 1e-9;       ///< m

double cross(const Point& a, const Point& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// A tool, and what is asked about it.
struct Query {
  const Profile& tool;
  const std::vector<bool>& contact_pieces;
  const Point& x;
  double reach;

  Index count() const { return static_cast<Index>(tool.segments.size()); }
  const Segment& segment(Index i) const { return tool.segments[i]; }
  Index next(Index i) const { return (i + 1) % count(); }
  bool in_contact(Index i) const { return contact_pieces[segment(i).piece]; }
};

/// Angle by which the outline turns from segment i to the next; positive at a corner that sticks out of the tool.
double turn_after(const Query& query, Index i) {
  const Point in = core::tangent_at(query.segment(i), 1), out = core::tangent_at(query.segment(query.next(i)), 0);
  return std::atan2(cross(in, out), in.dot(out));
}

bool hollow_after(const Query& query, Index i) {
  return turn_after(query, i) < -smooth_angle;
}

bool joined(const Query& query, Index i, Index j) {
  return query.next(i) == j || query.next(j) == i;
}

bool joined_in_hollow(const Query& query, Index i, Index j) {
  return (query.next(i) == j && hollow_after(query, i)) || (query.next(j) == i && hollow_after(query, j));
}

/// Whether x projects on segment i, or past an end in a hollow corner while still on the neighbour's side of that one's
/// far end.
bool projects_on(const Query& query, Index i) {
  const Segment& segment = query.segment(i);
  const double slack = end_tolerance * core::length(segment);
  const double before = core::beyond_start(segment, query.x), past = core::beyond_end(segment, query.x);
  if (before <= slack && past <= slack) return true;
  if (past > slack) {
    const Index j = query.next(i);
    return past <= query.reach && query.in_contact(j) && hollow_after(query, i) &&
           core::beyond_end(query.segment(j), query.x) <= 0 && core::beyond_start(query.segment(j), query.x) <= query.reach;
  }
  const Index j = (i + query.count() - 1) % query.count();
  return before <= query.reach && query.in_contact(j) && hollow_after(query, j) &&
         core::beyond_start(query.segment(j), query.x) <= 0 && core::beyond_end(query.segment(j), query.x) <= query.reach;
}

/// Whether the straight path from a to b, its ends left out, crosses a segment.
bool crosses(const Segment& segment, const Point& a, const Point& b) {
  constexpr double margin = 1e-6;
  const auto inside = [&](double u) { return u > margin && u < 1 - margin; };
  const Point path = b - a;
  if (!segment.is_arc) {
    const Point along = segment.end - segment.start, offset = segment.start - a;
    const double determinant = cross(path, along);
    if (determinant == 0) return false;
    const double t = cross(offset, path) / determinant;
    return inside(cross(offset, along) / determinant) && t >= 0 && t <= 1;
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

/// Whether another part of the outline lies between x and its foot on segment i.
bool hidden(const Query& query, Index i, const Point& foot) {
  for (Index j = 0; j < query.count(); ++j)
    if (j != i && !joined_in_hollow(query, i, j) && crosses(query.segment(j), query.x, foot)) return true;
  return false;
}

bool is_major_arc(const Segment& segment) {
  return segment.is_arc && std::abs(segment.to - segment.from) > M_PI;
}

/// Whether x is too far for a foot on the segment, or past an end of it by no more than the reach, to be within reach.
bool far_from(const Segment& segment, const Point& x, double reach) {
  const double most = 2 * reach;
  if (segment.is_arc && std::abs((x - segment.centre).norm() - segment.radius) > most) return true;
  const bool bulges = is_major_arc(segment);
  const Point middle = bulges ? segment.centre : Point(0.5 * (segment.start + segment.end));
  const double size = bulges ? segment.radius : 0.5 * (segment.end - segment.start).norm();
  return (x - middle).squaredNorm() > (size + most) * (size + most);
}

/// Box that holds a segment: the square round the ends of a line or a minor arc.
Box bounds(const Segment& segment) {
  const bool major = is_major_arc(segment);
  const Point middle = major ? segment.centre : Point(0.5 * (segment.start + segment.end));
  return inflated({middle, middle}, major ? segment.radius : 0.5 * (segment.end - segment.start).lpNorm<1>());
}

void add_segment(const Query& query, Index i, std::vector<GapConstraint>& found) {
  if (!query.in_contact(i) || far_from(query.segment(i), query.x, query.reach) || !projects_on(query, i)) return;
  const double t = core::projected_parameter(query.segment(i), query.x);
  const Point foot = core::point_at(query.segment(i), t), normal = core::normal_at(query.segment(i), t);
  const double gap = (query.x - foot).dot(normal);
  if (std::abs(gap) <= query.reach && !hidden(query, i, foot)) found.push_back({gap, normal, i});
}

/// The joint after segment i, for a point that projects on neither side of it.
void add_joint(const Query& query, Index i, std::vector<GapConstraint>& found) {
  const Index j = query.next(i);
  if (!query.in_contact(i) || !query.in_contact(j)) return;
  if ((query.x - query.segment(i).end).squaredNorm() > query.reach * query.reach || hollow_after(query, i)) return;
  const Segment &before = query.segment(i), &after = query.segment(j);
  if (core::beyond_end(before, query.x) <= end_tolerance * core::length(before)) return;
  if (core::beyond_start(after, query.x) <= end_tolerance * core::length(after)) return;
  const Point mean = (core::normal_at(before, 1) + core::normal_at(after, 0)).normalized();
  const Point arm = query.x - before.end;
  const double distance = arm.norm(), side = arm.dot(mean) < 0 ? -1 : 1;
  const bool smooth = std::abs(turn_after(query, i)) <= smooth_angle;
  if (distance > query.reach || (side < 0 && !smooth) || hidden(query, i, before.end)) return;
  found.push_back({side * distance, distance > 1e-3 * touching ? Point(side / distance * arm) : mean, i});
}

/// A point inside the tool leaves it the shortest way: of the penetrated segments only the nearest one counts, and its
/// neighbours in a hollow corner. On the edge of a sharp corner, too, one of the two sides counts.
void keep_shortest_way_out(const Query& query, std::vector<GapConstraint>& found) {
  if (found.empty()) return;
  const Index nearest = std::min_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
                          return std::abs(a.gap) < std::abs(b.gap);
                        })->segment;
  const auto needless = [&](const GapConstraint& c) {
    if (c.segment == nearest || joined_in_hollow(query, c.segment, nearest)) return false;
    return c.gap < (joined(query, c.segment, nearest) ? touching : 0.0);
  };
  found.erase(std::remove_if(found.begin(), found.end(), needless), found.end());
}

}  // namespace

std::vector<GapConstraint> gap_constraints(const Profile& tool, const std::vector<bool>& contact_pieces, const Point& x,
                                           double reach) {
  const Query query{tool, contact_pieces, x, reach};
  std::vector<GapConstraint> found;
  for (Index i = 0; i < query.count(); ++i) {
    add_segment(query, i, found);
    add_joint(query, i, found);
  }
  keep_shortest_way_out(query, found);
  merge_constraints(found);
  return found;
}

void merge_constraints(std::vector<GapConstraint>& constraints) {
  std::stable_sort(constraints.begin(), constraints.end(), [](const auto& a, const auto& b) { return a.gap < b.gap; });
  std::vector<GapConstraint> kept;
  for (const auto& c : constraints) {
    const auto parallel = [&](const GapConstraint& k) { return k.normal.dot(c.normal) > std::cos(smooth_angle); };
    if (static_cast<int>(kept.size()) < core::dim && std::none_of(kept.begin(), kept.end(), parallel))
      kept.push_back(c);
  }
  constraints = kept;
}

ToolGap::ToolGap(const Profile& tool, const std::vector<bool>& contact_pieces, double reach) : tool_(&tool), reach_(reach) {
  constexpr double far = std::numeric_limits<double>::infinity();
  in_reach_ = {Point::Constant(far), Point::Constant(-far)};
  for (const auto& segment : tool.segments) {
    if (!contact_pieces[segment.piece]) continue;
    pieces_.push_back({bounds(segment), &segment});
    in_reach_ = united(in_reach_, inflated(pieces_.back().bounds, reach));
  }
}

double ToolGap::operator()(const Point& x) const {
  constexpr double beyond = std::numeric_limits<double>::infinity();
  if (!overlap({x, x}, in_reach_)) return beyond;
  double best = reach_;
  for (const auto& [bounds, segment] : pieces_)
    if (overlap({x, x}, inflated(bounds, best))) best = core::distance(*segment, x, best);
  if (best >= reach_) return beyond;
  return core::contains(*tool_, x) ? -best : best;
}

double signed_gap(const Profile& tool, const std::vector<bool>& contact_pieces, const Point& x, double reach) {
  return ToolGap(tool, contact_pieces, reach)(x);
}

}  // namespace parison::contact
