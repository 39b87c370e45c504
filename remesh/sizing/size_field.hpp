#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <vector>

#include "core/mesh/uniform_grid.hpp"

namespace parison::remesh {

/// Target edge length `size` within the distance `reach` of a point, all in m.
struct SizeSource {
  core::Point at;
  double size;
  double reach = 0;
};

/// Edge length as a function of position, m: the smallest of the sources' sizes, each of which grows linearly, by
/// `growth` per metre beyond its reach, and `largest`. The linear growth limits the gradation of the mesh (H.
/// Borouchaki, F. Hecht, P. J. Frey, Int. J. Numer. Meth. Engng 43 (1998) 1143-1165).
class SizeField {
 public:
  SizeField(std::vector<SizeSource> sources, double growth, double largest);
  double operator()(const core::Point& x) const { return coarsening_factor_ * finest(x); }

  /// Multiplies every length.
  void coarsen(double factor) { coarsening_factor_ *= factor; }
  double coarsening_factor() const { return coarsening_factor_; }

 private:
  double finest(const core::Point& x) const;
  double target_size(const SizeSource& source, double distance) const;
  std::vector<int> candidates(const std::vector<int>& among, const core::Point& centre, double radius) const;
  const std::vector<int>& candidates_in_block(const core::Point& x) const;

  std::vector<SizeSource> sources_;
  double growth_, largest_, coarsening_factor_ = 1;
  core::Point low_;
  double bin_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<int> all_;
  mutable std::vector<std::vector<int>> blocks_, bins_;  ///< candidate sources of each, set at the first query
};

/// Divides a curve of given length, m: arc lengths 0 = s_0 < ... < s_n = length between which the integral of 1/size is
/// the same, about 1 or less, with n >= at_least.
std::vector<double> divide(double length, const std::function<double(double)>& size, core::Index at_least);

}  // namespace parison::remesh
