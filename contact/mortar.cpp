// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/mortar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "contact/box_tree.hpp"
#include "contact/projection.hpp"
#include "contact/root.hpp"
#include "core/element.hpp"

namespace parison::contact {

namespace {

constexpr double opposing_cosine = -0.3;  ///< bodies face each other where their outward normals' product is below this
constexpr double smallest_segment = 1e-14;
constexpr int gauss_points = 5;  ///< exact to degree 9: two quadratic fields, the measure and the radius

/// A slave edge, the master edges near it, and its nodes' state (first, last, mid).
struct Facing {
  const RayEdge& slave;
  const std::vector<SurfaceEdge>& masters;
  std::vector<Index> near;
  double range;  ///< how far a master may lie along a ray, m
  std::array<double, 3> gap, pressure;
};

struct MasterHit {
  Index master;
  Hit hit;
};

/// Stretch of a slave edge between consecutive interface nodes, all of it facing one master edge.
struct Segment {
  double begin, end;
  Index master;
};

/// Box around a quadratic edge: the hull of its Bezier points.
Box bounds(const SurfaceEdge& edge) {
  const Point control = 2 * edge.x[2] - 0.5 * (edge.x[0] + edge.x[1]);
  return {edge.x[0].cwiseMin(edge.x[1]).cwiseMin(control), edge.x[0].cwiseMax(edge.x[1]).cwiseMax(control)};
}

/// The nearest master edge that the slave point sees and that looks back at it.
std::optional<MasterHit> see_master(const Facing& facing, double s) {
  std::optional<MasterHit> nearest;
  const Point along = ray(facing.slave, s);
  for (const Index m : facing.near) {
    const auto hit = hit_master(facing.slave, s, facing.masters[m]);
    if (!hit || std::abs(hit->distance) > facing.range) continue;
    if (along.dot(normal(facing.masters[m], hit->s)) >= opposing_cosine) continue;
    if (!nearest || std::abs(hit->distance) < std::abs(nearest->hit.distance)) nearest = MasterHit{m, *hit};
  }
  return nearest;
}

/// Interface nodes on the slave edge: its own three, and the projections of the master's.
std::vector<double> interface_nodes(const Facing& facing) {
  std::vector<double> nodes{0, 0.5, 1};
  for (const Index m : facing.near)
    for (const int end : {0, 1})
      if (const auto s = find_slave_parameter(facing.slave, facing.masters[m].x[end])) nodes.push_back(*s);
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// Gap along half a slave edge: linear between two nodes within reach; otherwise the distance between the meshes,
/// shifted to agree with the node that is within reach.
class HalfGap {
 public:
  HalfGap(const Facing& facing, bool second)
      : facing_(facing), second_(second), outer_(facing.gap[second ? 1 : 0]), mid_(facing.gap[2]) {
    exact_ = std::isfinite(outer_) && std::isfinite(mid_);
    if (exact_ || (!std::isfinite(outer_) && !std::isfinite(mid_))) return;
    const double node = std::isfinite(mid_) ? 0.5 : second ? 1.0 : 0.0;
    if (const auto seen = see_master(facing, node)) shift_ = (std::isfinite(mid_) ? mid_ : outer_) - seen->hit.distance;
  }

  double operator()(double s, Index master) const {
    const double to_mid = second_ ? 2 * (1 - s) : 2 * s;
    if (exact_) return outer_ + to_mid * (mid_ - outer_);
    const auto hit = hit_master(facing_.slave, s, facing_.masters[master]);
    return hit ? hit->distance + shift_ : std::numeric_limits<double>::infinity();
  }

  bool open(double width) const { return exact_ && outer_ >= width && mid_ >= width; }

 private:
  const Facing& facing_;
  bool second_;
  double outer_, mid_, shift_ = 0;
  bool exact_;
};

/// Cuts a segment where the gap passes the ends of the hand-over, so that the closure is smooth on each part.
std::vector<Segment> cut_at_handover(const Segment& segment, const HalfGap& gap, double width) {
  std::vector<double> ends{segment.begin, segment.end};
  for (const double level : {0.0, width}) {
    const auto excess = [&](double s) { return gap(s, segment.master) - level; };
    const double first = excess(segment.begin), last = excess(segment.end);
    const bool crosses = (first < 0 && last > 0) || (first > 0 && last < 0);
    if (crosses && std::isfinite(first) && std::isfinite(last))
      ends.push_back(find_root(excess, segment.begin, first, segment.end, last));
  }
  std::sort(ends.begin(), ends.end());
  std::vector<Segment> parts;
  for (std::size_t i = 1; i < ends.size(); ++i) parts.push_back({ends[i - 1], ends[i], segment.master});
  return parts;
}

/// Segments of half a slave edge.
std::vector<Segment> make_segments(const Facing& facing, const std::vector<double>& nodes, bool second) {
  std::vector<Segment> segments;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const double middle = 0.5 * (nodes[i - 1] + nodes[i]);
    if ((middle > 0.5) != second || nodes[i] - nodes[i - 1] < smallest_segment) continue;
    if (const auto seen = see_master(facing, middle)) segments.push_back({nodes[i - 1], nodes[i], seen->master});
  }
  return segments;
}

/// Gauss points of a segment: every field is the polynomial of its own edge, at the slave point and at the point it
/// sees.
void add_points(const Facing& facing, const Segment& segment, const HalfGap& gap, const InterfaceOptions& options,
                std::vector<core::InterfacePoint>& points) {
  const SurfaceEdge& slave = facing.slave.edge;
  const SurfaceEdge& master = facing.masters[segment.master];
  for (const auto& rule : core::edge_rule(gauss_points)) {
    const double s = segment.begin + rule.s * (segment.end - segment.begin);
    const auto hit = hit_master(facing.slave, s, master);
    if (!hit) continue;
    core::InterfacePoint point{};
    point.gap = gap(s, segment.master);
    point.closure = closure(point.gap, options.handover_width);
    if (point.closure == 0) continue;
    point.slave_nodes = slave.nodes;
    point.master_nodes = master.nodes;
    point.slave_shape = core::edge_shape(s);
    point.master_shape = core::edge_shape(hit->s);
    point.position = position(slave, s);
    point.area = rule.weight * (segment.end - segment.begin) * slope(slave, s).norm() *
                 core::depth(options.geometry, point.position);
    for (int i = 0; i < 3; ++i) point.pressure += point.slave_shape[i] * facing.pressure[i];
    point.pressure = std::max(point.pressure, 0.0);
    point.law = options.law;
    points.push_back(point);
  }
}

/// State of an edge's nodes, and how far away its masters are looked for: the hand-over, the deepest overlap, and half
/// an edge for what chords cut off curves.
Facing make_facing(const RayEdge& slave, const Surface& master, const SlaveState& state, double width) {
  Facing facing{slave, master.edges, {}, width, {}, {}};
  for (int i = 0; i < 3; ++i) {
    facing.gap[i] = state.gap[slave.edge.nodes[i]];
    facing.pressure[i] = state.pressure[slave.edge.nodes[i]];
    facing.range = std::max(facing.range, -facing.gap[i]);
  }
  facing.range += 0.5 * (slave.edge.x[1] - slave.edge.x[0]).norm();
  return facing;
}

}  // namespace

double closure(double gap, double width) {
  if (gap <= 0) return 1;
  if (!(gap < width)) return 0;
  const double u = gap / width;
  return 1 - u * u * u * (10 - 15 * u + 6 * u * u);
}

std::vector<core::InterfacePoint> build_interface(const Surface& slave, const Surface& master, const SlaveState& state,
                                                  const InterfaceOptions& options) {
  std::vector<Box> boxes;
  for (const auto& edge : master.edges) boxes.push_back(bounds(edge));
  const BoxTree tree(std::move(boxes));

  std::vector<core::InterfacePoint> points;
  for (const auto& edge : make_rays(slave)) {
    Facing facing = make_facing(edge, master, state, options.handover_width);
    if (std::none_of(facing.gap.begin(), facing.gap.end(), [](double g) { return std::isfinite(g); })) continue;
    tree.query(inflated(bounds(edge.edge), facing.range), facing.near);
    if (facing.near.empty()) continue;
    const auto nodes = interface_nodes(facing);
    for (const bool second : {false, true}) {
      const HalfGap gap(facing, second);
      if (gap.open(options.handover_width)) continue;
      for (const auto& segment : make_segments(facing, nodes, second))
        for (const auto& part : cut_at_handover(segment, gap, options.handover_width))
          add_points(facing, part, gap, options, points);
    }
  }
  for (auto& point : points) {
    point.slave_body = slave.body;
    point.master_body = master.body;
  }
  return points;
}

}  // namespace parison::contact
