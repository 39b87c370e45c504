#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <functional>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "core/mesh/profile.hpp"

namespace parison::forming {

/// A temperature by its place, K.
using PlacedTemperature = std::function<double(const core::Point&)>;

/// How a field on a mesh differs from the function that it stands for.
struct FieldMisfit {
  std::vector<double> cell;  ///< integral over each cell of the difference without sign, K m3
  double variation = 0;      ///< integral over the body of the function's difference from its mean, K m3
  /// Of the whole body, as a share of the variation; 0 for a uniform function.
  double share() const;
};
FieldMisfit misfit(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& nodal,
                   const PlacedTemperature& function);

/// Misfit from which on a mesh is too coarse for the field that it begins with.
inline constexpr double start_field_tolerance = 0.03;

/// Edge length for each cell, m, at which all have the same misfit and their sum keeps within the tolerance; by at most
/// a factor of two from the present one.
std::vector<double> fitting_sizes(const core::Mesh& mesh, const FieldMisfit& misfit);

/// The function on a mesh, K: its values at the nodes where these fit it; else its L2 projection within its range, with
/// its content of heat, of which `heat` is what a kilogram holds at a temperature, J/kg.
Eigen::VectorXd fitted_field(const core::Mesh& mesh, core::Geometry geometry, const PlacedTemperature& function,
                             const std::function<double(double)>& heat);

}  // namespace parison::forming
