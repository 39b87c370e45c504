// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/repair/lap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/mesh/profile.hpp"

namespace parison::remesh {

using core::Index;
using core::Point;

namespace {

constexpr int max_crossings = 16;

/// Whether most vertices between `begin` and `end` lie outside what the other vertices of their loop enclose.
bool lies_outside(const Outline& outline, Index begin, Index end) {
  core::Profile rest;
  const auto add = [&](Index from, Index to) {
    core::Segment segment;
    segment.start = outline.vertices[from], segment.end = outline.vertices[to];
    rest.segments.push_back(segment);
  };
  const auto [loop_begin, loop_end] = loop_of(outline, begin);
  add(begin, end);
  for (Index i = end; i + 1 < loop_end; ++i) add(i, i + 1);
  add(loop_end - 1, loop_begin);
  for (Index i = loop_begin; i < begin; ++i) add(i, i + 1);
  int inside = 0;
  for (Index i = begin + 1; i < end; ++i) inside += core::contains(rest, outline.vertices[i]);
  return 2 * inside < end - begin - 1;
}

/// Whether the edges [begin, end) may be replaced by a chord: they belong to one loop, which keeps enough edges, have
/// no fixed mid points, and lie on one boundary or on two of which the second continues behind them.
bool may_cut(const Surface& surface, Index begin, Index end) {
  const Outline& outline = surface.outline;
  const auto [loop_begin, loop_end] = loop_of(outline, begin);
  if (end >= loop_end || loop_end - loop_begin - (end - begin) + 1 < min_edges) return false;
  int changes = 0;
  for (Index i = begin; i < end; ++i) {
    if (surface.fixed[outline.edge_count() + i]) return false;
    changes += i > begin && outline.boundary_ids[i] != outline.boundary_ids[i - 1];
  }
  return changes == 0 || (changes == 1 && outline.boundary_ids[end] == outline.boundary_ids[end - 1]);
}

/// Replaces the edges from vertex `begin` to vertex `end` by one straight edge on the first one's boundary.
void cut(Surface& surface, Index begin, Index end) {
  Outline& outline = surface.outline;
  const Index count = outline.edge_count(), gone = end - begin - 1;
  outline.mids[begin] = 0.5 * (outline.vertices[begin] + outline.vertices[end]);
  for (auto* flags : {&surface.contact, &surface.fixed}) {
    (*flags)[count + begin] = (*flags)[begin] && (*flags)[end];
    flags->erase(flags->begin() + count + begin + 1, flags->begin() + count + end);
    flags->erase(flags->begin() + begin + 1, flags->begin() + end);
  }
  surface.fixed[count - gone + begin] = false;
  const auto erase = [&](auto& list) { list.erase(list.begin() + begin + 1, list.begin() + end); };
  erase(outline.vertices);
  outline.mids.erase(outline.mids.begin() + begin + 1, outline.mids.begin() + end);
  outline.boundary_ids.erase(outline.boundary_ids.begin() + begin + 1, outline.boundary_ids.begin() + end);
  for (Index& start : outline.loop_start)
    if (start > begin) start -= gone;
}

/// Joins the ends of an edge on the free surface that is shorter than a tenth of both its neighbours: the cells beside
/// it would be as small, and the steps with them.
void join_short(Surface& surface, Index edge) {
  constexpr double is_short = 0.1;
  Outline& outline = surface.outline;
  const auto [loop_begin, loop_end] = loop_of(outline, edge);
  const Index count = outline.edge_count();
  if (edge == loop_begin || edge + 2 >= loop_end || loop_end - loop_begin <= min_edges) return;
  const auto chord = [&](Index i) { return (outline.vertices[i + 1] - outline.vertices[i]).norm(); };
  if (chord(edge) > is_short * std::min(chord(edge - 1), chord(edge + 1))) return;
  const bool same = outline.boundary_ids[edge] == outline.boundary_ids[edge + 1];
  for (const Index vertex : {edge, edge + 1})
    if (!same || surface.contact[vertex] || surface.fixed[vertex]) return;
  outline.vertices[edge + 1] = outline.mids[edge];
  const auto erase = [&](auto& list, Index at) { list.erase(list.begin() + at); };
  for (auto* flags : {&surface.contact, &surface.fixed}) erase(*flags, count + edge), erase(*flags, edge);
  erase(outline.vertices, edge), erase(outline.mids, edge), erase(outline.boundary_ids, edge);
  for (Index& start : outline.loop_start)
    if (start > edge) --start;
}

/// Distance of a point from the straight line between two others, m.
double distance(const Point& x, const Point& a, const Point& b) {
  const Point along = b - a;
  const double share = std::clamp((x - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (x - a - share * along).norm();
}

/// The two chords of an edge as a list of three points.
std::array<Point, 3> points_of(const Outline& outline, const std::vector<Index>& ends, Index edge) {
  return {outline.vertices[edge], outline.mids[edge], outline.vertices[ends[edge]]};
}

/// Smallest distance between edges that do not cross, m.
double distance(const std::array<Point, 3>& a, const std::array<Point, 3>& b) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 2; ++i)
    for (const Point& x : b) least = std::min(least, distance(x, a[i], a[i + 1]));
  for (int i = 0; i < 2; ++i)
    for (const Point& x : a) least = std::min(least, distance(x, b[i], b[i + 1]));
  return least;
}

/// Whether an edge is free: it touches no tool and lies on no line of symmetry.
bool is_free(const Surface& surface, const std::vector<Index>& ends, Index edge) {
  const Index mid = surface.outline.edge_count() + edge;
  return !surface.contact[edge] && !surface.contact[mid] && !surface.contact[ends[edge]] && !surface.fixed[mid];
}

/// Cuts off the pieces that hang on necks thinner than the limit.
void tear_necks(core::Geometry geometry, const CrossingLimits& limits, Surface& surface, Crossings& found) {
  constexpr double many = 10;  // neck widths: what is no larger is the point of a wedge, not a piece on a neck
  const auto is_piece = [&](const Outline& outline, Index begin, Index end) {
    for (Index i = begin + 1; i < end; ++i)
      if ((outline.vertices[i] - outline.vertices[begin]).norm() > many * limits.neck) return true;
    return false;
  };
  const auto next_neck = [&]() -> std::pair<Index, Index> {
    const Outline& outline = surface.outline;
    const auto ends = edge_ends(outline);
    for (Index i = 0; i < outline.edge_count(); ++i) {
      if (!is_free(surface, ends, i)) continue;
      const auto a = points_of(outline, ends, i);
      const double reach = (a[1] - a[0]).norm() + (a[2] - a[1]).norm() + limits.neck;
      for (Index k = i + 2; k < outline.edge_count(); ++k) {
        if ((outline.mids[k] - a[1]).norm() > reach + (outline.vertices[ends[k]] - outline.vertices[k]).norm())
          continue;
        if (!is_free(surface, ends, k) || ends[k] == i || !may_cut(surface, i, k + 1)) continue;
        if (distance(a, points_of(outline, ends, k)) > limits.neck || !is_piece(outline, i + 1, k)) continue;
        const double volume = volume_cut(outline, i, k + 1, geometry);
        if (volume > 0 && volume < limits.torn && lies_outside(outline, i, k + 1)) return {i, k + 1};
      }
    }
    return {-1, -1};
  };
  for (auto neck = next_neck(); neck.first >= 0 && found.torn < max_crossings; neck = next_neck()) {
    const auto [begin, end] = neck;
    found.torn_volume += volume_cut(surface.outline, begin, end, geometry);
    ++found.torn;
    cut(surface, begin, end);
    join_short(surface, begin);
  }
}

/// Whether none of the edges [begin, end) has a fixed mid point.
bool is_movable(const Surface& surface, Index begin, Index end) {
  for (Index i = begin; i < end; ++i)
    if (surface.fixed[surface.outline.edge_count() + i]) return false;
  return true;
}

/// Joins the glass where the edges `first` and `last` of a loop cross: what lies between them becomes a loop of its
/// own, around the air that is enclosed. Glass counted twice, which is left of a loop around air, goes.
void enclose(core::Geometry geometry, Index first, Index last, Surface& surface) {
  const bool was_air = loop_volume(surface.outline, first, geometry) < 0;
  const Index joint = reconnect(surface, first, last).first;
  const auto [begin, end] = loop_of(surface.outline, joint);
  if (end - begin < min_edges || (was_air && loop_volume(surface.outline, joint, geometry) > 0))
    erase_loop(surface, joint);
}

/// The removal of the crossings of one surface.
class Removal {
 public:
  Removal(core::Geometry geometry, const CrossingLimits& limits, Surface& surface, Crossings& found)
      : geometry_(geometry), limits_(limits), surface_(surface), found_(found) {}

