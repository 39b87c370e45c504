#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/mesh/profile.hpp"

namespace parison::contact {

/// Axis-aligned box, m.
struct Box {
  core::Point low, high;
};
/// Box that holds nothing.
Box no_box();
Box united(const Box& a, const Box& b);
inline Box inflated(const Box& box, double by) {
  return {box.low.array() - by, box.high.array() + by};
}
/// Box that holds a segment.
Box bounds(const core::Segment& segment);
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

/// Binary tree over boxes in a row, each branch half of its parent's: neighbours in the row, as the edges of an
/// outline, should be neighbours in space.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes);

  /// Appends the boxes that overlap `box`, in increasing order; returns how many boxes were looked at.
  core::Index query(const Box& box, std::vector<core::Index>& found) const;

 private:
  struct Branch {
    Box box;
    core::Index begin, end;  ///< range of boxes_
    core::Index second;      ///< the first child follows its parent; -1 in a leaf
  };
  Box divide(core::Index begin, core::Index end);

  std::vector<Box> boxes_;
  std::vector<Branch> branches_;
};

}  // namespace parison::contact
