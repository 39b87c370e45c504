// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/unilateral/tool_gap.hpp"

#include <algorithm>
#include <limits>

#include "core/math/numbers.hpp"

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
  if (!is_near(x, in_reach_, 0)) return core::infinity;
  double best = reach_;
  for (const auto& [bounds, segment] : segments_)
    if (is_near(x, bounds, best)) best = core::distance(*segment, x, best);
  if (best >= reach_) return core::infinity;
  return core::contains(*tool_, x) ? -best : best;
}

double ToolGap::deepest(const Point& x, double known, std::size_t& closest) const {
  if (closest < segments_.size() && core::distance(*segments_[closest].segment, x, core::infinity) <= known)
    return known;
  if (!core::contains(*tool_, x)) return known;
  double best = reach_;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const auto& [bounds, segment] = segments_[i];
    if (!is_near(x, bounds, best)) continue;
    const double found = core::distance(*segment, x, best);
    if (found < best) closest = i;
    best = found;
  }
  return best < reach_ ? std::max(known, best) : known;
}

double signed_gap(const Profile& tool, const std::vector<bool>& contact_boundaries, const Point& x, double reach) {
  return ToolGap(tool, contact_boundaries, reach)(x);
}

}  // namespace parison::contact
