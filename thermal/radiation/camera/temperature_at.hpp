#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "core/mesh/cell_map.hpp"

namespace parison::thermal {

/// A nodal field at many points of a mesh: the cells are sorted into a grid of bins.
class FieldAtPoints {
 public:
  FieldAtPoints(const core::Mesh& mesh, Eigen::VectorXd field);
  /// The field at a point; just outside the mesh that of the nearest cell in the point's bin.
  double operator()(const core::Point& x) const;

 private:
  std::array<long, 2> bin(const core::Point& x) const;

  const core::Mesh& mesh_;
  Eigen::VectorXd field_;
  std::vector<core::CellMap> maps_;
  core::Point low_;
  double width_ = 0;  ///< of a bin, m
  std::array<long, 2> count_{};
  std::vector<std::vector<core::Index>> cells_;  ///< of each bin
};

}  // namespace parison::thermal
