#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "thermal/radiation/light.hpp"

namespace parison::thermal {

/// Temperatures at the quadrature points of the glass, K, or changes of them.
Field at_cell_points(const Light& light, const HeatSystem& system, const Eigen::VectorXd& temperature);
/// Multiplies numbers at the quadrature points by the absorption coefficient of a group there, 1/m, and by the volume
/// of the points, m3.
void multiply_by_absorption(const Light& light, int group, Field& values);
/// What the cells emit in a group at temperatures at their quadrature points, K, W, or its derivative, W/K.
Field emission_at(const Light& light, int group, const Field& temperature, double Emission::*part);

/// What cells and surface send in a group, W: at the quadrature points of the cells, of the edges and of the interface.
struct GroupSource {
  Field cells;
  std::vector<std::array<double, 3>> edges;
  Eigen::ArrayXd contacts;
  PatchEmission patches = {};  ///< of an enclosure
};
/// The light that this makes: what the cells absorb at their quadrature points, W, and the irradiation G at the points
/// of the edges and of the interface, W/m2.
struct GroupLight {
  Field absorbed;
  std::vector<std::array<double, 3>> edges;
  Eigen::ArrayXd contacts;
  Eigen::VectorXd excess = {};  ///< irradiation of the patches of an enclosure less that by the surroundings, W/m2
};
GroupLight solve_group(const Light& light, int group, const GroupSource& source);

/// Adds to the unknowns of the temperature, times `factor`, what the cells absorb less what they emit.
void add_absorbed(const Light& light, const HeatSystem& system, const GroupSource& source, const GroupLight& found,
                  double factor, Eigen::VectorXd& power);

inline double at_point(const Eigen::VectorXd& values, const std::array<Index, 3>& unknowns, const double* shape) {
  return shape[0] * values[unknowns[0]] + shape[1] * values[unknowns[1]] + shape[2] * values[unknowns[2]];
}
inline void add_at_point(double value, const std::array<Index, 3>& unknowns, const double* shape,
                         Eigen::VectorXd& sum) {
  for (int i = 0; i < 3; ++i) sum[unknowns[i]] += shape[i] * value;
}

}  // namespace parison::thermal
