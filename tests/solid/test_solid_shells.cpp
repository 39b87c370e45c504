// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/math/numbers.hpp"
#include "figure.hpp"
#include "solid/hex_block.hpp"

namespace parison::tests {
namespace {

constexpr double inner = 10e-3, outer = 13e-3;  ///< m

/// An octant of a sphere's shell under an inner pressure of 1 Pa over a viscosity of 1 Pa.s.
struct Shell {
  flow::Material material = uniform_glass(1);
  flow::SolidGlass glass;
  flow::SolidProblem problem;

  explicit Shell(Index n, Index layers = 1)
      : glass(glass_of(octant(n, layers, [](double s) { return inner + (outer - inner) * s; }), material)) {
    problem.material = &material;
    for (int axis = 0; axis < 3; ++axis) problem.planes.push_back(plane_of(glass.mesh, Vector3::Unit(axis)));
    problem.pressures = {{faces_where(glass.mesh, [](const Vector3& x) { return x.norm() < inner + 1e-6; }), 1.0}};
  }
};

TEST(SolidShell, SpeedOfASphereIsRightAtTheOrderOfTheElement) {
  double last = 0, order = 0, error = 0;
  for (const Index n : {1, 2, 4}) {
    Shell shell(n, n);
    flow::FlowMatrix matrix(shell.glass.mesh, shell.problem.planes, {});
    const auto result = solve_instant(shell.problem, matrix, shell.glass);
    const double speed = result.velocity.head<3>().norm(), outside = result.velocity.tail<3>().norm();
    error = std::max(std::abs(speed / 4.588554720e-3 - 1), std::abs(outside / 2.715121136e-3 - 1));
    if (last > 0) order = std::log2(last / error);
    fmt::print("n {} speeds {:.9f} {:.9f} mm/s error {:.2e} order {:.2f} solutions {}\n", n, 1e3 * speed, 1e3 * outside,
               error, order, result.solutions);
    last = error;
  }
  expect_at_most("speed of a sphere's shell, 4 cells a third of a quarter", error, 1e-3);
  expect_at_least("its order", order, 3);
}

/// A slice of a tube, 15 degrees wide, whose layers are each `ratio` times as thick as the next one outwards.
core::HexMesh tube(Index around, Index layers, double ratio, double angle = M_PI / 12, double height = 1e-3) {
  double sum = 0;
  for (Index k = 0; k < layers; ++k) sum += std::pow(ratio, double(k));
  return hex_block(around, 1, layers, [&](const Vector3& x) -> Vector3 {
    double radius = inner;
    for (Index k = 0; k < layers; ++k)
      radius +=
          (outer - inner) * std::clamp(x[2] * layers - k, 0.0, 1.0) * std::pow(ratio, double(layers - 1 - k)) / sum;
    const double at = angle * x[0];
    return {radius * std::cos(at), radius * std::sin(at), height * x[1]};
  });
}

/// Its conditions in plane strain.
flow::SolidProblem tube_problem(const flow::Material& material, const core::HexMesh& mesh, double angle = M_PI / 12,
                                double height = 1e-3) {
  flow::SolidProblem problem;
  problem.material = &material;
  problem.planes = {plane_of(mesh, Vector3::Unit(1)),
                    plane_of(mesh, {-std::sin(angle), std::cos(angle), 0}),
                    plane_of(mesh, Vector3::Unit(2)),
                    {Vector3::Unit(2), nodes_where(mesh, [=](const Vector3& x) { return x[2] > height - 1e-9; })}};
  problem.pressures = {{faces_where(mesh, [](const Vector3& x) { return x.head<2>().norm() < inner + 1e-6; }), 1.0}};
  return problem;
}

TEST(SolidShell, ATubeWithAColdSkinWidensAsExactly) {
  struct Case {
    double decades, speed;  // inner, mm/s
  };
  Figure error("inner speed of a tube with a skin 1e4 as stiff, 3 layers");
  for (const auto& [decades, speed] : {Case{0, 12.24637681}, {2, 2.45792587}, {4, 0.0716139341}, {6, 0.00115001598}})
    for (const auto& [layers, ratio] : {std::pair<Index, double>{1, 1}, {2, 1}, {2, 3}, {3, 2}}) {
      const auto material = uniform_glass(1);
      flow::SolidGlass glass = glass_of(tube(2, layers, ratio), material);
      flow::SolidProblem problem = tube_problem(material, glass.mesh);
      problem.viscosity = [d = decades](const Vector3& x) {
        return d == 0 ? 1 : std::pow(10, d * std::exp(-(outer - x.head<2>().norm()) / 0.6e-3));
      };
      flow::FlowMatrix matrix(glass.mesh, problem.planes, {});
      const auto result = solve_instant(problem, matrix, glass);
      const double measured = 1e3 * result.velocity.head<3>().norm();
      fmt::print("decades {} layers {}:{} speed {:.8f} error {:+.4f} % solutions {}\n", decades, layers, ratio,
                 measured, 100 * (measured / speed - 1), result.solutions);
      if (decades == 4 && layers == 3) error.add(std::abs(measured / speed - 1));
    }
  error.at_most(1e-3);
}

/// Time, s, in which the inner radius of an inflated octant grows from 10 to 20 mm in so many steps; the largest error
/// of a cell's volume.
std::pair<double, double> inflation_time(Index n, int steps) {
  Shell shell(n, 2);
  const double exact = 0.86354265488;
  flow::FlowMatrix matrix(shell.glass.mesh, shell.problem.planes, {});
  double time = 0, volume_error = 0, last = inner;
  while (true) {
    const double dt = exact / steps;
    const flow::SolidStep step = flow::step_flow(shell.problem, matrix, shell.glass, dt);
    EXPECT_TRUE(step.accepted);
    if (!step.accepted) break;
    volume_error = std::max(volume_error, step.volume_error);
    const double radius = shell.glass.mesh.nodes[0].norm();
    if (radius >= 2 * inner) return {time + dt * std::log(2 * inner / last) / std::log(radius / last), volume_error};
    last = radius;
    time += dt;
  }
  return {core::none, 0};
}

TEST(SolidShell, InflationIsOfSecondOrderInTheStepAndKeepsEachVolume) {
  double last = 0, order = 0;
  Figure volume("volume of a cell over an inflation");
  for (const int steps : {16, 32, 64}) {
    const auto [time, error] = inflation_time(2, steps);
    if (last > 0) order = std::log2(std::abs(last - 0.86354265488) / std::abs(time - 0.86354265488));
    fmt::print("steps {} time {:.9f} error {:.2e} order {:.2f} volume {:.1e}\n", steps, time, time / 0.86354265488 - 1,
               order, error);
    last = time;
    volume.add(error);
  }
  volume.at_most(1e-9);
  expect_at_most("time of an inflation in 64 steps", std::abs(last / 0.86354265488 - 1), 2e-4);
  expect_at_least("its order in the step", order, 1.8);
}

TEST(SolidShell, SurfaceTensionShrinksABallAsItsPressureDoes) {
  // On the outside of a shell it is a pressure of 2 sigma/R there, the same as a suction within.
  double last = 0, order = 0, error = 0;
  for (const Index n : {1, 2, 4}) {
    Shell shell(n, n);
    shell.material.surface_tension = 0.3;
    shell.problem.pressures.clear();
    shell.problem.open_faces = faces_where(shell.glass.mesh, [](const Vector3& x) { return x.norm() > outer - 1e-6; });
    flow::FlowMatrix matrix(shell.glass.mesh, shell.problem.planes, {});
    const auto result = solve_instant(shell.problem, matrix, shell.glass);
    const double suction = 2 * 0.3 / outer;
    error = std::abs(result.velocity.head<3>().norm() / (4.588554720e-3 * suction) - 1);
    EXPECT_LT(result.velocity[0] + result.velocity[1] + result.velocity[2], 0);
    if (last > 0) order = std::log2(last / error);
    fmt::print("n {} error {:.2e} order {:.2f}\n", n, error, order);
    last = error;
  }
  expect_at_most("speed by surface tension, 4 cells a third of a quarter", error, 1e-3);
  expect_at_least("its order", order, 2);
}

}  // namespace
}  // namespace parison::tests
