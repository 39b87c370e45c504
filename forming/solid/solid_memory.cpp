// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/solid_memory.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/solid/hex_geometry.hpp"

namespace parison::forming {

namespace {

using cooling::branches;
using flow::memory_points, flow::tensor_entries;

constexpr Index stress_size = Index(tensor_entries) * branches;

/// The stresses of the branches of a point, a column for each.
using PointStress = Eigen::Matrix<double, tensor_entries, branches>;
using Tensor = Eigen::Matrix<double, tensor_entries, 1>;

const core::HexRule& memory_rule() {
  return core::hex_rule(flow::points_along, flow::points_along);
}

Eigen::Map<const PointStress> stress_of(const SolidState& solid, Index point) {
  return Eigen::Map<const PointStress>(solid.branch_stress.data() + stress_size * point);
}

Eigen::Matrix3d matrix_of(const Tensor& t) {
  return (Eigen::Matrix3d() << t[0], t[5], t[4], t[5], t[1], t[3], t[4], t[3], t[2]).finished();
}

Tensor entries_of(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(1, 1), m(2, 2), m(1, 2), m(0, 2), m(0, 1)};
}

core::HexShape of_cell(const core::HexMesh& mesh, Index cell, const Eigen::VectorXd& nodal) {
  core::HexShape own;
  for (int n = 0; n < core::HexMesh::nodes_per_cell; ++n) own[n] = nodal[mesh.cells[cell][n]];
  return own;
}

Eigen::VectorXd at_points(const core::HexMesh& mesh, const Eigen::VectorXd& nodal) {
  Eigen::VectorXd result(memory_points * mesh.cell_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    result.segment<memory_points>(memory_points * cell) = memory_rule().shape.transpose() * of_cell(mesh, cell, nodal);
  return result;
}

/// The rotation of a step of dt, s, with a gradient of the velocity, 1/s.
Eigen::Matrix3d rotation(const Eigen::Matrix3d& gradient, double dt) {
  const Eigen::Matrix3d spin = 0.5 * dt * (gradient - gradient.transpose());
  const core::Vector3 axis(spin(2, 1), spin(0, 2), spin(1, 0));
  const double angle = axis.norm();
  if (angle == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, axis / angle).toRotationMatrix();
}

}  // namespace

void begin_cooling(SolidState& solid) {
  const Eigen::VectorXd here = at_points(solid.glass.mesh, solid.glass.temperature);
  solid.branch_stress = Eigen::VectorXd::Zero(stress_size * here.size());
  solid.fictive_temperature.resize(branches * here.size());
  for (Index k = 0; k < here.size(); ++k)
    solid.fictive_temperature.segment<branches>(branches * k).setConstant(here[k]);
  solid.glass.pressure = Eigen::VectorXd::Zero(4 * solid.glass.mesh.cell_count());
}

SolidMemoryStep start_memory_step(const cooling::GlassLaw& law, const SolidState& solid, const Eigen::VectorXd& before,
                                  double dt) {
  const Eigen::VectorXd from = at_points(solid.glass.mesh, before),
                        to = at_points(solid.glass.mesh, solid.glass.temperature);
  const auto points = static_cast<Index>(from.size());
  SolidMemoryStep step;
  step.relaxation.reserve(static_cast<std::size_t>(points));
  step.flow.bulk = law.bulk_modulus() * dt;
  step.flow.viscosity.resize(points);
  step.flow.expansion_rate.resize(points);
  step.flow.stress.resize(tensor_entries * points);
  for (Index k = 0; k < points; ++k) {
    const auto at =
        cooling::relax(law, solid.fictive_temperature.segment<branches>(branches * k).array(), from[k], to[k], dt);
    step.flow.viscosity[k] = at.modulus.sum() * dt;
    step.flow.expansion_rate[k] = 3 * at.strain / dt;
    step.flow.stress.segment<tensor_entries>(tensor_entries * k) = stress_of(solid, k) * at.kept.matrix();
    step.relaxation.push_back(at);
  }
  return step;
}

void end_memory_step(const SolidMemoryStep& step, const core::HexMesh& middle, double dt, SolidState& solid) {
  for (Index cell = 0; cell < middle.cell_count(); ++cell) {
    const core::HexNodes nodes = core::cell_nodes(middle, cell);
    core::HexNodes velocity;
    for (int n = 0; n < core::HexMesh::nodes_per_cell; ++n)
      velocity.col(n) = solid.glass.velocity.segment<3>(3 * middle.cells[cell][n]);
    for (int q = 0; q < memory_points; ++q) {
      const Index k = memory_points * cell + q;
      const Eigen::Matrix3d gradient =
          velocity * core::map_hex_point(nodes, memory_rule(), static_cast<std::size_t>(q)).gradient.transpose();
      Eigen::Matrix3d strain = 0.5 * dt * (gradient + gradient.transpose());
      strain.diagonal().array() -= strain.trace() / 3;
      const cooling::Relaxation& at = step.relaxation[static_cast<std::size_t>(k)];
      PointStress stress = stress_of(solid, k) * at.kept.matrix().asDiagonal();
      stress += 2 * entries_of(strain) * at.modulus.matrix().transpose();
      const Eigen::Matrix3d turned = rotation(gradient, dt);
      for (int b = 0; b < branches; ++b)
        stress.col(b) = entries_of(turned * matrix_of(stress.col(b)) * turned.transpose());
      Eigen::Map<PointStress>(solid.branch_stress.data() + stress_size * k) = stress;
      solid.fictive_temperature.segment<branches>(branches * k) = at.fictive;
    }
  }
}

namespace {

/// Tensors at the nodes of a cell.
using CellTensors = Eigen::Matrix<double, tensor_entries, memory_points>;

/// At the nodes of a cell: the function through its points.
CellTensors stress_in_cell(const SolidState& solid, Index cell) {
  static const Eigen::Matrix<double, memory_points, memory_points> to_nodes =
      Eigen::Matrix<double, memory_points, memory_points>(memory_rule().shape).inverse();
  const Eigen::Vector4d pressure = solid.glass.pressure.segment<4>(4 * cell);
  CellTensors own;
  for (int q = 0; q < memory_points; ++q) {
    own.col(q) = stress_of(solid, memory_points * cell + q).rowwise().sum();
    const core::Vector3 place = memory_rule().at[static_cast<std::size_t>(q)].array() - 0.5;
    own.col(q).head<3>().array() -= pressure[0] + pressure.tail<3>().dot(place);
  }
  return own * to_nodes;
}

/// The part of a function along a column of nodes that is straight in a cell: there it converges fastest.
struct Straight {
  double middle, half;  ///< m along the column
  Tensor mean, slope;   ///< at the middle, by m
};

/// A quadratic function, 1, x, x^2 in its columns.
using Quadratic = Eigen::Matrix<double, tensor_entries, 3>;

Tensor value(const Quadratic& function, double at) {
  return function * Eigen::Vector3d(1, at, at * at);
}

/// The one whose straight parts in two cells are nearest to those given.
Quadratic nearest(const Straight& a, const Straight& b) {
  Eigen::Matrix<double, 4, 3> of_function;
  Eigen::Matrix<double, 4, tensor_entries> given;
  int row = 0;
  for (const Straight* one : {&a, &b}) {
    const double m = one->middle, share = std::sqrt(one->half), by_slope = share * one->half / std::sqrt(3.0);
    of_function.row(row) << share, share * m, share * (m * m + one->half * one->half / 3);
    given.row(row++) = share * one->mean.transpose();
    of_function.row(row) << 0, by_slope, by_slope * 2 * m;
    given.row(row++) = by_slope * one->slope.transpose();
  }
  return of_function.colPivHouseholderQr().solve(given).transpose();
}

/// Values at the nodes of a column through the cells, from the inner side on.
std::vector<Tensor> along_column(const std::vector<Straight>& cells) {
  std::vector<Tensor> values;
  const auto at_end = [](const Straight& cell, double side) {
    return Tensor(cell.mean + side * cell.half * cell.slope);
  };
  if (cells.size() == 1) return {at_end(cells[0], -1), cells[0].mean, at_end(cells[0], 1)};
  std::vector<Quadratic> between;  // around each place where two cells meet
  for (std::size_t i = 0; i + 1 < cells.size(); ++i) between.push_back(nearest(cells[i], cells[i + 1]));
  values.push_back(value(between.front(), cells.front().middle - cells.front().half));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Quadratic &below = between[i > 0 ? i - 1 : 0], &above = between[std::min(i, between.size() - 1)];
    values.push_back(0.5 * (value(below, cells[i].middle) + value(above, cells[i].middle)));
    values.push_back(value(above, cells[i].middle + cells[i].half));
  }
  return values;
}

}  // namespace

