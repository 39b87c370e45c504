// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/outline_place.hpp"

namespace parison::forming {

std::optional<OutlinePlace> closest_place(const Body& body, const core::Point& point,
                                          const std::function<bool(Index)>& wanted) {
  std::optional<OutlinePlace> best;
  double least = 0;
  for (const core::Segment& segment : body.profile.segments) {
    if (!wanted(segment.boundary_id)) continue;
    const double t = core::closest_parameter(segment, point);
    const core::Point at = core::point_at(segment, t);
    const double distance = (at - point).norm();
    if (best && distance >= least) continue;
    least = distance;
    best = OutlinePlace{segment.boundary_id, at, core::normal_at(segment, t)};
  }
  return best;
}

std::optional<OutlinePlace> closest_contact(const Body& body, const core::Point& point) {
  return closest_place(body, point, [&](Index id) { return body.boundaries[id].kind == BoundaryKind::contact; });
}

}  // namespace parison::forming
