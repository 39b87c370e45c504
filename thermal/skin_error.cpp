// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/skin_error.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/erfcx.hpp"

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
  return side;
}

SkinColumn skin_column(const SkinSide& side, double time, double shortest) {
  static const Eigen::Matrix3d mass = (Eigen::Matrix3d() << 4, 2, -1, 2, 16, 2, -1, 2, 4).finished() / 30;
  static const Eigen::Matrix3d stiffness = (Eigen::Matrix3d() << 7, -8, 1, -8, 16, -8, 1, -8, 7).finished() / 3;
  const auto x = vertices(side, time, shortest);
  const int cells = static_cast<int>(x.size()) - 1, size = 2 * cells + 1;
  SkinColumn result{MatrixXd::Zero(size, size), MatrixXd::Zero(size, size)};
  for (int cell = 0; cell < cells; ++cell) {
    const double height = x[cell + 1] - x[cell];
    const double conductance = side.conductivity / height, capacity = side.capacity * height;
    result.stiffness.block<3, 3>(2 * cell, 2 * cell) += conductance * stiffness;
    result.mass.block<3, 3>(2 * cell, 2 * cell) += capacity * mass;
  }
  return result;
}

namespace {

using Eigen::VectorXd;

double effusivity(const SkinSide& side) {
  return std::sqrt(side.conductivity * side.capacity);
}

/// Heat through the surface for a jump of 1 K, J/m2, from the sum of the inverse effusivities.
double exact_heat(double inverse_effusivity, double h, double time) {
  const double y = h * inverse_effusivity * std::sqrt(time);
  constexpr double small = 1e-4;
  if (y < small) return h * time * (1 - 4 * y / (3 * std::sqrt(M_PI)));
  return h * time * ((core::erfcx(y) - 1) / (y * y) + 2 / (y * std::sqrt(M_PI)));
}

/// Heat that the unknowns which are `hot`, 1, give up in a time, J/m2: by the conductance h times the `jump` between
/// two surfaces, from the modes of the system, which begins at `start`, K. The sum over the jump keeps its digits where
/// the heat is next to nothing of what the layers hold.
double discrete_heat(const SkinColumn& system, const VectorXd& hot, const VectorXd& start, const VectorXd& jump,
                     double h, double time) {
  const VectorXd scale = system.mass.diagonal().cwiseSqrt().cwiseInverse();
  const MatrixXd mass = scale.asDiagonal() * system.mass * scale.asDiagonal();
  const MatrixXd stiffness = scale.asDiagonal() * system.stiffness * scale.asDiagonal();
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(stiffness, mass);
  const VectorXd across = modes.eigenvectors().transpose() * scale.cwiseProduct(jump);
  const VectorXd amplitude = modes.eigenvectors().transpose() * scale.cwiseProduct(system.mass * start);
  double heat = hot.dot(system.mass * (hot - start));  // taken at the start
  for (Eigen::Index i = 0; i < amplitude.size(); ++i) {
    const double decay = std::max(modes.eigenvalues()[i], 0.0) * time;
    heat += h * across[i] * amplitude[i] * time * (decay > 0 ? -std::expm1(-decay) / decay : 1);
  }
  return heat;
}

/// Heat that one layer gives to surroundings, on its mesh, J/m2.
double discrete_heat(const SkinSide& side, double h, bool prescribed, double time) {
  SkinColumn system = skin_column(side, time, time);
  system.stiffness(0, 0) += h;
  const Eigen::Index n = system.mass.rows();
  const VectorXd hot = VectorXd::Ones(n);
  VectorXd start = hot;
  if (prescribed) start[0] = 0;
  return discrete_heat(system, hot, start, VectorXd::Unit(n, 0), h, time);
}

/// Heat that the first of two layers gives to the second, on their meshes, J/m2.
double discrete_heat(const SkinSide& first, const SkinSide& second, double h, double time) {
  const SkinColumn a = skin_column(first, time, time), b = skin_column(second, time, time);
  const Eigen::Index n = a.mass.rows(), m = b.mass.rows();
  SkinColumn system{MatrixXd::Zero(n + m, n + m), MatrixXd::Zero(n + m, n + m)};
  system.stiffness.topLeftCorner(n, n) = a.stiffness;
  system.stiffness.bottomRightCorner(m, m) = b.stiffness;
  system.mass.topLeftCorner(n, n) = a.mass;
  system.mass.bottomRightCorner(m, m) = b.mass;
  system.stiffness(0, 0) += h;
  system.stiffness(n, n) += h;
  system.stiffness(0, n) -= h;
  system.stiffness(n, 0) -= h;
  VectorXd hot = VectorXd::Zero(n + m);
  hot.head(n).setOnes();
  return discrete_heat(system, hot, hot, VectorXd::Unit(n + m, 0) - VectorXd::Unit(n + m, n), h, time);
}

}  // namespace

double skin_error(const SkinSide& side, double h, double time) {
  if (!(h > 0) || !(time > 0)) return 0;
  const bool prescribed = std::isinf(h);
  h = std::min(h, perfect_conductance(side.conductivity, std::min(side.first_cell, side.depth)));
  const double exact = reaches_back(side, time) ? discrete_heat(fine_side(side), h, prescribed, time)
                                                : exact_heat(1 / effusivity(side), h, time);
  return discrete_heat(side, h, prescribed, time) / exact - 1;
}

double skin_error(const SkinSide& first, const SkinSide& second, double h, double time) {
  if (!(h > 0) || !(time > 0)) return 0;
  h = std::min(h, 1 / (1 / perfect_conductance(first.conductivity, std::min(first.first_cell, first.depth)) +
                       1 / perfect_conductance(second.conductivity, std::min(second.first_cell, second.depth))));
  const double exact = reaches_back(first, time) || reaches_back(second, time)
                           ? discrete_heat(fine_side(first), fine_side(second), h, time)
                           : exact_heat(1 / effusivity(first) + 1 / effusivity(second), h, time);
  return discrete_heat(first, second, h, time) / exact - 1;
}

double perfect_conductance(double conductivity, double thickness) {
  constexpr double negligible = 1e-6;  // of the resistance of the layer
  return conductivity / (negligible * thickness);
}

}  // namespace parison::thermal
