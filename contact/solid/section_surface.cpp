// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solid/section_surface.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace parison::contact {

using core::Point;
using core::Vector3;

/// Distance of a point's image in the plane of the outline, m, negative in the tool, and its gradient in space.
struct SectionSurface::Level {
  double distance;
  Vector3 gradient;
};

SectionSurface::SectionSurface(const core::Profile& outline, const std::vector<bool>& contact_boundaries,
                               core::SectionFamily family, double offset)
    : outline_(&outline), family_(std::move(family)), offset_(offset * Vector3::UnitZ()) {
  for (const auto& segment : outline.segments)
    if (contact_boundaries[segment.boundary_id]) segments_.push_back(&segment);
}

SectionSurface::Level SectionSurface::level(const Vector3& at) const {
  const auto [width, gradient] = core::half_width(family_, at);
  const Point x(width, at[2]);
  double nearest = std::numeric_limits<double>::infinity();
  const core::Segment* closest = nullptr;
  for (const auto* segment : segments_)
    if (const double found = core::distance(*segment, x, nearest); found < nearest) {
      nearest = found;
      closest = segment;
    }
  if (!closest) return {nearest, Vector3::Zero()};
  const double t = core::closest_parameter(*closest, x);
  const double sign = core::contains(*outline_, x) ? -1 : 1;
  constexpr double on_surface = 1e-9;  // m: the direction of the outline's normal is surer there
  const Point away =
      nearest > on_surface ? Point(sign * (x - core::point_at(*closest, t)) / nearest) : core::normal_at(*closest, t);
  return {sign * nearest, away[0] * gradient + away[1] * Vector3::UnitZ()};
}

SurfaceGap SectionSurface::gap(const Vector3& at) const {
  const Vector3 start = at - offset_;
  const Level first = level(start);
  if (!std::isfinite(first.distance)) return {first.distance, Vector3::Zero()};
  if (family_.is_round()) return {first.distance, first.gradient.normalized()};
  constexpr int most_steps = 5;
  constexpr double close = 1e-10;  // m
  Vector3 foot = start;
  Level here = first;
  for (int step = 0; step < most_steps && std::abs(here.distance) > close; ++step) {
    foot -= here.distance / here.gradient.squaredNorm() * here.gradient;
    here = level(foot);
  }
  return {std::copysign((start - foot).norm(), first.distance), here.gradient.normalized()};
}

}  // namespace parison::contact
