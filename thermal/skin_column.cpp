// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/skin_column.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace parison::thermal {

namespace {

using Eigen::MatrixXd;

/// Penetration depths sqrt(alpha t) beyond which a half-space has not changed, and the smallest cell that matters, in
/// the same measure.
constexpr double depth_of_column = 12, smallest_cell = 0.03;
constexpr int fewest_cells = 4;
/// Growth of the cells of the fine mesh that stands for an exact solution.
constexpr double fine_growth = 0.15;

/// Positions of the vertices of a column under the surface, m. The last cell ends at the layer's back.
std::vector<double> vertices(const SkinSide& side, double time, double shortest) {
  const double first = std::max(side.first_cell, smallest_cell * std::min(penetration(side, shortest), side.depth));
  const double end = reaches_back(side, time) ? side.depth : depth_of_column * penetration(side, time);
  std::vector<double> x{0};
  while (x.back() < end || (std::isinf(side.depth) && static_cast<int>(x.size()) <= fewest_cells))
    x.push_back(x.back() + first + side.growth * x.back());
  if (x.back() <= side.depth) return x;
  const std::size_t last = x.size() - 1;
  if (last > 1 && side.depth - x[last - 1] < 0.5 * (x[last] - x[last - 1])) x.pop_back();  // no cell thinner than half
  x.back() = side.depth;
  return x;
}

}  // namespace

double penetration(const SkinSide& side, double time) {
  return std::sqrt(side.conductivity / side.capacity * time);
}

bool reaches_back(const SkinSide& side, double time) {
  return side.depth < depth_of_column * penetration(side, time);
}

SkinSide fine_side(SkinSide side) {
  side.first_cell = 0;
  side.growth = fine_growth;
  side.order = 2;
  return side;
}

SkinColumn skin_column(const SkinSide& side, double time, double shortest) {
  static const Eigen::Matrix3d mass = (Eigen::Matrix3d() << 4, 2, -1, 2, 16, 2, -1, 2, 4).finished() / 30;
  static const Eigen::Matrix3d stiffness = (Eigen::Matrix3d() << 7, -8, 1, -8, 16, -8, 1, -8, 7).finished() / 3;
  static const Eigen::Matrix2d linear_mass = (Eigen::Matrix2d() << 2, 1, 1, 2).finished() / 6;
  static const Eigen::Matrix2d linear_stiffness = (Eigen::Matrix2d() << 1, -1, -1, 1).finished();
  const auto x = vertices(side, time, shortest);
  const int order = side.order == 1 ? 1 : 2, cells = static_cast<int>(x.size()) - 1, size = order * cells + 1;
  SkinColumn result{MatrixXd::Zero(size, size), MatrixXd::Zero(size, size)};
  for (int cell = 0; cell < cells; ++cell) {
    const double height = x[cell + 1] - x[cell];
    const double conductance = side.conductivity / height, capacity = side.capacity * height;
    auto k = result.stiffness.block(order * cell, order * cell, order + 1, order + 1);
    auto m = result.mass.block(order * cell, order * cell, order + 1, order + 1);
    if (order == 1) {
      k += conductance * linear_stiffness;
      m += capacity * linear_mass;
    } else {
      k += conductance * stiffness;
      m += capacity * mass;
    }
  }
  return result;
}

}  // namespace parison::thermal
