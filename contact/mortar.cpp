// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/mortar.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/box_tree.hpp"
#include "contact/root.hpp"
#include "contact/segments.hpp"
#include "core/element.hpp"

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

/// Gap to the segment's master at one of the slave's nodes: its own; where out of reach, how far the mesh is, and open
/// where that lies behind the slave.
double gap_of_slave_node(const Master& master, Index node, double distance) {
  if (std::isfinite(master.gap[node])) return master.gap[node];
  return distance < -master.handover_width ? master.handover_width : distance;
}

/// The gap along a segment: linear between its ends; on an edge that is closed at both its ends, less what the slave's
/// smooth surface stands out of it.
class SegmentGap {
 public:
  SegmentGap(const EdgeView& view, const Segment& segment, const Master& master)
      : slave_(view.slave), begin_(segment.begin.slave_s), end_(segment.end.slave_s) {
    const auto at = [&](const InterfaceNode& node) {
      const auto hit = hit_master(ray(slave_, node.slave_s), view.masters[segment.edge].edge);
      const double distance = hit ? hit->distance : view.range;
      return node.slave_node < 0 ? distance : gap_of_slave_node(master, slave_.edge.nodes[node.slave_node], distance);
    };
    first_ = at(segment.begin);
    last_ = at(segment.end);
    const auto closed = [&](int i) { return closure(master.gap[slave_.edge.nodes[i]], master.handover_width); };
    chord_ = closed(0) * closed(1);
  }
  double operator()(double s) const {
    const double along = (s - begin_) / (end_ - begin_);
    return first_ + along * (last_ - first_) - chord_ * std::max(0.0, bulge(slave_, s));
  }

 private:
  const RayEdge& slave_;
  double begin_, end_, first_, last_, chord_;
};

/// Ends of the parts of a segment: it is cut where the gap passes the ends of the hand-over, so that the closure is
/// smooth on each.
std::vector<double> cut_at_handover(const Segment& segment, const SegmentGap& gap, double width) {
  const double begin = segment.begin.slave_s, end = segment.end.slave_s;
  std::vector<double> ends{begin, end};
  for (const double level : {0.0, width}) {
    const auto excess = [&](double s) { return gap(s) - level; };
    const double first = excess(begin), last = excess(end);
    if ((first < 0 && last > 0) || (first > 0 && last < 0))
      ends.push_back(find_root(excess, begin, first, end, last));
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

/// Whether a part of an edge, `share` of its length, is as good as straight and evenly divided; it bends the less the
/// shorter it is.
bool is_even(const SurfaceEdge& edge, double share) {
  const Point off = share * (edge.x[2] - 0.5 * (edge.x[0] + edge.x[1]));
  return off.squaredNorm() < even * even * (edge.x[1] - edge.x[0]).squaredNorm();
}

/// Whether a part of a segment is as good as closed all along: to a fiftieth of the hand-over, where the closure changes
/// by less than 1e-4 and its integral needs no more points.
bool is_closed(const SegmentGap& gap, double begin, double end, double width) {
  const double small = 0.02 * width;
  return gap(begin) <= small && gap(end) <= small && gap(0.5 * (begin + end)) <= small;
}

/// A point of the interface: every field is the polynomial of its own edge, at the slave point and at the point it
/// sees.
core::InterfacePoint make_point(const SurfaceEdge& slave, const SurfaceEdge& master, double s, double seen_at,
                                const Eigen::VectorXd& pressure) {
  core::InterfacePoint point{};
  point.slave_nodes = slave.nodes;
  point.master_nodes = master.nodes;
  point.slave_shape = core::edge_shape(s);
  point.master_shape = core::edge_shape(seen_at);
  point.position = position(slave, s);
  for (int i = 0; i < 3; ++i) point.pressure += point.slave_shape[i] * pressure[slave.nodes[i]];
  point.pressure = std::max(point.pressure, 0.0);
  return point;
}

/// Gauss points of a segment where it is closed.
void add_points(const EdgeView& view, const Segment& segment, const Master& master, const Eigen::VectorXd& pressure,
                std::vector<core::InterfacePoint>& points) {
  const SurfaceEdge& slave = view.slave.edge;
  const SurfaceEdge& facing = view.masters[segment.edge].edge;
  const SegmentGap gap(view, segment, master);
  const auto ends = cut_at_handover(segment, gap, master.handover_width);
  const double share = segment.end.slave_s - segment.begin.slave_s;
  const int closed_points = is_even(slave, share) && is_even(facing, 1) ? even_points : bent_points;
  for (std::size_t part = 1; part < ends.size(); ++part) {
    const double begin = ends[part - 1], length = ends[part] - begin;
    const int count = is_closed(gap, begin, ends[part], master.handover_width) ? closed_points : handover_points;
    for (const auto& rule : core::edge_rule(count)) {
      const double s = begin + rule.s * length, distance = gap(s);
      const double closed = closure(distance, master.handover_width);
      const auto hit = closed > 0 ? hit_master(ray(view.slave, s), facing) : std::nullopt;
      if (!hit) continue;
      auto& point = points.emplace_back(make_point(slave, facing, s, hit->s, pressure));
      point.area = rule.weight * length * slope(slave, s).norm();
      point.gap = distance;
      point.closure = closed;
      point.law = master.law;
      point.master_body = master.surface.body;
    }
  }
}

}  // namespace

double closure(double gap, double width) {
  if (gap <= 0) return 1;
  if (!(gap < width)) return 0;
  const double u = gap / width;
  return 1 - u * u * u * (10 - 15 * u + 6 * u * u);
}

std::vector<core::InterfacePoint> build_interface(const Surface& slave, const Eigen::VectorXd& pressure,
                                                  const std::vector<Master>& masters, core::Geometry geometry) {
  const Target target = make_target(masters);
  std::vector<core::InterfacePoint> points;
  points.reserve(16 * slave.edges.size());
  for (const auto& edge : make_rays(slave)) {
    EdgeView view{edge, target.edges, {}, sight_range(edge.edge, masters)};
    target.tree.query(inflated(bounds(edge.edge), view.range), view.near);
    if (view.near.empty()) continue;
    for (const auto& segment : make_segments(view, interface_nodes(view)))
      add_points(view, segment, masters[target.edges[segment.edge].master], pressure, points);
  }
  for (auto& point : points) {
    point.slave_body = slave.body;
    point.area *= core::depth(geometry, point.position);
  }
  return points;
}

}  // namespace parison::contact
