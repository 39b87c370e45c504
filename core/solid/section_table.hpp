#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <optional>
#include <vector>

namespace parison::core {

/// How far a border around an axis is from it, m, at heights and at even angles of a quarter turn, whose ends are
/// planes of symmetry. In between cubic in both directions, with continuous slopes; beyond the first and last height it
/// stays.
class ReachTable {
 public:
  /// `reach`: a row for each angle, the first 0 and the last a right one, and a column for each height, m, ascending;
  /// at least two of each.
  ReachTable(std::vector<double> heights, Eigen::MatrixXd reach);

  struct Value {
    double reach, by_angle;  ///< m; by_angle: its slope, m/rad
  };
  /// `angle` within the quarter, rad.
  Value at(double height, double angle) const;
  /// Mean of the square of the reach over the angle, m2: the area within the border over pi.
  double mean_square(double height) const;
  const std::vector<double>& heights() const { return heights_; }
  double low() const { return heights_.front(); }
  double high() const { return heights_.back(); }

 private:
  struct Weights;
  Weights along_height(double height) const;

  std::vector<double> heights_;
  Eigen::MatrixXd reach_, by_angle_, by_height_, by_both_;  ///< slopes by the step of the angle, and by m
};

/// Sections of a cavity as they were measured: around it, and around what stands up in its base.
struct MeasuredSections {
  ReachTable outer;
  std::optional<ReachTable> inner;

  struct HalfWidth {
    double value, by_far, by_angle;  ///< m; slopes, 1 and m/rad
  };
  /// Half the width in the plane y = 0 of the place `far` from the axis at an angle: the borders' own on them, between
  /// them linear, within and beyond them in proportion.
  HalfWidth half_width(double far, double height, double angle) const;
  /// The other way round: how far from the axis the place with half a width is.
  double far(double half_width, double height, double angle) const;
  /// Area of the section over that with circles for its borders.
  double area_factor(double height) const;

 private:
  const ReachTable* inner_at(double height) const;
};

}  // namespace parison::core
