// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/mortar/mortar.hpp"

#include <algorithm>
#include <utility>

#include "contact/mortar/box_tree.hpp"
#include "contact/mortar/segment_gap.hpp"
#include "core/mesh/element.hpp"

namespace parison::contact {

namespace {

/// Gauss points of a stretch. Where it is closed, exact to degree 5 for the two quadratic fields and the radius, and to
/// degree 7 where an edge is bent or its mid-side node off the middle; in the hand-over also for the closure.
constexpr int even_points = 3, bent_points = 4, handover_points = 5;
constexpr double even = 0.005;  ///< how far an even edge's mid-side node may lie off the middle of its chord, in chords

/// The masters' edges in one list, and where they lie.
struct Target {
  std::vector<MasterEdge> edges;
  BoxTree tree;
};

/// Box around a quadratic edge: the hull of its Bezier points.
Box bounds(const SurfaceEdge& edge) {
  const Point control = 2 * edge.x[2] - 0.5 * (edge.x[0] + edge.x[1]);
  return {edge.x[0].cwiseMin(edge.x[1]).cwiseMin(control), edge.x[0].cwiseMax(edge.x[1]).cwiseMax(control)};
}

Target make_target(const std::vector<Master>& masters) {
  std::vector<MasterEdge> edges;
  std::vector<Box> boxes;
  std::size_t count = 0;
  for (const Master& master : masters) count += master.surface.edges.size();
  edges.reserve(count);
  boxes.reserve(count);
  for (std::size_t m = 0; m < masters.size(); ++m)
    for (const auto& edge : masters[m].surface.edges) {
      edges.push_back({edge, static_cast<Index>(m)});
      boxes.push_back(bounds(edge));
    }
  return {std::move(edges), BoxTree(std::move(boxes))};
}

/// How far away an edge's masters are looked for: the hand-over, the deepest overlap, and half an edge for what chords
/// cut off curves.
double sight_range(const SurfaceEdge& slave, const std::vector<Master>& masters) {
  double range = 0;
  for (const Master& master : masters) {
    range = std::max(range, master.handover_width);
    for (const Index node : slave.nodes) range = std::max(range, master.handover_width - master.gap[node]);
  }
  return range + 0.5 * (slave.x[1] - slave.x[0]).norm();
}

/// Whether a part of an edge, `share` of its length, is as good as straight and evenly divided; it bends the less the
/// shorter it is.
bool is_even(const SurfaceEdge& edge, double share) {
  const Point off = share * (edge.x[2] - 0.5 * (edge.x[0] + edge.x[1]));
  return off.squaredNorm() < even * even * (edge.x[1] - edge.x[0]).squaredNorm();
}

/// A stretch of a slave edge that faces one master edge: a segment, or several in a row that are closed alike, on which
/// all but the gap is smooth.
struct Stretch {
  Index edge;  ///< into EdgeView::masters
  Closing closing;
  std::size_t first, last;  ///< range of EdgeParts::gaps
};

/// What a slave edge is divided into; kept from edge to edge for its memory.
struct EdgeParts {
  std::vector<InterfaceNode> nodes;
  std::vector<Segment> segments;
  std::vector<SegmentGap> gaps;  ///< of the segments
  std::vector<Stretch> stretches;
};

void divide(const EdgeView& view, const std::vector<Master>& masters, EdgeParts& parts) {
  find_interface_nodes(view, parts.nodes);
  find_segments(view, parts.nodes, parts.segments);
  parts.gaps.clear();
  parts.stretches.clear();
  for (const Segment& segment : parts.segments) {
    const Master& master = masters[view.masters[segment.edge].master];
    const std::size_t at = parts.gaps.size();
    const SegmentGap& gap = parts.gaps.emplace_back(view, segment, master);
    const Closing closed = closing(gap, master.handover_width);
    const bool goes_on = closed != Closing::open && at > 0 && parts.stretches.back().closing == closed &&
                         parts.stretches.back().edge == segment.edge && parts.gaps[at - 1].end() == gap.begin();
    if (!goes_on) parts.stretches.push_back({segment.edge, closed, at, at});
    parts.stretches.back().last = at + 1;
  }
}

/// A point of the interface: every field is the polynomial of its own edge, at the slave point and at the point it
/// sees.
void set_point(const SurfaceEdge& slave, const SurfaceEdge& master, double s, double seen_at,
               const Eigen::VectorXd& pressure, core::InterfacePoint& point) {
  point.slave_nodes = slave.nodes;
  point.master_nodes = master.nodes;
  point.slave_shape = core::edge_shape(s);
  point.master_shape = core::edge_shape(seen_at);
  double pressed = 0;
  for (int i = 0; i < 3; ++i) pressed += point.slave_shape[i] * pressure[slave.nodes[i]];
  point.pressure = std::max(pressed, 0.0);
}

/// Where the points of one slave edge go.
struct Edge {
  const EdgeView& view;
  const std::vector<SegmentGap>& gaps;
  Index slave_body;
  const Eigen::VectorXd& pressure;
  std::vector<core::InterfacePoint>& points;
};

/// Gauss points of a stretch where it is closed.
void add_points(const Edge& edge, const Stretch& stretch, const Master& master) {
  const SurfaceEdge& slave = edge.view.slave.edge;
  const SurfaceEdge& facing = edge.view.masters[stretch.edge].edge;
  const SegmentGap *gap_at = &edge.gaps[stretch.first], *last_gap = &edge.gaps[stretch.last - 1];
  const double share = last_gap->end() - gap_at->begin();
  const int closed_points = is_even(slave, share) && is_even(facing, 1) ? even_points : bent_points;
  const Parts parts = stretch.closing != Closing::open ? Parts{{gap_at->begin(), last_gap->end()}, 2}
                                                       : cut_at_handover(*gap_at, master.handover_width);
  for (int part = 1; part < parts.count; ++part) {
    const double begin = parts.end[part - 1], length = parts.end[part] - begin;
    const bool closed =
        stretch.closing != Closing::open || is_closed(*gap_at, begin, parts.end[part], master.handover_width);
    for (const auto& rule : core::edge_rule(closed ? closed_points : handover_points)) {
      const double s = begin + rule.s * length;
      while (gap_at != last_gap && s > gap_at->end()) ++gap_at;
      const double gap = (*gap_at)(s), closure_there = closure(gap, master.handover_width);
      if (!(closure_there > 0)) continue;
      const Ray from = ray(edge.view.slave, s);
      const auto seen_at = find_master_parameter(from, facing);
      if (!seen_at) continue;
      core::InterfacePoint& point = edge.points.emplace_back();
      set_point(slave, facing, s, *seen_at, edge.pressure, point);
      point.position = from.from;
      point.area = rule.weight * length * slope(slave, s).norm();
      point.gap = gap;
      point.closure = closure_there;
      point.law = master.law;
      point.slave_body = edge.slave_body;
      point.master_body = master.surface.body;
    }
  }
}

}  // namespace

std::vector<core::InterfacePoint> build_interface(const Surface& slave, const Eigen::VectorXd& pressure,
                                                  const std::vector<Master>& masters, core::Geometry geometry) {
  const Target target = make_target(masters);
  std::vector<core::InterfacePoint> points;
  points.reserve(16 * slave.edges.size());
  std::vector<Index> near;
  EdgeParts parts;
  for (const auto& edge : make_rays(slave)) {
    const double range = sight_range(edge.edge, masters);
    near.clear();
    target.tree.query(inflated(bounds(edge.edge), range), near);
    if (near.empty()) continue;
    const EdgeView view{edge, target.edges, near, range};
    divide(view, masters, parts);
    for (const Stretch& stretch : parts.stretches)
      add_points({view, parts.gaps, slave.body, pressure, points}, stretch, masters[target.edges[stretch.edge].master]);
  }
  for (auto& point : points) point.area *= core::depth(geometry, point.position);
  return points;
}

}  // namespace parison::contact
