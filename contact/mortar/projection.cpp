// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/mortar/projection.hpp"

#include <algorithm>

#include "contact/mortar/root.hpp"

namespace parison::contact {

namespace {

constexpr double smooth_cosine = 0.5;  ///< edges whose normals differ by more than 60 degrees meet in a corner

/// Derivative with respect to s of the height over the edge, m, of a surface that is normal to the ray at an end.
double end_slope(const SurfaceEdge& edge, double end, const Point& turn) {
  const Point along = derivative(edge, end), out = normal(edge, end), upright = out + turn;
  return -upright.dot(along) / upright.dot(out);
}

void finish(RayEdge& slave) {
  slave.first = {slave.edge.x[0], direction(slave, 0).normalized()};
  slave.last = {slave.edge.x[1], direction(slave, 1).normalized()};
  slave.first_slope = end_slope(slave.edge, 0, slave.first_turn);
  slave.last_slope = end_slope(slave.edge, 1, slave.last_turn);
  if (slave.first_free) slave.first_slope = -slave.last_slope;
  if (slave.last_free) slave.last_slope = -slave.first_slope;
}

}  // namespace

std::vector<RayEdge> make_rays(const Surface& slave) {
  std::vector<RayEdge> rays;
  rays.reserve(slave.edges.size());
  const Ray none{Point::Zero(), Point::Zero()};
  Index last_node = -1;
  for (const auto& edge : slave.edges) last_node = std::max({last_node, edge.nodes[0], edge.nodes[1]});
  std::vector<Index> starting_at(last_node + 1, -1);
  for (const auto& edge : slave.edges) {
    starting_at[edge.nodes[0]] = static_cast<Index>(rays.size());
    rays.push_back({edge, Point::Zero(), Point::Zero(), true, true, none, none, 0, 0});
  }
  for (auto& before : rays) {
    const Index next = starting_at[before.edge.nodes[1]];
    if (next < 0) continue;
    auto& after = rays[next];
    before.last_free = after.first_free = false;
    const Point left = normal(before.edge, 1), right = normal(after.edge, 0);
    if (left.dot(right) < smooth_cosine) continue;
    const Point mean = (left + right).normalized();
    before.last_turn = mean - left;
    after.first_turn = mean - right;
  }
  for (auto& edge : rays) finish(edge);
  return rays;
}

std::optional<double> find_slave_parameter(const RayEdge& slave, const Point& x) {
  const double first = signed_offset(slave.first, x), last = signed_offset(slave.last, x);
  if (!((first > 0 && last < 0) || (first < 0 && last > 0))) return std::nullopt;
  const auto offset = [&](double s) { return signed_offset({position(slave.edge, s), direction(slave, s)}, x); };
  return find_root(offset, 0, offset(0), 1, offset(1));
}

}  // namespace parison::contact
