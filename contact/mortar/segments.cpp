// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/mortar/segments.hpp"

#include <algorithm>
#include <cmath>

namespace parison::contact {

namespace {

/// Surfaces face each other where the ray and the master's outward normal enclose an angle with a cosine below -0.3.
constexpr double opposing_cosine = 0.3;
constexpr double coincident = 1e-12;  ///< largest difference of the parameters of coincident nodes
constexpr double just_inside = 1e-6;  ///< distance from a segment's ends at which visibility is tested, in its lengths
constexpr int halvings = 50;          ///< of the bisection for the end of visibility
constexpr int max_cuts = 4;           ///< between two nodes; the remainder belongs to the edge visible at its end

bool faces(const Ray& from, const SurfaceEdge& master, const Hit& hit) {
  const Point along = derivative(master, hit.s);
  const double opposed =
      from.along[1] * along[0] - from.along[0] * along[1];  // to the outward normal, times its length
  return opposed > 0 && opposed * opposed > opposing_cosine * opposing_cosine * along.squaredNorm();
}

Index visible_edge(const EdgeView& view, double s) {
  const auto visible = find_visible_master(view, s);
  return visible ? visible->edge : -1;
}

/// The edge visible at the far end of an interval between neighbouring nodes. Where the ray at the near end meets a
/// single edge, that edge is tested first: no other one can appear before the next node.
Index visible_edge_at_end(const EdgeView& view, const std::optional<VisibleEdge>& near_end, double s) {
  if (!near_end || !near_end->alone) return visible_edge(view, s);
  const Ray from = ray(view.slave, s);
  const SurfaceEdge& master = view.masters[near_end->edge].edge;
  const auto hit = hit_master(from, master);
  const bool visible = hit && std::abs(hit->distance) <= view.range && faces(from, master, *hit);
  return visible ? near_end->edge : visible_edge(view, s);
}

/// Where, between two points, the visible edge changes from `visible`, the one at `begin`; by bisection.
double end_of_visibility(const EdgeView& view, double begin, double end, Index visible) {
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (begin + end);
    (visible_edge(view, middle) == visible ? begin : end) = middle;
  }
  return 0.5 * (begin + end);
}

}  // namespace

std::optional<VisibleEdge> find_visible_master(const EdgeView& view, double s) {
  std::optional<VisibleEdge> nearest;
  int met = 0;
  const Ray from = ray(view.slave, s);
  for (const Index m : view.near) {
    const SurfaceEdge& master = view.masters[m].edge;
    const auto hit = hit_master(from, master);
    if (!hit) continue;
    ++met;
    const double away = std::abs(hit->distance);
    if (away > view.range || (nearest && away >= std::abs(nearest->hit.distance))) continue;
    if (faces(from, master, *hit)) nearest = VisibleEdge{m, *hit, false};
  }
  if (nearest) nearest->alone = met == 1;
  return nearest;
}

InterfaceNode node_from_slave(int node) {
  return {node == 0 ? 0.0 : node == 1 ? 1.0 : 0.5, node};
}

std::optional<InterfaceNode> node_from_master(const EdgeView& view, const Point& node) {
  const auto s = find_slave_parameter(view.slave, node);
  if (!s || (node - position(view.slave.edge, *s)).norm() > view.range) return std::nullopt;
  return InterfaceNode{*s, -1};
}

void find_interface_nodes(const EdgeView& view, std::vector<InterfaceNode>& nodes) {
  nodes.clear();
  for (const int node : {0, 2, 1}) nodes.push_back(node_from_slave(node));
  const Point* before = nullptr;
  for (const Index edge : view.near)
    for (const int end : {0, 1}) {
      const Point& node = view.masters[edge].edge.x[end];
      const bool joined = before && *before == node;
      before = &node;
      if (joined) continue;
      const auto found = node_from_master(view, node);
      const auto known = [&](const InterfaceNode& n) { return std::abs(n.slave_s - found->slave_s) < coincident; };
      if (found && std::none_of(nodes.begin(), nodes.end(), known)) nodes.push_back(*found);
    }
  std::sort(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) { return a.slave_s < b.slave_s; });
}

void find_segments(const EdgeView& view, const std::vector<InterfaceNode>& nodes, std::vector<Segment>& segments) {
  segments.clear();
  const auto add = [&](const InterfaceNode& begin, const InterfaceNode& end, Index edge) {
    if (edge >= 0 && end.slave_s > begin.slave_s) segments.push_back({begin, end, edge});
  };
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const double inside = just_inside * (nodes[i].slave_s - nodes[i - 1].slave_s);
    const double last_s = nodes[i].slave_s - inside;
    InterfaceNode from = nodes[i - 1];
    const auto first = find_visible_master(view, from.slave_s + inside);
    const Index last = visible_edge_at_end(view, first, last_s);
    Index visible = first ? first->edge : -1;
    for (int cuts = 0; cuts < max_cuts && visible != last; ++cuts) {
      const double cut = end_of_visibility(view, from.slave_s + inside, last_s, visible);
      add(from, {cut, -1}, visible);
      from = {cut, -1};
      visible = cut + inside < last_s ? visible_edge(view, cut + inside) : last;
    }
    add(from, nodes[i], last);
  }
}

}  // namespace parison::contact
