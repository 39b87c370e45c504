// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/curves/mirror.hpp"

#include <cmath>

namespace parison::forming {

std::vector<core::Segment> mirrored(const std::vector<core::Segment>& path, const core::Point& first,
                                    const core::Point& second) {
  const core::Point along = (second - first).normalized();
  const double turn = 2 * std::atan2(along[1], along[0]);
  const auto image = [&](const core::Point& x) -> core::Point {
    const core::Point from = x - first;
    return first + 2 * from.dot(along) * along - from;
  };
  std::vector<core::Segment> result;
  const auto line_to = [&](const core::Point& x) {
    result.emplace_back();
    result.back().end = image(x);
  };
  for (std::size_t i = path.size(); i-- > 0;) {
    const core::Segment& part = path[i];
    line_to(part.end);
    if (!part.is_arc) continue;
    core::Segment arc = part;
    arc.start = image(part.end);
    arc.end = image(part.start);
    arc.centre = image(part.centre);
    arc.from = turn - part.to;
    arc.to = turn - part.from;
    result.push_back(arc);
  }
  return result;
}

}  // namespace parison::forming
