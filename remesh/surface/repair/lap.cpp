// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/repair/lap.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace

Crossings remove_crossings(core::Geometry geometry, const CrossingLimits& limits, Surface& surface) {
  Crossings found;
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
    ++(torn ? found.torn : found.laps);
    (torn ? found.torn_volume : found.lap_volume) += std::abs(volume);
  }
}

}  // namespace parison::remesh
