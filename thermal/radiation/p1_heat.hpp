#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "thermal/radiation/p1.hpp"

namespace parison::thermal {

/// Temperatures at the quadrature points of the glass, K, or changes of them.
Field at_cell_points(const P1& light, const HeatSystem& system, const Eigen::VectorXd& temperature);

/// Adds to the unknowns of the temperature, times `factor`, what the cells absorb of the irradiation of each group less
/// what they emit, W at the quadrature points.
void add_absorbed(const P1& light, const HeatSystem& system, const std::vector<Eigen::VectorXd>& irradiation,
                  const std::vector<Field>& emitted, double factor, Eigen::VectorXd& power);

/// Irradiation of a group for the emission of its cells, W at the quadrature points, and a right-hand side that has
/// that of the surface, W.
Eigen::VectorXd solve_group(const P1& light, int group, const Field& emitted, Eigen::VectorXd rhs);

inline double at_point(const Eigen::VectorXd& values, const std::array<Index, 3>& unknowns, const double* shape) {
  return shape[0] * values[unknowns[0]] + shape[1] * values[unknowns[1]] + shape[2] * values[unknowns[2]];
}
inline void add_at_point(double value, const std::array<Index, 3>& unknowns, const double* shape,
                         Eigen::VectorXd& sum) {
  for (int i = 0; i < 3; ++i) sum[unknowns[i]] += shape[i] * value;
}

}  // namespace parison::thermal