NodalTensors nodal_stress(const SolidState& solid) {
  const core::HexMesh& mesh = solid.glass.mesh;
  NodalTensors sum = NodalTensors::Zero(tensor_entries, mesh.node_count());
  Eigen::VectorXd times = Eigen::VectorXd::Zero(mesh.node_count());
  for (const std::vector<Index>& stack : solid.stacks) {
    std::vector<CellTensors> in_cells;
    for (const Index cell : stack) in_cells.push_back(stress_in_cell(solid, cell));
    constexpr int columns = 9;
    for (int column = 0; column < columns; ++column) {
      std::vector<Straight> cells;
      std::vector<Index> nodes{mesh.cells[stack.front()][column]};
      double from = 0;
      for (std::size_t i = 0; i < stack.size(); ++i) {
        const auto& numbers = mesh.cells[stack[i]];
        const int middle = column + columns, end = middle + columns;
        const double length = (mesh.nodes[numbers[end]] - mesh.nodes[numbers[column]]).norm();
        const CellTensors& own = in_cells[i];
        cells.push_back({from + 0.5 * length, 0.5 * length, (own.col(column) + 4 * own.col(middle) + own.col(end)) / 6,
                         (own.col(end) - own.col(column)) / length});
        from += length;
        nodes.push_back(numbers[middle]);
        nodes.push_back(numbers[end]);
      }
      const std::vector<Tensor> values = along_column(cells);
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        sum.col(nodes[i]) += values[i];
        ++times[nodes[i]];
      }
    }
  }
  return sum * times.cwiseInverse().asDiagonal();
}

double largest_principal(const Eigen::Matrix<double, flow::tensor_entries, 1>& stress) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(matrix_of(stress), Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[2];
}

}  // namespace parison::forming
