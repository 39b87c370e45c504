#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/profile.hpp"

namespace parison::contact {

/// Axis-aligned box, m.
struct Box {
  core::Point low, high;
};
/// Empty box: united with another it gives the other, and no point lies in it.
Box no_box();
/// The smallest box that contains both.
Box united(const Box& a, const Box& b);
/// The box with every side moved outwards by a length, m.
inline Box inflated(const Box& box, double by) {
  return {box.low.array() - by, box.high.array() + by};
}
/// A box that contains a segment of an outline, m; not always the smallest one.
Box bounds(const core::Segment& segment);
/// Whether two boxes share a point; touching boxes do.
inline bool overlap(const Box& a, const Box& b) {
  for (int i = 0; i < core::dim; ++i)
    if (!(a.low[i] <= b.high[i] && b.low[i] <= a.high[i])) return false;
  return true;
}
/// Whether a point lies in a box inflated by a length.
inline bool is_near(const core::Point& x, const Box& box, double by) {
  for (int i = 0; i < core::dim; ++i)
    if (!(x[i] <= box.high[i] + by && box.low[i] - by <= x[i])) return false;
  return true;
}

}  // namespace parison::contact
