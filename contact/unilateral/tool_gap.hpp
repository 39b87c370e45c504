#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <vector>

#include "contact/box.hpp"
#include "core/mesh/profile.hpp"

namespace parison::contact {

/// Signed distance of a point from a tool's contact boundaries, m: negative inside the tool, +infinity where they are
/// farther away than `reach` or there are none. The profile must outlive this object.
class ToolGap {
 public:
  ToolGap(const core::Profile& tool, const std::vector<bool>& contact_boundaries,
          double reach = std::numeric_limits<double>::infinity());
  double operator()(const core::Point& x) const;
  /// The greater of `known`, m, and the depth of a point inside the tool: what -operator() says, but cheap where the
  /// contact boundaries are no farther away than `known`. The search begins at segment `closest` and leaves there the
  /// one that it found; beside points of the same surface it is the right one as a rule.
  double deepest(const core::Point& x, double known, std::size_t& closest) const;

 private:
  struct BoundedSegment {
    Box bounds;
    const core::Segment* segment;
  };
  const core::Profile* tool_;
  double reach_;
  std::vector<BoundedSegment> segments_;
  Box in_reach_;
};

/// The same for a single point.
double signed_gap(const core::Profile& tool, const std::vector<bool>& contact_boundaries, const core::Point& x,
                  double reach = std::numeric_limits<double>::infinity());

}  // namespace parison::contact
