// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "figure.hpp"
#include "solid/hex_block.hpp"

namespace parison::tests {
namespace {

/// A box of 10 mm whose cells are bent inside; its faces stay plane.
core::HexMesh bent_box(Index n) {
  return hex_block(n, n, n, [](const Vector3& x) -> Vector3 {
    const double bulge = 0.06 * std::sin(M_PI * x[0]) * std::sin(M_PI * x[1]) * std::sin(M_PI * x[2]);
    return 10e-3 * (x + bulge * Vector3(1, -0.7, 0.5));
  });
}

/// Largest difference of two velocities as a share of the largest speed.
double difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

TEST(SolidPatch, CellsOfAnyShapeStretchEvenlyUnderAnEvenTraction) {
  // Axial stress t on the top of a free column: dw/dz = t/(3 eta), and -half of that across.
  const double viscosity = 700, traction = 2e4, rate = traction / (3 * viscosity);
  const auto material = uniform_glass(viscosity);
  flow::SolidGlass glass = glass_of(bent_box(2), material);
  flow::SolidProblem problem;
  problem.material = &material;
  for (int axis = 0; axis < 3; ++axis) problem.planes.push_back(plane_of(glass.mesh, Vector3::Unit(axis)));
  problem.pressures = {{faces_where(glass.mesh, [](const Vector3& x) { return x[2] > 10e-3 - 1e-9; }), -traction}};
  flow::FlowMatrix matrix(glass.mesh, problem.planes, {});
  const auto result = flow::solve_instant(problem, matrix, glass);
  Eigen::VectorXd exact(result.velocity.size());
  for (Index n = 0; n < glass.mesh.node_count(); ++n) {
    const Vector3& x = glass.mesh.nodes[n];
    exact.segment<3>(3 * n) = rate * Vector3(-0.5 * x[0], -0.5 * x[1], x[2]);
  }
  Figure velocity("velocity of a stretched column of bent cells"), pressure("its pressure");
  velocity.add(difference(result.velocity, exact));
  for (Index cell = 0; cell < glass.mesh.cell_count(); ++cell) {
    pressure.add(std::abs(result.pressure[4 * cell] / (-traction / 3) - 1));
    for (int k = 1; k < 4; ++k) pressure.add(std::abs(result.pressure[4 * cell + k] / traction));
  }
  velocity.at_most(1e-9);
  pressure.at_most(1e-9);
}

TEST(SolidPatch, ADensityThatFallsSwellsTheBoxEvenly) {
  const auto material = uniform_glass(50);
  flow::SolidGlass glass = glass_of(bent_box(2), material);
  flow::SolidProblem problem;
  problem.material = &material;
  for (int axis = 0; axis < 3; ++axis) problem.planes.push_back(plane_of(glass.mesh, Vector3::Unit(axis)));
  flow::FlowMatrix matrix(glass.mesh, problem.planes, {});
  const double expansion = 0.03;
  const auto result =
      flow::solve_instant(problem, matrix, glass, Eigen::VectorXd::Constant(glass.mesh.cell_count(), expansion));
  Eigen::VectorXd exact(result.velocity.size());
  for (Index n = 0; n < glass.mesh.node_count(); ++n) exact.segment<3>(3 * n) = expansion / 3 * glass.mesh.nodes[n];
  expect_at_most("velocity of a box that swells", difference(result.velocity, exact), 1e-9);
}

TEST(SolidPatch, PlanesAtAnyAngleCarryTheSameGlass) {
  // The column turned about the axis: its planes are no axes of space.
  const double viscosity = 700, traction = 2e4, rate = traction / (3 * viscosity);
  const auto material = uniform_glass(viscosity);
  core::HexMesh mesh = bent_box(1);
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() << std::cos(0.3), -std::sin(0.3), std::sin(0.3), std::cos(0.3);
  for (auto& x : mesh.nodes) x = turn * x;
  flow::SolidGlass glass = glass_of(mesh, material);
  flow::SolidProblem problem;
  problem.material = &material;
  for (int axis = 0; axis < 3; ++axis) problem.planes.push_back(plane_of(glass.mesh, turn.col(axis)));
  problem.pressures = {{faces_where(glass.mesh, [](const Vector3& x) { return x[2] > 10e-3 - 1e-9; }), -traction}};
  flow::FlowMatrix matrix(glass.mesh, problem.planes, {});
  const auto result = flow::solve_instant(problem, matrix, glass);
  Eigen::VectorXd exact(result.velocity.size());
  for (Index n = 0; n < glass.mesh.node_count(); ++n) {
    const Vector3& x = glass.mesh.nodes[n];
    exact.segment<3>(3 * n) = rate * Vector3(-0.5 * x[0], -0.5 * x[1], x[2]);
  }
  expect_at_most("velocity of a stretched column at an angle", difference(result.velocity, exact), 1e-9);
}

}  // namespace
}  // namespace parison::tests
