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
  const auto result = solve_instant(problem, matrix, glass);
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
  const auto result = solve_instant(problem, matrix, glass, expansion);
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
  const auto result = solve_instant(problem, matrix, glass);
  Eigen::VectorXd exact(result.velocity.size());
  for (Index n = 0; n < glass.mesh.node_count(); ++n) {
    const Vector3& x = glass.mesh.nodes[n];
    exact.segment<3>(3 * n) = rate * Vector3(-0.5 * x[0], -0.5 * x[1], x[2]);
  }
  expect_at_most("velocity of a stretched column at an angle", difference(result.velocity, exact), 1e-9);
}

/// Flux and largest speed of a quarter of a duct 2 a by 2 b wide, a and b in mm, under its weight: over those of
/// rho g = 1 N/m3 and 1 Pa.s in a duct of full widths.
std::pair<double, double> duct(Index n, double a, double b) {
  const double length = 1e-3;
  auto material = uniform_glass(1);
  flow::SolidGlass glass = glass_of(hex_block(n, n, 1,
                                              [&](const Vector3& x) -> Vector3 {
                                                return {1e-3 * a * x[0], 1e-3 * b * x[1], length * x[2]};
                                              }),
                                    material);
  flow::SolidProblem problem;
  problem.material = &material;
  problem.gravity = 1 / material.density;
  problem.fixed =
      nodes_where(glass.mesh, [&](const Vector3& x) { return x[0] > 1e-3 * a - 1e-9 || x[1] > 1e-3 * b - 1e-9; });
  for (const int axis : {0, 1}) {
    problem.planes.push_back(plane_of(glass.mesh, Vector3::Unit(axis)));
    problem.planes.push_back({Vector3::Unit(axis), nodes_where(glass.mesh, [&](const Vector3& x) {
                                return x[2] < 1e-9 || x[2] > length - 1e-9;
                              })});
  }
  flow::FlowMatrix matrix(glass.mesh, problem.planes, problem.fixed);
  const auto result = solve_instant(problem, matrix, glass);
  double flux = 0;
  for (const core::HexFace& face : faces_where(glass.mesh, [](const Vector3& x) { return x[2] < 1e-9; })) {
    const auto nodes = core::face_node_numbers(glass.mesh, face);
    for (const auto& at : core::map_hex_face(core::face_nodes(glass.mesh, face), face, 3))
      for (int k = 0; k < 9; ++k) flux += 4 * at.area * at.shape[k] * result.velocity[3 * nodes[k] + 2];
  }
  return {flux / (2e-3 * a * std::pow(2e-3 * b, 3)), result.velocity[2] / std::pow(2e-3 * b, 2)};
}

TEST(SolidPatch, DuctsCarryTheirFlux) {
  for (const auto& [a, flux, speed] :
       {std::tuple{2.0, 0.0351442537, 0.0736713533}, {4.0, 0.0571704193, 0.1138718321}}) {
    double last = 0, order = 0, error = 0;
    for (const Index n : {2, 4, 8}) {
      const auto [q, u] = duct(n, a, 2.0);
      error = std::abs(q / flux - 1);
      if (last > 0) order = std::log2(last / error);
      fmt::print("duct {} n {} flux error {:.2e} order {:.2f} speed error {:.2e}\n", a, n, error, order,
                 std::abs(u / speed - 1));
      last = error;
      if (n == 8) expect_at_most("largest speed in a duct", std::abs(u / speed - 1), 1e-3);
    }
    expect_at_most("flux of a duct, 8 cells a half", error, 1e-4);
    expect_at_least("its order", order, 2.5);
  }
}

}  // namespace
}  // namespace parison::tests
