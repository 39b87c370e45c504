// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/segments.hpp"

#include <algorithm>
#include <cmath>

namespace parison::contact {

namespace {

constexpr double opposing_cosine = -0.3;  ///< bodies face each other where their outward normals' product is below this
constexpr double coincident = 1e-12;      ///< nodes closer than this on an edge are one
constexpr double just_inside = 1e-6;      ///< of a segment's length: where its ends are looked at
constexpr int halvings = 50;

Index edge_seen(const EdgeView& view, double s) {
  const auto sight = see_master(view, s);
  return sight ? sight->edge : -1;
}

/// Where, between two points, the edge that is seen ceases to be the one seen from `begin`.
double end_of_sight(const EdgeView& view, double begin, double end, Index seen) {
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (begin + end);
    (edge_seen(view, middle) == seen ? begin : end) = middle;
  }
  return 0.5 * (begin + end);
}

}  // namespace

std::optional<Sight> see_master(const EdgeView& view, double s) {
  std::optional<Sight> nearest;
  const Point along = ray(view.slave, s);
  for (const Index m : view.near) {
    const SurfaceEdge& master = view.masters[m].edge;
    const auto hit = hit_master(view.slave, s, master);
    if (!hit || std::abs(hit->distance) > view.range) continue;
    if (along.dot(normal(master, hit->s)) >= opposing_cosine) continue;
    if (!nearest || std::abs(hit->distance) < std::abs(nearest->hit.distance)) nearest = Sight{m, *hit};
  }
  return nearest;
}

InterfaceNode node_from_slave(const EdgeView& view, int node) {
  const double s = node == 0 ? 0 : node == 1 ? 1 : 0.5;
  return {InterfaceNode::Origin::slave, s, see_master(view, s)};
}

std::optional<InterfaceNode> node_from_master(const EdgeView& view, Index edge, int end) {
  const Point& x = view.masters[edge].edge.x[end];
  const auto s = find_slave_parameter(view.slave, x);
  if (!s) return std::nullopt;
  const double distance = ray(view.slave, *s).dot(x - position(view.slave.edge, *s));
  return InterfaceNode{InterfaceNode::Origin::master, *s, Sight{edge, {double(end), distance}}};
}

std::vector<InterfaceNode> interface_nodes(const EdgeView& view) {
  std::vector<InterfaceNode> nodes;
  for (const int node : {0, 2, 1}) nodes.push_back(node_from_slave(view, node));
  for (const Index edge : view.near)
    for (const int end : {0, 1}) {
      const auto found = node_from_master(view, edge, end);
      const auto known = [&](const InterfaceNode& n) { return std::abs(n.slave_s - found->slave_s) < coincident; };
      if (found && std::abs(found->sight->hit.distance) <= view.range && std::none_of(nodes.begin(), nodes.end(), known))
        nodes.push_back(*found);
    }
  std::sort(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) { return a.slave_s < b.slave_s; });
  return nodes;
}

std::vector<Segment> make_segments(const EdgeView& view, const std::vector<InterfaceNode>& nodes) {
  std::vector<Segment> segments;
  const auto add = [&](double begin, double end, Index edge) {
    if (edge >= 0 && end > begin) segments.push_back({begin, end, edge});
  };
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const double begin = nodes[i - 1].slave_s, end = nodes[i].slave_s, inside = just_inside * (end - begin);
    const Index first = edge_seen(view, begin + inside), last = edge_seen(view, end - inside);
    if (first == last) {
      add(begin, end, first);
      continue;
    }
    const double cut = end_of_sight(view, begin + inside, end - inside, first);
    const Index after = edge_seen(view, cut + inside);
    add(begin, cut, first);
    if (after == last || cut + inside > end - inside) {
      add(cut, end, last);
      continue;
    }
    const double second = end_of_sight(view, cut + inside, end - inside, after);
    add(cut, second, after);
    add(second, end, last);
  }
  return segments;
}

}  // namespace parison::contact
