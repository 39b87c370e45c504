// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "forming/scene/container/crossings.hpp"
#include "forming/scene/container/free_space.hpp"

namespace parison::forming {
namespace {

constexpr double facing = 1e-9;  // least cosine between a normal and the motion

bool is_inside(const Solid& solid, const core::Point& x) {
  return core::contains(*solid.profile, x - solid.shift * core::axis_direction());
}

/// Some 500 places of the contact boundaries that look along the motion, ends of segments included.
std::vector<core::Point> front_of(const Solid& moved, double sense) {
  double whole = 0;
  for (const core::Segment& segment : moved.profile->segments)
    if (moved.contact[segment.boundary_id]) whole += core::length(segment);
  std::vector<core::Point> front;
  for (const core::Segment& segment : moved.profile->segments) {
    if (!moved.contact[segment.boundary_id] || !(whole > 0)) continue;
    const int count = 1 + static_cast<int>(500 * core::length(segment) / whole);
    for (int i = 0; i <= count; ++i) {
      const double t = double(i) / count;
      if (core::normal_at(segment, t)[1] * sense > facing)
        front.push_back(core::point_at(segment, t) + moved.shift * core::axis_direction());
    }
  }
  return front;
}

/// Distance from x along the axis to the contact boundaries of a solid that look back at it; infinite without any.
double distance_ahead(const Solid& solid, const core::Point& x, double sense, double touching) {
  double nearest = HUGE_VAL;
  std::vector<Crossing> crossings;
  for (const core::Segment& segment : solid.profile->segments) {
    if (!solid.contact[segment.boundary_id]) continue;
    crossings.clear();
    add_crossings_along(segment, std::max(x[0], touching), true, crossings);
    for (const Crossing& crossing : crossings) {
      const core::Point at(x[0], crossing.at);
      const double ahead = sense * (crossing.at + solid.shift - x[1]);
      if (ahead >= -touching && core::normal_at(segment, core::closest_parameter(segment, at))[1] * sense < -facing)
        nearest = std::min(nearest, std::max(ahead, 0.0));
    }
  }
  return nearest;
}

}  // namespace

std::optional<Travel> free_travel(const Solid& moved, const std::vector<Solid>& others, double sense) {
  constexpr double touching = 1e-9;  // m; takes round-off, and what meets only on the axis
  constexpr std::size_t most_work = 20'000'000;
  const std::vector<core::Point> front = front_of(moved, sense);
  std::size_t segments = 0;
  for (const Solid& solid : others) segments += solid.profile->segments.size();
  if (front.size() * segments > most_work) return std::nullopt;
  std::optional<Travel> travel;
  for (const core::Point& x : front) {
    if (std::any_of(others.begin(), others.end(), [&](const Solid& solid) { return is_inside(solid, x); })) continue;
    for (std::size_t i = 0; i < others.size(); ++i)
      if (const double ahead = distance_ahead(others[i], x, sense, touching);
          std::isfinite(ahead) && (!travel || ahead < travel->distance))
        travel = Travel{ahead, i};
  }
  return travel;
}

}  // namespace parison::forming
