// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "forming/scene/container/crossings.hpp"
#include "forming/scene/container/free_space.hpp"

namespace parison::forming {

namespace {

/// Shifts at which a part of the moved body lies in a part of a solid, on one line along the axis.
struct Blocked {
  Stop low, high;
};

double outer_radius(const core::Profile& profile) {
  double radius = 0;
  for (const core::Segment& segment : profile.segments) {
    radius = std::max(radius, segment.start[0]);
    if (segment.is_arc)
      for (const double t : {0.25, 0.5, 0.75}) radius = std::max(radius, core::point_at(segment, t)[0]);
  }
  return radius;
}

/// Radii of the lines along the axis: dense where a round body is steep, and at both sides of every end of an outline.
std::vector<double> radii_of(const Solid& moved, const std::vector<Solid>& solids, double radius) {
  constexpr int count = 2000;
  constexpr double beside = 1e-9;  // of the radius; the first line is as near to the axis
  std::vector<double> radii{beside * radius};
  for (int i = 1; i < count; ++i) radii.push_back(radius * std::sin(M_PI / 2 * i / count));
  const auto add = [&](const core::Profile& profile) {
    for (const core::Segment& segment : profile.segments)
      for (const double side : {-1.0, 1.0})
        if (const double at = segment.start[0] + side * beside * radius; at > 0 && at < radius) radii.push_back(at);
  };
  add(*moved.profile);
  for (const Solid& solid : solids) add(*solid.profile);
  return radii;
}

/// Where the line at a radius is inside an outline: places along the axis, in pairs.
std::vector<double> places_inside(const core::Profile& profile, double radius) {
  std::vector<Crossing> crossings;
  for (const core::Segment& segment : profile.segments) add_crossings_along(segment, radius, true, crossings);
  std::vector<double> places;
  for (const Crossing& crossing : crossings) places.push_back(crossing.at);
  std::sort(places.begin(), places.end());
  if (places.size() % 2 == 1) places.pop_back();
  return places;
}

std::vector<FreeShifts> between(std::vector<Blocked> blocked) {
  std::sort(blocked.begin(), blocked.end(),
            [](const Blocked& a, const Blocked& b) { return a.low.shift < b.low.shift; });
  std::vector<FreeShifts> free{{}};
  for (const Blocked& one : blocked) {
    FreeShifts& last = free.back();
    if (one.low.shift > last.low.shift) {
      last.high = one.low;
      free.push_back({one.high, FreeShifts{}.high});
    } else if (one.high.shift > last.low.shift) {
      last.low = one.high;
    }
  }
  return free;
}

}  // namespace

std::vector<FreeShifts> free_shifts(const Solid& moved, const std::vector<Solid>& solids) {
  constexpr std::size_t most_work = 100'000'000;  // lines times segments
  const double radius = outer_radius(*moved.profile);
  const std::vector<double> radii = radii_of(moved, solids, radius);
  std::size_t segments = moved.profile->segments.size();
  for (const Solid& solid : solids) segments += solid.profile->segments.size();
  if (radii.size() * segments > most_work) return {};
  std::vector<Blocked> blocked;
  for (const double r : radii) {
    const std::vector<double> own = places_inside(*moved.profile, r);
    if (own.empty()) continue;
    for (std::size_t k = 0; k < solids.size(); ++k) {
      const std::vector<double> other = places_inside(*solids[k].profile, r);
      for (std::size_t i = 0; i + 1 < own.size(); i += 2)
        for (std::size_t j = 0; j + 1 < other.size(); j += 2) {
          const double low = other[j] + solids[k].shift, high = other[j + 1] + solids[k].shift;
          blocked.push_back(
              {{low - own[i + 1] - moved.shift, k, {r, low}}, {high - own[i] - moved.shift, k, {r, high}}});
        }
    }
  }
  return between(std::move(blocked));
}

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