  /// Removes the crossing of two edges, `first` before `last`; false where it has to stay.
  bool remove(Index first, Index last) {
    if (++rounds_ > max_rounds) return false;
    const auto [begin, behind] = loop_of(surface_.outline, first);
    if (last >= behind) return open_film(first, last);
    const double whole = loop_volume(surface_.outline, first, geometry_),
                 between = volume_cut(surface_.outline, first, last + 1, geometry_);
    if (whole > 0 && between > 0.5 * whole) return turn(begin, last);
    if (last + 1 == behind && first > begin) return turn(begin, first);
    if (whole < 0 && -whole <= limits_.lap) return fill_air(first, whole);
    if (-between > limits_.lap && last - first >= min_edges) return enclose_air(first, last, whole, between);
    return cut_off(first, last, whole, between);
  }
  /// Lets the loops begin where they did.
  void turn_back() {
    for (const Point& start : starts_) {
      const auto& vertices = surface_.outline.vertices;
      const auto found = std::find(vertices.begin(), vertices.end(), start);
      if (found != vertices.end()) rotate_loop(surface_, static_cast<Index>(found - vertices.begin()));
    }
  }

 private:
  static constexpr int max_rounds = 100;

  /// The film between two bubbles, or between one and the outside, has torn.
  bool open_film(Index first, Index last) {
    reconnect(surface_, first, last);
    return true;
  }
  /// Lets the loop begin at another edge, so that the smaller of its two parts at a crossing lies between the crossing
  /// edges and does not end with the loop.
  bool turn(Index begin, Index to) {
    starts_.push_back(surface_.outline.vertices[begin]);
    rotate_loop(surface_, to);
    return true;
  }
  /// A bubble whose sides have met.
  bool fill_air(Index edge, double whole) {
    erase_loop(surface_, edge);
    ++found_.laps;
    found_.lap_volume -= whole;
    return true;
  }
  bool enclose_air(Index first, Index last, double whole, double between) {
    if (!is_movable(surface_, first, last + 1) || (whole > 0 && lies_outside(surface_.outline, first, last + 1)))
      return stays(first, last, between, false);
    enclose(geometry_, first, last, surface_);
    if (whole > 0) {
      ++found_.enclosed;
      found_.enclosed_volume -= between;
    }
    return true;
  }
  bool cut_off(Index first, Index last, double whole, double between) {
    const bool torn = whole > 0 && between > 0 && lies_outside(surface_.outline, first, last + 1);
    if (!may_cut(surface_, first, last + 1) || std::abs(between) > (torn ? limits_.torn : limits_.lap))
      return stays(first, last, between, torn);
    cut(surface_, first, last + 1);
    join_short(surface_, first);
    ++(torn ? found_.torn : found_.laps);
    (torn ? found_.torn_volume : found_.lap_volume) += std::abs(between);
    return true;
  }
  bool stays(Index first, Index last, double volume, bool torn) {
    found_.first = first, found_.second = last;
    found_.left_volume = std::abs(volume), found_.left_torn = torn;
    return false;
  }

  core::Geometry geometry_;
  const CrossingLimits& limits_;
  Surface& surface_;
  Crossings& found_;
  std::vector<Point> starts_;  ///< of loops that have been turned
  int rounds_ = 0;
};

}  // namespace

Crossings remove_crossings(core::Geometry geometry, const CrossingLimits& limits, Surface& surface) {
  Crossings found;
  Removal removal(geometry, limits, surface, found);
  const auto remove_all = [&] {
    for (auto at = find_crossing(surface.outline); at.first >= 0; at = find_crossing(surface.outline)) {
      const auto [first, last] = std::minmax(at.first, at.second);
      if (removal.remove(first, last)) continue;
      found.first = first, found.second = last;
      return false;
    }
    return true;
  };
  // Glass that has met glass is near itself as well as a neck is.
  if (!remove_all()) return found;
  if (limits.neck > 0) {
    tear_necks(geometry, limits, surface, found);
    if (!remove_all()) return found;
  }
  removal.turn_back();
  return found;
}

}  // namespace parison::remesh
