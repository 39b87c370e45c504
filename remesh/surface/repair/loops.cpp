// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include "core/mesh/element.hpp"
#include "remesh/surface/repair/lap.hpp"

namespace parison::remesh {

using core::Index;
using core::Point;

namespace {

/// Edges in a new order, loop by loop.
struct Order {
  std::vector<Index> edges, loop_start{0};

  void close_loop() { loop_start.push_back(static_cast<Index>(edges.size())); }
  void add(Index begin, Index end) {
    for (Index i = begin; i < end; ++i) edges.push_back(i);
  }
  Index place_of(Index edge) const {
    return static_cast<Index>(std::find(edges.begin(), edges.end(), edge) - edges.begin());
  }
};

void reorder(Surface& surface, Order order) {
  Surface result;
  const Index count = surface.outline.edge_count();
  for (const Index i : order.edges) {
    result.outline.vertices.push_back(surface.outline.vertices[i]);
    result.outline.mids.push_back(surface.outline.mids[i]);
    result.outline.boundary_ids.push_back(surface.outline.boundary_ids[i]);
  }
  for (const Index points : {Index(0), count})
    for (const Index i : order.edges) {
      result.contact.push_back(surface.contact[points + i]);
      result.fixed.push_back(surface.fixed[points + i]);
    }
  result.outline.loop_start = std::move(order.loop_start);
  surface = std::move(result);
}

void straighten(Surface& surface, Index edge) {
  Outline& outline = surface.outline;
  outline.mids[edge] = 0.5 * (outline.vertices[edge] + outline.vertices[edge_ends(outline)[edge]]);
  surface.contact[outline.edge_count() + edge] = surface.fixed[outline.edge_count() + edge] = false;
}

}  // namespace

std::pair<Index, Index> loop_of(const Outline& outline, Index edge) {
  const auto after = std::upper_bound(outline.loop_start.begin(), outline.loop_start.end(), edge);
  return {*(after - 1), *after};
}

double volume_cut(const Outline& outline, Index begin, Index end, core::Geometry geometry) {
  const Point& from = outline.vertices[begin];
  double volume = 0;
  Point last = from;
  const auto go_to = [&](const Point& x) {
    volume += 0.5 * core::cross(last - from, x - from) * core::depth(geometry, (from + last + x) / 3);
    last = x;
  };
  const auto [first, behind] = loop_of(outline, begin);
  for (Index i = begin; i < end; ++i) {
    go_to(outline.mids[i]);
    go_to(outline.vertices[i + 1 < behind ? i + 1 : first]);
  }
  return volume;
}

double loop_volume(const Outline& outline, Index edge, core::Geometry geometry) {
  const auto [begin, end] = loop_of(outline, edge);
  return volume_cut(outline, begin, end, geometry);
}

void erase_loop(Surface& surface, Index edge) {
  const std::vector<Index>& starts = surface.outline.loop_start;
  Order order;
  for (std::size_t k = 0; k + 1 < starts.size(); ++k)
    if (edge < starts[k] || edge >= starts[k + 1]) {
      order.add(starts[k], starts[k + 1]);
      order.close_loop();
    }
  reorder(surface, std::move(order));
}

void rotate_loop(Surface& surface, Index edge) {
  const auto [begin, end] = loop_of(surface.outline, edge);
  Order order;
  order.add(0, begin);
  order.add(edge, end);
  order.add(begin, edge);
  order.add(end, surface.outline.edge_count());
  order.loop_start = surface.outline.loop_start;
  reorder(surface, std::move(order));
}

std::pair<Index, Index> reconnect(Surface& surface, Index a, Index c) {
  const Outline& outline = surface.outline;
  const auto [begin, end] = loop_of(outline, a);
  const auto [other, other_end] = loop_of(outline, c);
  const bool one_loop = begin == other;
  Order order;
  for (std::size_t k = 0; k + 1 < outline.loop_start.size(); ++k) {
    const Index first = outline.loop_start[k];
    if (first == begin) {
      order.add(begin, a + 1);
      order.add(c + 1, other_end);
      if (!one_loop) {
        order.add(other, c + 1);
        order.add(a + 1, end);
      }
    } else if (first != other) {
      order.add(first, outline.loop_start[k + 1]);
    } else {
      continue;
    }
    order.close_loop();
  }
  if (one_loop) {
    order.add(a + 1, c + 1);
    order.close_loop();
  }
  const std::pair<Index, Index> places{order.place_of(a), order.place_of(c)};
  reorder(surface, std::move(order));
  straighten(surface, places.first);
  straighten(surface, places.second);
  return places;
}

}  // namespace parison::remesh
