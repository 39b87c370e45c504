#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "contact/mortar/surface.hpp"

namespace parison::contact {

/// Line along which a slave point is projected onto the masters.
struct Ray {
  Point from, along;  ///< m; unit vector
};

/// A slave edge with its field of projection directions: the outward normal plus a correction that is linear along the
/// edge and makes the direction at each end the mean of the normals of the two edges joined there (averaged nodal
/// normals: B. Yang, T. A. Laursen, X. Meng, Int. J. Numer. Meth. Engng 62 (2005) 1183-1225). The field is
/// continuous from edge to edge, so a slave point has one master point and a master node one slave point. At corners
/// sharper than 60 degrees each edge keeps its own normal.
struct RayEdge {
  SurfaceEdge edge;
  Point first_turn, last_turn;     ///< corrections added to the unit normals at the ends
  bool first_free, last_free;      ///< no edge is joined there
  Ray first, last;                 ///< from the ends
  double first_slope, last_slope;  ///< at the ends, of the smooth surface normal to the rays: its height over s, m
};

std::vector<RayEdge> make_rays(const Surface& slave);

/// Direction of the ray from s; not normalised.
inline Point direction(const RayEdge& slave, double s) {
  const Point along = derivative(slave.edge, s);
  return Point(along[1], -along[0]) + along.norm() * ((1 - s) * slave.first_turn + s * slave.last_turn);
}

/// The ray from s.
inline Ray ray(const RayEdge& slave, double s) {
  if (s == 0) return slave.first;
  if (s == 1) return slave.last;
  return {position(slave.edge, s), direction(slave, s).normalized()};
}

/// Height over the edge of the smooth surface that the edge approximates, m: the cubic Hermite polynomial through the
/// edge's ends that is normal to their rays; symmetric where one end is free. Positive where the surface is convex: the
/// sagitta of the chord.
inline double chord_offset(const RayEdge& slave, double s) {
  return s * (1 - s) * ((1 - s) * slave.first_slope - s * slave.last_slope);
}

/// Intersection of a ray with a master edge.
struct Hit {
  double s;         ///< parameter on the master edge, in [0, 1]
  double distance;  ///< along the ray, m; negative where the bodies overlap
};

/// The parameter s in (0, 1) of the slave edge whose ray passes through x, if there is one: the projection of a master
/// node onto the slave.
std::optional<double> find_slave_parameter(const RayEdge& slave, const Point& x);

/// Signed distance of a point from a ray's line, m; positive on the left.
inline double signed_offset(const Ray& ray, const Point& x) {
  const Point off = x - ray.from;
  return ray.along[0] * off[1] - ray.along[1] * off[0];
}

/// Signed distances of the ends of a master edge from a ray's line, m; positive on the left.
struct Sides {
  double first, last;
};
/// Whether a ray misses an edge: both ends lie on the same side of its line, and neither lies on the line.
inline bool passes_by(const Sides& sides, const SurfaceEdge& master) {
  constexpr double end_tolerance = 1e-9;  // a ray as close as this to the edge's end, in edge lengths, meets the edge
  if (!(sides.first * sides.last > 0)) return false;
  const double nearest = std::min(std::abs(sides.first), std::abs(sides.last));
  return nearest * nearest > end_tolerance * end_tolerance * (master.x[1] - master.x[0]).squaredNorm();
}
/// The root in [0, 1] of the quadratic with values `first`, `mid` and `last` at 0, 1/2 and 1, where `first` and `last`
/// have opposite signs. Of the two forms of the root the one without cancellation is taken.
inline double quadratic_root(double first, double mid, double last) {
  const double square = 2 * (first + last - 2 * mid), linear = last - first - square;
  const double root_derivative =
      std::copysign(std::sqrt(std::max(linear * linear - 4 * square * first, 0.0)), last - first);
  const double t = linear * root_derivative >= 0 ? -2 * first / (linear + root_derivative)
                                                 : (root_derivative - linear) / (2 * square);
  return std::clamp(t, 0.0, 1.0);
}

/// The parameter at which a ray meets an edge that it does not miss.
inline double meeting_parameter(const Ray& ray, const SurfaceEdge& master, const Sides& sides) {
  const auto [first, last] = sides;
  if (first * last >= 0) return std::abs(first) < std::abs(last) ? 0 : 1;
  return quadratic_root(first, signed_offset(ray, master.x[2]), last);
}

/// The parameter on the master edge at which a ray meets it; none where the ray misses it.
inline std::optional<double> find_master_parameter(const Ray& ray, const SurfaceEdge& master) {
  const Sides sides{signed_offset(ray, master.x[0]), signed_offset(ray, master.x[1])};
  if (passes_by(sides, master)) return std::nullopt;
  return meeting_parameter(ray, master, sides);
}
/// The same, with the distance along the ray.
inline std::optional<Hit> hit_master(const Ray& ray, const SurfaceEdge& master) {
  const auto s = find_master_parameter(ray, master);
  if (!s) return std::nullopt;
  return Hit{*s, ray.along.dot(position(master, *s) - ray.from)};
}

}  // namespace parison::contact
