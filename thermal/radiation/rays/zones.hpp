#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/mesh/element.hpp"

namespace parison::thermal {

using core::Index;
using core::Point;

/// Functions of a zone: constant and two linear ones.
inline constexpr int zone_functions = 3;
using ZoneValues = std::array<double, zone_functions>;

/// Parts of a body's section in which light is resolved linearly: the boxes of a grid, slivers joined with a neighbour.
/// The functions of each zone are orthonormal in the volume of the mesh's quadrature points.
class Zones {
 public:
  /// From the quadrature points of a mesh: place, m, volume, m3, and area in the section, m2. `count` boxes have the
  /// area of the section.
  Zones(const std::vector<Point>& position, const std::vector<double>& volume, const std::vector<double>& area,
        int count);

  Index size() const { return static_cast<Index>(zone_.size()); }  ///< of zones
  Index function_count() const { return zone_functions * size(); }
  double box_size() const { return h_; }                          ///< m
  double volume(Index zone) const { return zone_[zone].volume; }  ///< m3
  Index at(const Point& x) const;                                 ///< the zone of a point
  ZoneValues values(Index zone, const Point& x) const;            ///< of its functions, m^-3/2
  /// Coefficients of the function 1.
  const Eigen::VectorXd& one() const { return one_; }

 private:
  struct Zone {
    Point centre;
    double volume;
    std::array<double, 3> second;  ///< rows of the inverse Cholesky factor of the second moments
  };
  Index box_at(const Point& x) const;
  std::vector<Index> neighbours(Index i, Index j) const;  ///< boxes beside one
  void join_slivers(const std::vector<double>& area, const std::vector<int>& points);
  void fill_gaps();

  double h_;
  Point low_;
  std::array<Index, 2> boxes_;
  std::vector<Index> zone_of_box_;
  std::vector<Zone> zone_;
  Eigen::VectorXd one_;
};

}  // namespace parison::thermal
