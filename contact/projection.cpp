// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/projection.hpp"

#include <cmath>
#include <unordered_map>

#include "contact/root.hpp"

namespace parison::contact {

namespace {

constexpr double smooth_cosine = 0.5;   ///< ends whose normals differ by more than 60 degrees make a corner
constexpr double end_tolerance = 1e-9;  ///< a ray this close to a master edge's end, in edge lengths, meets it

double cross(const Point& a, const Point& b) {
  return a[0] * b[1] - a[1] * b[0];
}

}  // namespace

std::vector<RayEdge> make_rays(const Surface& slave) {
  std::vector<RayEdge> rays;
  std::unordered_map<Index, std::size_t> starting_at;
  for (const auto& edge : slave.edges) {
    starting_at[edge.nodes[0]] = rays.size();
    rays.push_back({edge, Point::Zero(), Point::Zero(), true, true});
  }
  for (auto& before : rays) {
    const auto next = starting_at.find(before.edge.nodes[1]);
    if (next == starting_at.end()) continue;
    auto& after = rays[next->second];
    before.last_free = after.first_free = false;
    const Point left = normal(before.edge, 1), right = normal(after.edge, 0);
    if (left.dot(right) < smooth_cosine) continue;
    const Point mean = (left + right).normalized();
    before.last_turn = mean - left;
    after.first_turn = mean - right;
  }
  return rays;
}

Point ray(const RayEdge& slave, double s) {
  return (normal(slave.edge, s) + (1 - s) * slave.first_turn + s * slave.last_turn).normalized();
}

double bulge(const RayEdge& slave, double s) {
  const auto rise = [&](double end, const Point& turn) {
    const Point along = slope(slave.edge, end), out = normal(slave.edge, end), upright = out + turn;
    return -upright.dot(along) / upright.dot(out);
  };
  double first = rise(0, slave.first_turn), last = rise(1, slave.last_turn);
  if (slave.first_free) first = -last;
  if (slave.last_free) last = -first;
  return s * (1 - s) * ((1 - s) * first - s * last);
}

std::optional<Hit> hit_master(const RayEdge& slave, double s, const SurfaceEdge& master) {
  const Point from = position(slave.edge, s), along = ray(slave, s);
  const auto aside = [&](double t) { return cross(along, position(master, t) - from); };
  const double first = aside(0), last = aside(1);
  double t;
  if ((first > 0) == (last > 0) && first != 0 && last != 0) {
    t = std::abs(first) < std::abs(last) ? 0 : 1;
    if (std::abs(t == 0 ? first : last) > end_tolerance * (master.x[1] - master.x[0]).norm()) return std::nullopt;
  } else {
    t = find_root(aside, 0, first, 1, last);
  }
  return Hit{t, along.dot(position(master, t) - from)};
}

std::optional<double> find_slave_parameter(const RayEdge& slave, const Point& x) {
  const auto aside = [&](double s) { return cross(ray(slave, s), x - position(slave.edge, s)); };
  const double first = aside(0), last = aside(1);
  if (!((first > 0 && last < 0) || (first < 0 && last > 0))) return std::nullopt;
  return find_root(aside, 0, first, 1, last);
}

}  // namespace parison::contact
