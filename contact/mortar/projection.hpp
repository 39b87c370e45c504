#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "contact/mortar/surface.hpp"

namespace parison::contact {

/// Where a slave point looks.
struct Ray {
  Point from, along;  ///< along: unit
};

/// Slave edge with the rays along which it faces a master. The rays leave along the outward normal, turned a little so
/// that they are continuous from edge to edge: neighbouring rays neither cross nor part, so every slave point faces one
/// master point and every master node one slave point. At corners sharper than 60 degrees each edge keeps its own
/// normal.
struct RayEdge {
  SurfaceEdge edge;
  Point first_turn, last_turn;     ///< what the ends' rays add to the normal
  bool first_free, last_free;      ///< no edge is joined there
  Ray first, last;                 ///< from the ends
  double first_slope, last_slope;  ///< slope against the edge of the smooth surface that the rays stand on, m
};

std::vector<RayEdge> make_rays(const Surface& slave);

/// Along the ray that leaves at s, of no certain length.
inline Point direction(const RayEdge& slave, double s) {
  const Point along = derivative(slave.edge, s);
  return Point(along[1], -along[0]) + along.norm() * ((1 - s) * slave.first_turn + s * slave.last_turn);
}

/// The ray that leaves at s.
inline Ray ray(const RayEdge& slave, double s) {
  if (s == 0) return slave.first;
  if (s == 1) return slave.last;
  return {position(slave.edge, s), direction(slave, s).normalized()};
}

/// How far the smooth surface that the rays stand on lies outside the edge, m: the cubic through the edge's ends,
/// square to their rays, and symmetric where one end is free. A chord of a convex arc gets back what it cuts off;
/// negative where the surface is hollow.
inline double chord_offset(const RayEdge& slave, double s) {
  return s * (1 - s) * ((1 - s) * slave.first_slope - s * slave.last_slope);
}

/// Where the ray from a slave point meets a master edge.
struct Hit {
  double s;         ///< on the master edge, [0, 1]
  double distance;  ///< along the ray, m; negative where the bodies overlap
};

/// A node of the master seen on the slave: the s in (0, 1) whose ray passes through x, if any.
std::optional<double> find_slave_parameter(const RayEdge& slave, const Point& x);

/// How far a point lies to the left of a ray's line, m.
inline double signed_offset(const Ray& ray, const Point& x) {
  const Point off = x - ray.from;
  return ray.along[0] * off[1] - ray.along[1] * off[0];
}

/// How far the ends of a master edge lie to the left of a ray's line, m.
struct Sides {
  double first, last;
};
/// Whether both ends lie on one side of the line, neither at it.
inline bool passes_by(const Sides& sides, const SurfaceEdge& master) {
  constexpr double end_tolerance = 1e-9;  // a ray this close to the edge's end, in edge lengths, meets it
  if (!(sides.first * sides.last > 0)) return false;
  const double nearest = std::min(std::abs(sides.first), std::abs(sides.last));
  return nearest * nearest > end_tolerance * end_tolerance * (master.x[1] - master.x[0]).squaredNorm();
}
/// The root between 0 and 1 of the quadratic that is `first`, `mid` and `last` at 0, 1/2 and 1, its ends of opposite
/// signs.
inline double quadratic_root(double first, double mid, double last) {
  const double square = 2 * (first + last - 2 * mid), linear = last - first - square;
  const double root_derivative =
      std::copysign(std::sqrt(std::max(linear * linear - 4 * square * first, 0.0)), last - first);
  const double t = linear * root_derivative >= 0 ? -2 * first / (linear + root_derivative)
                                                 : (root_derivative - linear) / (2 * square);
  return std::clamp(t, 0.0, 1.0);
}

/// The s at which a ray meets an edge that it does not pass by.
inline double meeting_parameter(const Ray& ray, const SurfaceEdge& master, const Sides& sides) {
  const auto [first, last] = sides;
  if (first * last >= 0) return std::abs(first) < std::abs(last) ? 0 : 1;
  return quadratic_root(first, signed_offset(ray, master.x[2]), last);
}

/// The s of the point of the master that a point of the slave sees: none when its ray passes the edge by.
inline std::optional<double> find_master_parameter(const Ray& ray, const SurfaceEdge& master) {
  const Sides sides{signed_offset(ray, master.x[0]), signed_offset(ray, master.x[1])};
  if (passes_by(sides, master)) return std::nullopt;
  return meeting_parameter(ray, master, sides);
}
/// The same with the distance.
inline std::optional<Hit> hit_master(const Ray& ray, const SurfaceEdge& master) {
  const auto s = find_master_parameter(ray, master);
  if (!s) return std::nullopt;
  return Hit{*s, ray.along.dot(position(master, *s) - ray.from)};
}

}  // namespace parison::contact
