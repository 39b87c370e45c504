// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/mortar/box_tree.hpp"

#include <array>
#include <cmath>
#include <limits>

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

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
  branches_.reserve(boxes_.size());
  if (!boxes_.empty()) divide(0, static_cast<Index>(boxes_.size()));
}

Box BoxTree::divide(Index begin, Index end) {
  constexpr Index leaf_size = 4;
  const auto self = branches_.size();
  branches_.push_back({boxes_[begin], begin, end, -1});
  Box box = boxes_[begin];
  if (end - begin <= leaf_size) {
    for (Index i = begin + 1; i < end; ++i) box = united(box, boxes_[i]);
  } else {
    const Index middle = (begin + end) / 2;
    box = divide(begin, middle);
    branches_[self].second = static_cast<Index>(branches_.size());
    box = united(box, divide(middle, end));
  }
  return branches_[self].box = box;
}

Index BoxTree::query(const Box& box, std::vector<Index>& found) const {
  Index looked_at = 0;
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
      if (overlap(boxes_[i], box)) found.push_back(i);
  }
  return looked_at;
}

}  // namespace parison::contact
