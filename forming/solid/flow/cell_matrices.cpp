// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/flow/cell_matrices.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace parison::flow {

namespace {

using core::HexRule;
using Gradients = Eigen::Matrix<double, hex_unknowns, Eigen::Dynamic>;

/// Gauss points across the wall by the range of ln eta in a column of nodes: {up to, points}. With fewer, a cell's
/// stiffness is off by more than 1 %.
constexpr std::array<std::pair<double, int>, 4> points_by_range{{{1, 3}, {3, 4}, {5, 6}, {9, 8}}};
constexpr int most_points = 12;

/// ln eta at points with such temperatures and positions (one a column).
Eigen::ArrayXd log_viscosity(const SolidProblem& problem, const Eigen::VectorXd& temperature,
                             const Eigen::Matrix3Xd& position) {
  if (!problem.viscosity) return problem.material->viscosity.logarithm_in_flow(temperature.array());
  Eigen::ArrayXd value(temperature.size());
  for (Index q = 0; q < value.size(); ++q) value[q] = std::log(problem.viscosity(position.col(q)));
  return value;
}

int points_across(const Eigen::ArrayXd& at_nodes) {
  double range = 0;
  for (int column = 0; column < 9; ++column) {
    const auto [least, most] = std::minmax({at_nodes[column], at_nodes[column + 9], at_nodes[column + 18]});
    range = std::max(range, most - least);
  }
  for (const auto& [up_to, points] : points_by_range)
    if (range <= up_to) return points;
  return most_points;
}

/// From the sum of eta times gradients of two shape functions, (3 node + derivative) by the same, to the matrix of
/// 2 eta D:D, less `share` of eta div div: with 2/3 it is that of the deviator.
void fill_viscous(const HexMatrix& sums, double share, HexMatrix& viscous) {
  for (int a = 0; a < 27; ++a)
    for (int b = 0; b <= a; ++b) {
      const Eigen::Matrix3d block = sums.block<3, 3>(3 * a, 3 * b);
      Eigen::Matrix3d filled = block.transpose() - share * block;
      filled.diagonal().array() += block.trace();
      viscous.block<3, 3>(3 * a, 3 * b) = filled;
      viscous.block<3, 3>(3 * b, 3 * a) = filled.transpose();
    }
}

/// Entries of a symmetric tensor by its two indices.
constexpr int entry_of[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};

/// What the stress and the expansion of glass with a memory add to the right-hand sides.
void add_memory(const SolidMemory& memory, Index cell, const Gradients& gradients, const Eigen::ArrayXd& volume,
                const Eigen::Matrix<double, 4, Eigen::Dynamic>& pressure_volume, HexMatrices& result) {
  result.memory_force.setZero();
  for (Index q = 0; q < memory_points; ++q) {
    const auto entries = memory.stress.segment<tensor_entries>(tensor_entries * (memory_points * cell + q));
    Eigen::Matrix3d stress;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) stress(i, j) = entries[entry_of[i][j]];
    const Eigen::Map<const core::HexGradient> gradient(gradients.col(q).data());
    Eigen::Map<core::HexGradient>(result.memory_force.data()) -= volume[q] * stress * gradient;
  }
  result.memory_expansion = pressure_volume * memory.expansion_rate.segment<memory_points>(memory_points * cell);
}

}  // namespace

void compute_cell(const SolidProblem& problem, const CellState& cell, HexMatrices& result) {
  const core::HexNodes& nodes = cell.nodes;
  const int across = problem.memory ? points_along : points_across(log_viscosity(problem, cell.temperature, nodes));
  const HexRule& rule = core::hex_rule(points_along, across);
  const auto count = static_cast<Index>(rule.at.size());
  thread_local Gradients gradients, weighted;
  gradients.resize(hex_unknowns, count);
  Eigen::ArrayXd viscosity;
  if (problem.memory)
    viscosity = problem.memory->viscosity.segment<memory_points>(memory_points * cell.number);
  else
    viscosity = log_viscosity(problem, rule.shape.transpose() * cell.temperature, nodes * rule.shape).exp();
  Eigen::ArrayXd volume(count);
  Eigen::Matrix<double, 4, Eigen::Dynamic> pressure(4, count);
  for (Index q = 0; q < count; ++q) {
    const core::HexPoint point = core::map_hex_point(nodes, rule, static_cast<std::size_t>(q));
    gradients.col(q) = Eigen::Map<const CellVector>(point.gradient.data());
    volume[q] = point.volume;
    if (problem.material->shear_thinning && !problem.memory)
      viscosity[q] *=
          (*problem.material->shear_thinning)(squared_shear_rate(cell.velocity * point.gradient.transpose()));
    pressure.col(q) << 1, rule.at[q].array() - 0.5;
  }
  weighted = gradients * (viscosity * volume).matrix().asDiagonal();
  HexMatrix sums;
  sums.noalias() = weighted * gradients.transpose();
  fill_viscous(sums, problem.memory ? 2.0 / 3 : 0, result.viscous);  // incompressible glass has no other
  const Eigen::Matrix<double, 4, Eigen::Dynamic> pressure_volume = pressure * volume.matrix().asDiagonal();
  result.divergence = pressure_volume * gradients.transpose();
  result.mass = pressure_volume * pressure.transpose();
  result.moment = pressure_volume.rowwise().sum();
  result.mean_viscosity = (viscosity * volume).sum() / volume.sum();
  result.share = rule.shape * volume.matrix() / result.moment[0];
  if (problem.memory) add_memory(*problem.memory, cell.number, gradients, volume, pressure_volume, result);
}

}  // namespace parison::flow
