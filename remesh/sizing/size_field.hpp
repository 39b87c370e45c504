#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <vector>

#include "core/mesh/point.hpp"

namespace parison::remesh {

/// Wish for edges of `size` within `reach` of a point, all in m.
struct SizeSource {
  core::Point at;
  double size;
  double reach = 0;
};

/// Edge length over space: the least of what the sources ask for, each growing by `growth` per metre beyond its reach.
class SizeField {
 public:
  SizeField(std::vector<SizeSource> sources, double growth, double largest);
  double operator()(const core::Point& x) const { return coarsening_factor_ * finest(x); }

  /// Makes every length so many times as long.
  void coarsen(double factor) { coarsening_factor_ *= factor; }
  double coarsening_factor() const { return coarsening_factor_; }

 private:
  double finest(const core::Point& x) const;
  double target_size(const SizeSource& source, double distance) const;
  std::vector<int> candidates(const std::vector<int>& among, const core::Point& centre, double radius) const;
  const std::vector<int>& block_of(int column, int row) const;

  std::vector<SizeSource> sources_;
  double growth_, largest_, coarsening_factor_ = 1;
  core::Point low_;
  double bin_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<int> all_;
  mutable std::vector<std::vector<int>> blocks_, bins_;  ///< sources that can matter there, filled when first asked for
};

/// Arc lengths 0 = s_0 < ... < s_n = length such that each division holds the same integral of 1/size, at most about 1.
std::vector<double> divide(double length, const std::function<double(double)>& size, core::Index at_least);

}  // namespace parison::remesh
