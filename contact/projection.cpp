// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/projection.hpp"

#include <algorithm>
#include <cmath>

#include "contact/root.hpp"

namespace parison::contact {

namespace {

constexpr double smooth_cosine = 0.5;   ///< ends whose normals differ by more than 60 degrees make a corner

/// Along the ray that leaves at s, of no certain length.
Point direction(const RayEdge& slave, double s) {
  const Point along = slope(slave.edge, s);
  return Point(along[1], -along[0]) + along.norm() * ((1 - s) * slave.first_turn + s * slave.last_turn);
}

/// Slope, against the edge, of a surface that is square to the turned normal at an end.
double rise(const SurfaceEdge& edge, double end, const Point& turn) {
  const Point along = slope(edge, end), out = normal(edge, end), upright = out + turn;
  return -upright.dot(along) / upright.dot(out);
}

void finish(RayEdge& slave) {
  slave.first = {slave.edge.x[0], direction(slave, 0).normalized()};
  slave.last = {slave.edge.x[1], direction(slave, 1).normalized()};
  slave.first_rise = rise(slave.edge, 0, slave.first_turn);
  slave.last_rise = rise(slave.edge, 1, slave.last_turn);
  if (slave.first_free) slave.first_rise = -slave.last_rise;
  if (slave.last_free) slave.last_rise = -slave.first_rise;
}

/// The root between 0 and 1 of the quadratic that is `first`, `mid` and `last` at 0, 1/2 and 1, its ends of opposite
/// signs.
double quadratic_root(double first, double mid, double last) {
  const double square = 2 * (first + last - 2 * mid), linear = last - first - square;
  const double slope = std::copysign(std::sqrt(std::max(linear * linear - 4 * square * first, 0.0)), last - first);
  const double t = linear * slope >= 0 ? -2 * first / (linear + slope) : (slope - linear) / (2 * square);
  return std::clamp(t, 0.0, 1.0);
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

Ray ray(const RayEdge& slave, double s) {
  if (s == 0) return slave.first;
  if (s == 1) return slave.last;
  return {position(slave.edge, s), direction(slave, s).normalized()};
}

double meeting_parameter(const Ray& ray, const SurfaceEdge& master, const Sides& sides) {
  const auto [first, last] = sides;
  if (first * last >= 0) return std::abs(first) < std::abs(last) ? 0 : 1;
  return quadratic_root(first, aside(ray, master.x[2]), last);
}

std::optional<double> find_slave_parameter(const RayEdge& slave, const Point& x) {
  const double first = aside(slave.first, x), last = aside(slave.last, x);
  if (!((first > 0 && last < 0) || (first < 0 && last > 0))) return std::nullopt;
  const auto beside = [&](double s) { return aside({position(slave.edge, s), direction(slave, s)}, x); };
  return find_root(beside, 0, beside(0), 1, beside(1));
}

}  // namespace parison::contact
