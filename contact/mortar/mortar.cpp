// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/mortar/mortar.hpp"

#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <utility>

#include "contact/box.hpp"
#include "contact/mortar/contact_end.hpp"
#include "contact/mortar/segment_gap.hpp"
#include "core/mesh/element.hpp"

namespace parison::contact {

namespace {

/// Gauss points of a part of a segment. In contact 3 points, exact to degree 5: two quadratic fields times the radius.
/// Where an edge is curved or its mid-side node is off the middle 4 points, exact to degree 7. Across the transition 5,
/// for the contact weight.
constexpr int affine_points = 3, curved_points = 4, transition_points = 5;
/// Largest distance of an affine edge's mid-side node from the middle of its chord, in chord lengths.
constexpr double affine_tolerance = 0.005;
/// Of a segment whose gap is not linear: with 5, an edge of 2 mm on a radius of 1 mm has gaps to 0.5 um.
constexpr int max_halvings = 5;

using BoostPoint = boost::geometry::model::point<double, core::dim, boost::geometry::cs::cartesian>;
using BoostBox = boost::geometry::model::box<BoostPoint>;
using IndexedBox = std::pair<BoostBox, Index>;
using BoxTree = boost::geometry::index::rtree<IndexedBox, boost::geometry::index::quadratic<8>>;

BoostBox boost_box(const Box& box) {
  return {{box.low[0], box.low[1]}, {box.high[0], box.high[1]}};
}

/// The edges of all masters in one list, and an R-tree of their bounding boxes.
struct Target {
  std::vector<MasterEdge> edges;
  BoxTree tree;

