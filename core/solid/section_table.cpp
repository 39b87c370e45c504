// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/section_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parison::core {

namespace {

/// Slopes by the row's number; the first and last row are planes of symmetry.
Eigen::MatrixXd slopes_along_rows(const Eigen::MatrixXd& values) {
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(values.rows(), values.cols());
  for (Eigen::Index i = 1; i + 1 < values.rows(); ++i) slopes.row(i) = (values.row(i + 1) - values.row(i - 1)) / 2;
  return slopes;
}

/// Slopes of the parabola through each column and its neighbours.
Eigen::MatrixXd slopes_along_columns(const Eigen::MatrixXd& values, const std::vector<double>& x) {
  Eigen::MatrixXd slopes(values.rows(), values.cols());
  const auto chord = [&](Eigen::Index i) -> Eigen::VectorXd {
    const auto k = static_cast<std::size_t>(i);
    return (values.col(i + 1) - values.col(i)) / (x[k + 1] - x[k]);
  };
  const Eigen::Index last = values.cols() - 1;
  slopes.col(0) = chord(0);
  slopes.col(last) = chord(last - 1);
  for (Eigen::Index i = 1; i < last; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double before = x[k] - x[k - 1], behind = x[k + 1] - x[k];
    slopes.col(i) = (behind * chord(i - 1) + before * chord(i)) / (before + behind);
  }
  return slopes;
}

}  // namespace

/// Of the entries at both ends of an interval, for the value between them by the cubic of Hermite.
struct ReachTable::Weights {
  Eigen::Index first;                   ///< of the two entries
  double value[2], slope[2];            ///< `slope` times the length of the interval
  double value_rate[2], slope_rate[2];  ///< their derivatives

  Weights(Eigen::Index at, double t, double length) : first(at) {
    const double left = 1 - t;
    value[0] = left * left * (1 + 2 * t), value[1] = t * t * (3 - 2 * t);
    slope[0] = length * t * left * left, slope[1] = -length * t * t * left;
    value_rate[1] = 6 * t * left / length, value_rate[0] = -value_rate[1];
    slope_rate[0] = left * (1 - 3 * t), slope_rate[1] = t * (3 * t - 2);
  }
};

ReachTable::ReachTable(std::vector<double> heights, Eigen::MatrixXd reach)
    : heights_(std::move(heights)),
      reach_(std::move(reach)),
      by_angle_(slopes_along_rows(reach_)),
      by_height_(slopes_along_columns(reach_, heights_)),
      by_both_(slopes_along_rows(by_height_)) {}

ReachTable::Weights ReachTable::along_height(double height) const {
  const double at = std::clamp(height, heights_.front(), heights_.back());
  const auto above = std::upper_bound(heights_.begin() + 1, heights_.end() - 1, at);
  const double low = *(above - 1), length = *above - low;
  return {above - 1 - heights_.begin(), (at - low) / length, length};
}

ReachTable::Value ReachTable::at(double height, double angle) const {
  const double steps = static_cast<double>(reach_.rows() - 1), step = M_PI_2 / steps;
  const double place = std::clamp(angle / step, 0.0, steps), row = std::min(std::floor(place), steps - 1);
  const Weights across(static_cast<Eigen::Index>(row), place - row, 1), up = along_height(height);
  Value sum{0, 0};
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 2; ++k) {
      const Eigen::Index r = across.first + i, c = up.first + k;
      const double value = up.value[k] * reach_(r, c) + up.slope[k] * by_height_(r, c);
      const double slope = up.value[k] * by_angle_(r, c) + up.slope[k] * by_both_(r, c);
      sum.reach += across.value[i] * value + across.slope[i] * slope;
      sum.by_angle += (across.value_rate[i] * value + across.slope_rate[i] * slope) / step;
    }
  return sum;
}

double ReachTable::mean_square(double height) const {
  const Weights up = along_height(height);
  Eigen::ArrayXd reach = Eigen::ArrayXd::Zero(reach_.rows());
  for (int k = 0; k < 2; ++k)
    reach += up.value[k] * reach_.col(up.first + k).array() + up.slope[k] * by_height_.col(up.first + k).array();
  const Eigen::Index last = reach.size() - 1;
  // The ends lie in planes of symmetry, so that the rule of trapezoids is as good as the entries are.
  return (reach.square().sum() - (reach[0] * reach[0] + reach[last] * reach[last]) / 2) / static_cast<double>(last);
}

const ReachTable* MeasuredSections::inner_at(double height) const {
  const double at = std::clamp(height, outer.low(), outer.high());  // the metal below a base goes on as it is
  return inner && at >= inner->low() && at <= inner->high() ? &*inner : nullptr;
}

MeasuredSections::HalfWidth MeasuredSections::half_width(double far, double height, double angle) const {
  const auto at = outer.at(height, angle);
  const double wide = outer.at(height, 0).reach;
  const auto in_proportion = [&](double width, const ReachTable::Value& border) {
    const double share = width / border.reach;
    return HalfWidth{far * share, share, -far * share * border.by_angle / border.reach};
  };
  const ReachTable* base = far < at.reach ? inner_at(height) : nullptr;
  if (!base) return in_proportion(wide, at);
  const auto within = base->at(height, angle);
  const double narrow = base->at(height, 0).reach;
  if (far < within.reach) return in_proportion(narrow, within);
  const double length = at.reach - within.reach, share = (far - within.reach) / length, rise = (wide - narrow) / length;
  return {narrow + share * (wide - narrow), rise, -rise * (within.by_angle + share * (at.by_angle - within.by_angle))};
}

double MeasuredSections::far(double half_width, double height, double angle) const {
  const double at = outer.at(height, angle).reach, wide = outer.at(height, 0).reach;
  const ReachTable* base = half_width < wide ? inner_at(height) : nullptr;
  if (!base) return half_width * at / wide;
  const double within = base->at(height, angle).reach, narrow = base->at(height, 0).reach;
  if (half_width < narrow) return half_width * within / narrow;
  return within + (half_width - narrow) / (wide - narrow) * (at - within);
}

double MeasuredSections::area_factor(double height) const {
  double area = outer.mean_square(height), round = std::pow(outer.at(height, 0).reach, 2);
  if (const ReachTable* base = inner_at(height)) {
    area -= base->mean_square(height);
    round -= std::pow(base->at(height, 0).reach, 2);
  }
  return area / round;
}

}  // namespace parison::core
