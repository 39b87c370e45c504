// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "figure.hpp"
#include "flow_case.hpp"

namespace parison::flow {
namespace {

using core::Geometry;

constexpr double viscosity = 1e3, height = 0.01, speed = 0.01;

/// Force on a disc of the given radius between plates that close on it.
double squeezing_force(Friction::Law law, double radius, Index along, Index across) {
  // Rows and columns narrow towards the plates and the rim.
  const auto map = [=](double s, double t) {
    const double z = 2 * t - 1;
    return Point(radius * s * (2 - s), height * 0.5 * (1 + z * (1.5 - 0.5 * z * z)));
  };
  FlowProblem flow(tests::structured(along, across, map), Geometry::axisymmetric, viscosity);
  flow.boundary("left").kind = BoundaryCondition::Kind::symmetry;
  flow.problem.tools.resize(2);
  for (auto& tool : flow.problem.tools) tool.friction.law = law;
  flow.problem.tools[1].velocity = -speed;
  flow.touch("bottom", 0, Point(0, 1));
  flow.touch("top", 1, Point(0, -1));
  const auto solution = flow.solve();
  EXPECT_TRUE(solution.converged) << solution.reason;
  EXPECT_NEAR(solution.tool_force[0], -solution.tool_force[1], 1e-9 * solution.tool_force[0]);
  double work = 0;
  for (const double w : solution.dissipation) work += w;
  EXPECT_NEAR(work, solution.tool_force[0] * speed, 2e-6 * work);  // the bulk viscosity takes its share in thin films
  return solution.tool_force[0];
}

TEST(Squeeze, a_sticking_disc_tends_to_the_thin_film_force) {
  for (const double slender : {1.0, 2.0, 5.0, 10.0, 20.0, 40.0, 80.0}) {
    const double radius = slender * height;
    const double thin = 1.5 * M_PI * viscosity * speed * std::pow(radius, 4) / std::pow(height, 3);
    const double ratio = squeezing_force(Friction::Law::stick, radius, std::max(16, int(2 * slender)), 8) / thin;
    std::printf("sticking disc, radius %4.0f heights: force %.5f of the thin film's\n", slender, ratio);
    if (slender < 10) EXPECT_GT(ratio, 1);
    if (slender >= 10)
      EXPECT_LT(std::abs(ratio - 1), 0.2 / slender);  // the film's own error is of the order of height over radius
  }
}

TEST(Squeeze, a_slipping_disc_needs_the_exact_force_at_every_height) {
  tests::Figure force("disc squeezed with slip, radius 1 to 100 heights: force off by");
  for (const double slender : {1.0, 10.0, 100.0}) {
    const double radius = slender * height, exact = 3 * viscosity * speed * M_PI * radius * radius / height;
    force.add(std::abs(squeezing_force(Friction::Law::slip, radius, 8, 4) / exact - 1));
  }
  force.at_most(1e-9);
}

}  // namespace
}  // namespace parison::flow
