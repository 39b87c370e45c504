// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/box_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace parison::contact {

using core::Index;

Box no_box() {
  constexpr double far = std::numeric_limits<double>::infinity();
  return {core::Point::Constant(far), core::Point::Constant(-far)};
}

Box united(const Box& a, const Box& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

Box bounds(const core::Segment& segment) {
  const bool major = segment.is_arc && std::abs(segment.to - segment.from) > M_PI;
  const core::Point middle = major ? segment.centre : core::Point(0.5 * (segment.start + segment.end));
  // Of a line or a minor arc the square round the ends.
  return inflated({middle, middle}, major ? segment.radius : 0.5 * (segment.end - segment.start).lpNorm<1>());
}

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!boxes_.empty()) divide(0, static_cast<Index>(boxes_.size()));
}

void BoxTree::divide(Index begin, Index end) {
  constexpr Index leaf_size = 4;
  Box box = boxes_[order_[begin]];
  for (Index i = begin + 1; i < end; ++i) box = united(box, boxes_[order_[i]]);
  const auto self = branches_.size();
  branches_.push_back({box, begin, end, -1});
  if (end - begin <= leaf_size) return;

  Index axis;
  (box.high - box.low).maxCoeff(&axis);
  const auto centre = [&](Index i) { return boxes_[i].low[axis] + boxes_[i].high[axis]; };
  const Index middle = (begin + end) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](Index i, Index j) { return centre(i) < centre(j); });
  divide(begin, middle);
  branches_[self].second = static_cast<Index>(branches_.size());
  divide(middle, end);
}

Index BoxTree::query(const Box& box, std::vector<Index>& found) const {
  Index looked_at = 0;
  const auto first_new = static_cast<std::ptrdiff_t>(found.size());
  std::array<Index, 64> open;  // one for each level
  int left = 0;
  if (!branches_.empty()) open[left++] = 0;
  while (left > 0) {
    const Index self = open[--left];
    const Branch& branch = branches_[self];
    ++looked_at;
    if (!overlap(branch.box, box)) continue;
    if (branch.second >= 0) {
      open[left++] = branch.second;
      open[left++] = self + 1;
      continue;
    }
    for (Index i = branch.begin; i < branch.end; ++i, ++looked_at)
      if (overlap(boxes_[order_[i]], box)) found.push_back(order_[i]);
  }
  std::sort(found.begin() + first_new, found.end());
  return looked_at;
}

}  // namespace parison::contact
