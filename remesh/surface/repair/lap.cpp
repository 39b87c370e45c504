// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/repair/lap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/mesh/element.hpp"
#include "core/mesh/profile.hpp"

namespace parison::remesh {

using core::Index;
using core::Point;

namespace {

constexpr int max_crossings = 16;
constexpr int min_edges = 3;  ///< smallest number of edges of a loop

double cross(const Point& a, const Point& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// Volume between the outline from vertex `begin` to vertex `end` and the chord between them, m3; positive where it is
/// on the left, as the body is.
double volume_cut(const Outline& outline, Index begin, Index end, core::Geometry geometry) {
  const Point& from = outline.vertices[begin];
  double volume = 0;
  Point last = from;
  const auto go_to = [&](const Point& x) {
    volume += 0.5 * cross(last - from, x - from) * core::depth(geometry, (from + last + x) / 3);
    last = x;
  };
  for (Index i = begin; i < end; ++i) {
    go_to(outline.mids[i]);
    go_to(outline.vertices[i + 1]);
  }
  return volume;
}

/// Whether most vertices between `begin` and `end` lie outside what the other vertices of their loop enclose.
bool lies_outside(const Outline& outline, Index begin, Index end) {
  const auto after = std::upper_bound(outline.loop_start.begin(), outline.loop_start.end(), begin);
  core::Profile rest;
  const auto add = [&](Index from, Index to) {
    core::Segment segment;
    segment.start = outline.vertices[from], segment.end = outline.vertices[to];
    rest.segments.push_back(segment);
  };
  const Index loop_begin = *(after - 1), loop_end = *after;
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
  const auto after = std::upper_bound(outline.loop_start.begin(), outline.loop_start.end(), begin);
  if (after == outline.loop_start.end() || end >= *after || *after - *(after - 1) - (end - begin) + 1 < min_edges)
    return false;
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
  const auto after = std::upper_bound(outline.loop_start.begin(), outline.loop_start.end(), edge);
  const Index loop_begin = *(after - 1), loop_end = *after, count = outline.edge_count();
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

}  // namespace

Crossings remove_crossings(core::Geometry geometry, const CrossingLimits& limits, Surface& surface) {
  Crossings found;
  if (limits.neck > 0) tear_necks(geometry, limits, surface, found);
  for (;;) {
    const auto [first, second] = find_crossing(surface.outline);
    if (first < 0) return found;
    const auto [begin, last] = std::minmax(first, second);
    const Index end = last + 1;
    const bool may = may_cut(surface, begin, end);
    const double volume = may ? volume_cut(surface.outline, begin, end, geometry) : 0;
    const bool torn = volume > 0 && lies_outside(surface.outline, begin, end);
    if (!may || found.laps + found.torn == max_crossings || std::abs(volume) > (torn ? limits.torn : limits.lap)) {
      found.first = first, found.second = second;
      found.left_volume = std::abs(volume), found.left_torn = torn;
      return found;
    }
    cut(surface, begin, end);
    join_short(surface, begin);
    ++(torn ? found.torn : found.laps);
    (torn ? found.torn_volume : found.lap_volume) += std::abs(volume);
  }
}

}  // namespace parison::remesh
