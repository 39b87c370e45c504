// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/unilateral/tool_gap.hpp"

#include <limits>

namespace parison::contact {

using core::Point;
using core::Profile;

ToolGap::ToolGap(const Profile& tool, const std::vector<bool>& contact_boundaries, double reach)
    : tool_(&tool), reach_(reach), in_reach_(no_box()) {
  for (const auto& segment : tool.segments) {
    if (!contact_boundaries[segment.boundary_id]) continue;
    segments_.push_back({bounds(segment), &segment});
    in_reach_ = united(in_reach_, inflated(segments_.back().bounds, reach));
  }
}

double ToolGap::operator()(const Point& x) const {
  constexpr double beyond = std::numeric_limits<double>::infinity();
  if (!is_near(x, in_reach_, 0)) return beyond;
  double best = reach_;
  for (const auto& [bounds, segment] : segments_)
    if (is_near(x, bounds, best)) best = core::distance(*segment, x, best);
  if (best >= reach_) return beyond;
  return core::contains(*tool_, x) ? -best : best;
}

double signed_gap(const Profile& tool, const std::vector<bool>& contact_boundaries, const Point& x, double reach) {
  return ToolGap(tool, contact_boundaries, reach)(x);
}

}  // namespace parison::contact
