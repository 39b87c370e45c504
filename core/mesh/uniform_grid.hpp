#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::core {

/// Axis-parallel box, m.
struct Box {
  Point low, high;
  bool meets(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};
/// Smallest box around points; of no points its low corner is at +infinity, its high one at -infinity.
Box bounding_box(const std::vector<Point>& points);
/// Box around some nodes of a mesh, widened on every side by `margin` times its larger extent.
template <typename Nodes>
Box bounding_box(const Mesh& mesh, const Nodes& nodes, double margin) {
  Box box{mesh.nodes[nodes[0]], mesh.nodes[nodes[0]]};
  for (const Index node : nodes) {
    box.low = box.low.cwiseMin(mesh.nodes[node]);
    box.high = box.high.cwiseMax(mesh.nodes[node]);
  }
  const double widened = margin * (box.high - box.low).maxCoeff();
  return {box.low.array() - widened, box.high.array() + widened};
}

/// Square bins in columns and rows over a box.
class UniformGrid {
 public:
  /// A bin's column and row.
  using Bin = std::array<int, dim>;

  UniformGrid() = default;
  /// Bins of edge length `size`, m, from the box's low corner on until they cover it.
  UniformGrid(const Box& box, double size);

  double bin_size() const { return size_; }
  const Bin& count() const { return count_; }
  /// The bin that contains x, or the nearest one.
  Bin bin_at(const Point& x) const {
    Bin bin;
    for (int k = 0; k < dim; ++k)
      bin[k] = std::clamp(static_cast<int>(std::floor((x[k] - low_[k]) / size_)), 0, count_[k] - 1);
    return bin;
  }
  bool holds(const Bin& bin) const { return bin[0] >= 0 && bin[0] < count_[0] && bin[1] >= 0 && bin[1] < count_[1]; }
  /// Number of bins, and of a bin in them.
  std::size_t size() const { return static_cast<std::size_t>(count_[0]) * count_[1]; }
  std::size_t index(const Bin& bin) const { return static_cast<std::size_t>(bin[1]) * count_[0] + bin[0]; }
  Point centre(const Bin& bin) const { return low_ + size_ * Point(bin[0] + 0.5, bin[1] + 0.5); }

  /// Calls visit(bin) for the bins that a box touches, row by row.
  template <typename Visit>
  void for_each_bin(const Box& box, const Visit& visit) const {
    const Bin first = bin_at(box.low), last = bin_at(box.high);
    for (int row = first[1]; row <= last[1]; ++row)
      for (int column = first[0]; column <= last[0]; ++column) visit(Bin{column, row});
  }

 private:
  Point low_ = Point::Zero();
  double size_ = 1;
  Bin count_{};
};

/// Boxes of some bodies, listed in the bins that they touch.
class BoxGrid {
 public:
  BoxGrid(const UniformGrid& grid, std::vector<Box> boxes);

  const UniformGrid& grid() const { return grid_; }
  const Box& box(Index i) const { return boxes_[i]; }
  /// Numbers of the boxes in a bin, in increasing order.
  struct Range {
    const Index *first, *last;
    const Index* begin() const { return first; }
    const Index* end() const { return last; }
  };
  Range boxes_in(const UniformGrid::Bin& bin) const {
    const std::size_t i = grid_.index(bin);
    return {listed_.data() + start_[i], listed_.data() + start_[i + 1]};
  }
  /// Sets `found` to the numbers of the boxes that meet one, each once, in the order of the bins.
  void find(const Box& box, std::vector<Index>& found) const;

 private:
  UniformGrid grid_;
  std::vector<Box> boxes_;
  std::vector<Index> start_, listed_;  ///< of bin i: listed_[start_[i]] ... listed_[start_[i + 1] - 1]
};

}  // namespace parison::core
