// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/uniform_grid.hpp"

#include <limits>
#include <numeric>

namespace parison::core {

Box bounding_box(const std::vector<Point>& points) {
  const Point infinite = Point::Constant(std::numeric_limits<double>::infinity());
  Box box{infinite, -infinite};
  for (const Point& x : points) {
    box.low = box.low.cwiseMin(x);
    box.high = box.high.cwiseMax(x);
  }
  return box;
}

UniformGrid::UniformGrid(const Box& box, double size) : low_(box.low), size_(size) {
  const Point extent = box.high - box.low;
  for (int k = 0; k < dim; ++k) count_[k] = static_cast<int>(extent[k] / size) + 1;
}

BoxGrid::BoxGrid(const UniformGrid& grid, std::vector<Box> boxes)
    : grid_(grid), boxes_(std::move(boxes)), start_(grid.size() + 1, 0) {
  for (const Box& box : boxes_)
    grid_.for_each_bin(box, [&](const UniformGrid::Bin& bin) { ++start_[grid_.index(bin) + 1]; });
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  listed_.resize(start_.back());
  std::vector<Index> next(start_.begin(), start_.end() - 1);
  for (std::size_t i = 0; i < boxes_.size(); ++i)
    grid_.for_each_bin(boxes_[i],
                       [&](const UniformGrid::Bin& bin) { listed_[next[grid_.index(bin)]++] = static_cast<Index>(i); });
}

void BoxGrid::find(const Box& box, std::vector<Index>& found) const {
  found.clear();
  grid_.for_each_bin(box, [&](const UniformGrid::Bin& bin) {
    for (const Index i : boxes_in(bin))
      if (boxes_[i].meets(box) && std::find(found.begin(), found.end(), i) == found.end()) found.push_back(i);
  });
}

}  // namespace parison::core
