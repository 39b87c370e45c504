#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <vector>

#include "core/mesh/uniform_grid.hpp"

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
  const std::vector<int>& candidates_in_block(const core::Point& x) const;

  std::vector<SizeSource> sources_;
  double growth_, largest_, coarsening_factor_ = 1;
  std::vector<int> all_;  ///< numbers of the sources
  core::UniformGrid bins_, blocks_;
  /// Sources that can matter in each bin and each block, filled when first asked for.
  mutable std::vector<std::vector<int>> in_bin_, in_block_;
};

/// The least number of equal parts of a length, m, that are not longer than a size, m; where the length is a multiple
/// of the size, round-off makes no part more.
core::Index parts_of(double length, double size);

/// Arc lengths 0 = s_0 < ... < s_n = length such that each division has the same integral of 1/size, at most about 1.
std::vector<double> divide(double length, const std::function<double(double)>& size, core::Index at_least);

}  // namespace parison::remesh