  /// Replaces `near` by the edges whose bounding boxes overlap `box`, in increasing order.
  void query(const Box& box, std::vector<Index>& near) const {
    near.clear();
    tree.query(boost::geometry::index::intersects(boost_box(box)),
               boost::make_function_output_iterator([&](const IndexedBox& found) { near.push_back(found.second); }));
    std::sort(near.begin(), near.end());
  }
};

/// Box around the Bezier control points of a quadratic edge; their convex hull contains it.
Box bounds(const SurfaceEdge& edge) {
  const Point control = 2 * edge.x[2] - 0.5 * (edge.x[0] + edge.x[1]);
  return {edge.x[0].cwiseMin(edge.x[1]).cwiseMin(control), edge.x[0].cwiseMax(edge.x[1]).cwiseMax(control)};
}

Target make_target(const std::vector<Master>& masters) {
  std::vector<MasterEdge> edges;
  std::vector<IndexedBox> boxes;
  std::size_t count = 0;
  for (const Master& master : masters) count += master.surface.edges.size();
  edges.reserve(count);
  boxes.reserve(count);
  for (std::size_t m = 0; m < masters.size(); ++m)
    for (const auto& edge : masters[m].surface.edges) {
      edges.push_back({edge, static_cast<Index>(m)});
      boxes.emplace_back(boost_box(bounds(edge)), static_cast<Index>(boxes.size()));
    }
  return {std::move(edges), BoxTree(boxes)};
}

/// Distance within which masters of an edge are searched, m: the transition gap, the deepest penetration, and half the
/// edge's length for the sagitta of curved surfaces.
double search_range(const SurfaceEdge& slave, const std::vector<Master>& masters) {
  double range = 0;
  for (const Master& master : masters) {
    range = std::max(range, master.transition_gap);
    for (const Index node : slave.nodes) range = std::max(range, master.transition_gap - master.gap[node]);
  }
  return range + 0.5 * (slave.x[1] - slave.x[0]).norm();
}

/// Whether a part of an edge, `fraction` of its length, is straight with its mid-side node in the middle, to
/// `affine_tolerance`. The offset relative to the part's length falls with the fraction.
bool is_affine(const SurfaceEdge& edge, double fraction) {
  const Point off = fraction * (edge.x[2] - 0.5 * (edge.x[0] + edge.x[1]));
  return off.squaredNorm() < affine_tolerance * affine_tolerance * (edge.x[1] - edge.x[0]).squaredNorm();
}

/// Consecutive segments of a slave edge with the same master edge and the same contact status; an open segment is a
/// group of its own. All fields but the gap are smooth over a group, so it is integrated as one.
struct SegmentGroup {
  Index edge;  ///< into EdgeView::masters
  ContactStatus status;
  std::size_t first, last;  ///< range of EdgeParts::gaps
};

/// What a slave edge is divided into. One object serves all edges, to reuse its memory.
struct EdgeParts {
  std::vector<InterfaceNode> nodes;
  std::vector<Segment> segments;
  std::vector<SegmentGap> gaps;  ///< of the segments
  std::vector<SegmentGroup> segment_groups;
};

/// Adds the gap of a segment; of its halves where it is not linear.
void add_gaps(const EdgeView& view, const Segment& segment, const Master& master, int halvings,
              std::vector<SegmentGap>& gaps) {
  const SegmentGap gap(view, segment, master);
  if (halvings == 0 || is_linear(view, gap, master)) {
    gaps.push_back(gap);
    return;
  }
  const InterfaceNode middle{0.5 * (gap.begin() + gap.end()), -1};
  add_gaps(view, {segment.begin, middle, segment.edge}, master, halvings - 1, gaps);
  add_gaps(view, {middle, segment.end, segment.edge}, master, halvings - 1, gaps);
}

/// The same on an edge on which a contact ends: two where the segment contains that end.
void add_gaps(const EdgeView& view, const Segment& segment, const ContactEnd& end, std::vector<SegmentGap>& gaps) {
  constexpr double apart = 1e-6;  // of the edge, from a segment's ends
  const InterfaceNode cut{end.end, -1};
  if (cut.slave_s < segment.begin.slave_s + apart || cut.slave_s > segment.end.slave_s - apart) {
    gaps.emplace_back(view, segment, end);
    return;
  }
  gaps.emplace_back(view, Segment{segment.begin, cut, segment.edge}, end);
  gaps.emplace_back(view, Segment{cut, segment.end, segment.edge}, end);
}

/// `ends`: of the contacts with each master.
void divide(const EdgeView& view, const std::vector<Master>& masters,
            const std::vector<std::optional<ContactEnd>>& ends, EdgeParts& parts) {
  find_interface_nodes(view, parts.nodes);
  find_segments(view, parts.nodes, parts.segments);
  parts.gaps.clear();
  parts.segment_groups.clear();
  for (const Segment& segment : parts.segments) {
    const Master& master = masters[view.masters[segment.edge].master];
    std::size_t at = parts.gaps.size();
    const auto& end = ends[view.masters[segment.edge].master];
    if (end)
      add_gaps(view, segment, *end, parts.gaps);
    else
      add_gaps(view, segment, master, max_halvings, parts.gaps);
    for (; at < parts.gaps.size(); ++at) {
      const SegmentGap& gap = parts.gaps[at];
      const ContactStatus status = contact_status(gap, master.transition_gap);
      const bool goes_on = status != ContactStatus::open && at > 0 && parts.segment_groups.back().status == status &&
                           parts.segment_groups.back().edge == segment.edge && parts.gaps[at - 1].end() == gap.begin();
      if (!goes_on) parts.segment_groups.push_back({segment.edge, status, at, at});
      parts.segment_groups.back().last = at + 1;
    }
  }
}

/// Sets the shape functions and the pressure of an interface point: each field is interpolated on its own edge, the
/// slave's at s and the master's at master_s.
void set_point(const SurfaceEdge& slave, const SurfaceEdge& master, double s, double master_s,
               const Eigen::VectorXd& pressure, core::InterfacePoint& point) {
  point.slave_nodes = slave.nodes;
  point.master_nodes = master.nodes;
  point.slave_shape = core::edge_shape(s);
  point.master_shape = core::edge_shape(master_s);
  double interpolated = 0;
  for (int i = 0; i < 3; ++i) interpolated += point.slave_shape[i] * pressure[slave.nodes[i]];
  point.pressure = std::max(interpolated, 0.0);
}

/// A slave edge, its segments' gaps and the list to which its interface points are added.
struct Edge {
  const EdgeView& view;
  const std::vector<SegmentGap>& gaps;
  Index slave_body;
  const Eigen::VectorXd& pressure;
  std::vector<core::InterfacePoint>& points;
};

/// Divides a group of segments where the contact weight changes its law, and at the front of a contact, where the
/// pressure falls to zero within the edge.
Parts parts_of(const Edge& edge, const SegmentGroup& group, const Master& master) {
  const SegmentGap &first = edge.gaps[group.first], &last = edge.gaps[group.last - 1];
  Parts parts = group.status != ContactStatus::open ? Parts{{first.begin(), last.end()}, 2}
                                                    : cut_at_transition(first, master.transition_gap);
  std::array<double, 3> pressure{};
  for (int i = 0; i < 3; ++i) pressure[i] = edge.pressure[edge.view.slave.edge.nodes[i]];
  const auto [low, high] = std::minmax_element(pressure.begin(), pressure.end());
  if (*low <= 0 && *high > 0) cut_at_zeros(pressure, parts);
  return parts;
}

/// Adds the Gauss points of a group of segments, except where the contact weight is zero.
void add_points(const Edge& edge, const SegmentGroup& group, const Master& master) {
  const SurfaceEdge& slave = edge.view.slave.edge;
  const SurfaceEdge& facing = edge.view.masters[group.edge].edge;
  const SegmentGap *gap_at = &edge.gaps[group.first], *last_gap = &edge.gaps[group.last - 1];
  const double fraction = last_gap->end() - gap_at->begin();
  const int contact_points = is_affine(slave, fraction) && is_affine(facing, 1) ? affine_points : curved_points;
  const Parts parts = parts_of(edge, group, master);
  for (int part = 1; part < parts.count; ++part) {
    const double begin = parts.end[part - 1], length = parts.end[part] - begin;
    const bool in_contact =
        group.status != ContactStatus::open || is_in_contact(*gap_at, begin, parts.end[part], master.transition_gap);
    for (const auto& rule : core::edge_rule(in_contact ? contact_points : transition_points)) {
      const double s = begin + rule.s * length;
      while (gap_at != last_gap && s > gap_at->end()) ++gap_at;
      const double gap = (*gap_at)(s), weight = contact_weight(gap, master.transition_gap);
      if (!(weight > 0)) continue;
      const Ray from = ray(edge.view.slave, s);
      const auto master_s = find_master_parameter(from, facing);
      if (!master_s) continue;
      core::InterfacePoint& point = edge.points.emplace_back();
      set_point(slave, facing, s, *master_s, edge.pressure, point);
      point.position = from.from;
      point.area = rule.weight * length * derivative(slave, s).norm();
      point.gap = gap;
      point.contact_weight = weight;
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
  const ContactEndFinder find_ends(slave);
  std::vector<std::optional<ContactEnd>> ends(masters.size());
  const auto rays = make_rays(slave);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const RayEdge& edge = rays[i];
    const double range = search_range(edge.edge, masters);
    target.query(inflated(bounds(edge.edge), range), near);
    if (near.empty()) continue;
    const EdgeView view{edge, target.edges, near, range};
    for (std::size_t m = 0; m < masters.size(); ++m) ends[m] = find_ends(i, masters[m]);
    divide(view, masters, ends, parts);
    for (const SegmentGroup& group : parts.segment_groups)
      add_points({view, parts.gaps, slave.body, pressure, points}, group, masters[target.edges[group.edge].master]);
  }
  for (auto& point : points) point.area *= core::depth(geometry, point.position);
  return points;
}

}  // namespace parison::contact
