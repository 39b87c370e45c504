// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "forming/flow/solver.hpp"
#include "structured.hpp"

namespace parison::flow {
namespace {

/// A block of two glasses, one on the other, pressed between slippery plates: the softer one takes all the motion, and
/// the force does not depend on how stiff the other is.
TEST(Extremes, a_viscosity_jump_of_ten_decades_leaves_force_and_work_balance_alone) {
  double first = 0;
  for (const double decades : {4.0, 7.0, 10.0}) {
    const core::Mesh mesh = tests::structured(8, 8, [](double s, double t) { return Point(0.01 * s, 0.01 * t); });
    Material material{};
    material.density = 2400;
    material.viscosity = {2.0, 0, 0, {}};  // log10 eta = A + B/(T - T0)
    material.viscosity.B = decades;
    Eigen::VectorXd temperature(mesh.node_count());
    // T - T0 = 1 K gives the stiff glass, a large one the soft glass.
    for (core::Index n = 0; n < mesh.node_count(); ++n) temperature[n] = mesh.nodes[n][1] > 0.005 ? 1.0 : 1e12;
    Problem problem{};
    problem.mesh = &mesh;
    problem.geometry = core::Geometry::axisymmetric;
    problem.material = &material;
    problem.temperature = &temperature;
    problem.boundary_conditions.resize(mesh.boundaries().size());
    problem.boundary_conditions[3].kind = BoundaryCondition::Kind::symmetry;
    problem.tools.resize(2);
    for (auto& tool : problem.tools) tool.friction.law = Friction::Law::slip;
    problem.tools[1].velocity = -0.01;
    for (const auto& edge : mesh.boundary_edges())
      for (const core::Index node : edge.nodes) {
        if (edge.boundary_id == 0) problem.candidates.push_back({node, 0, Point(0, 1), 0.0});
        if (edge.boundary_id == 2) problem.candidates.push_back({node, 1, Point(0, -1), 0.0});
      }
    const auto solution = Solver(mesh).solve(problem, {});
    ASSERT_TRUE(solution.converged) << solution.reason;
    double work = 0;
    for (const double w : solution.dissipation) work += w;
    const double power = -0.01 * solution.tool_force[1];
    std::printf("jump of 1e%.0f: force %.6f N, dissipation / power - 1 = %.1e\n", decades, solution.tool_force[1],
                work / power - 1);
    EXPECT_NEAR(work, power, 1e-4 * power);
    EXPECT_TRUE(solution.velocity.allFinite());
    if (first != 0) EXPECT_NEAR(solution.tool_force[1], first, 0.01 * std::abs(first));
    first = solution.tool_force[1];
  }
}

TEST(Extremes, frozen_glass_below_its_transition_stays_finite) {
  const Viscosity container{-2.309, 3922, 291 + 273.15, {}};
  for (const double celsius : {-200.0, 0.0, 290.9, 291.0, 291.1, 400.0, 565.0, 1500.0, 3000.0}) {
    EXPECT_TRUE(std::isfinite(container(celsius + 273.15))) << celsius;
    EXPECT_GT(container(celsius + 273.15), 0);
    EXPECT_LE(container.derivative(celsius + 273.15), 0);
  }
  EXPECT_NEAR(std::log10(container(731 + 273.15)), 6.6, 0.02);
  EXPECT_NEAR(container(1200 + 273.15), 101, 1);
  EXPECT_NEAR(container(700 + 273.15), 1.91e7, 0.01e7);
}

}  // namespace
}  // namespace parison::flow
