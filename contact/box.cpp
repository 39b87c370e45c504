// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/box.hpp"

#include <cmath>
#include <limits>

#include "core/math/numbers.hpp"

namespace parison::contact {

Box no_box() {
  return {core::Point::Constant(core::infinity), core::Point::Constant(-core::infinity)};
}

Box united(const Box& a, const Box& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

Box bounds(const core::Segment& segment) {
  const bool major = segment.is_arc && std::abs(segment.to - segment.from) > M_PI;
  const core::Point middle = major ? segment.centre : core::Point(0.5 * (segment.start + segment.end));
  // A line or a minor arc lies within the square around the middle of its chord with half side |dx|/2 + |dy|/2.
  return inflated({middle, middle}, major ? segment.radius : 0.5 * (segment.end - segment.start).lpNorm<1>());
}

}  // namespace parison::contact
