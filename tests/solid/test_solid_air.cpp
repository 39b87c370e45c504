// SPDX-License-Identifier: GPL-3.0-or-later
// Air sealed in a hollow ball of glass, which it blows up as the flow of a viscous shell says.
#include <gtest/gtest.h>

#include <cmath>

#include "solid/hex_block.hpp"

namespace parison::tests {
namespace {

constexpr double inside = 5e-3, outside = 10e-3;                            ///< radii, m
constexpr double viscosity = 1e4, ambient = 101325;                         ///< Pa.s, Pa
constexpr double volume = M_PI / 6 * inside * inside * inside, dt = 20e-3;  ///< of an octant, m3; s

/// An octant of the ball with its air at 1.5 times the pressure around, after a step.
flow::AirPocketEnd blown(double exponent, double vent) {
  const auto material = uniform_glass(viscosity);
  flow::SolidGlass glass =
      glass_of(octant(4, 3, [](double s) { return inside * std::pow(outside / inside, s); }), material);
  flow::SolidProblem problem;
  problem.material = &material;
  for (int axis = 0; axis < 3; ++axis) problem.planes.push_back(plane_of(glass.mesh, Vector3::Unit(axis)));
  problem.contact_faces = faces_where(glass.mesh, [](const Vector3& x) { return x.norm() < inside + 1e-7; });
  flow::SolidAir air;
  air.ambient = ambient;
  air.dt = dt;
  air.pockets = {{volume, 1.5 * ambient * volume, exponent, vent, {}}};
  air.behind.assign(problem.contact_faces.size(), 0);
  air.tool_rate = {0};
  air.opens_below.assign(problem.contact_faces.size(), 0);
  problem.air = air;
  glass.velocity = Eigen::VectorXd::Zero(3 * glass.mesh.node_count());
  flow::FlowMatrix matrix(glass.mesh, problem.planes, {});
  const flow::SolidStep step = flow::step_flow(problem, matrix, glass, dt);
  EXPECT_TRUE(step.accepted);
  return step.air.at(0);
}

/// Growth of an octant's hollow under a gauge pressure, m3/s: p = 4 eta Q/(4 pi) (1/a3 - 1/b3) for the whole.
double growth(double pressure) {
  return M_PI * pressure / viscosity / (std::pow(inside, -3) - std::pow(outside, -3)) / 8;
}

/// The volume at which the law of the air has the pressure that the flow to it takes, by halving.
double volume_by(const flow::AirPocket& pocket) {
  double low = volume, high = 2 * volume;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const double reached = volume + dt * growth(flow::pressure_at(pocket, ambient, dt, middle).value - ambient);
    (reached > middle ? low : high) = middle;
  }
  return low;
}

TEST(SolidAir, blows_up_a_ball_as_its_law_and_the_flow_of_a_shell_say) {
  for (const double exponent : {1.0, 1.4})
    for (const double vent : {0.0, 0.1 * volume / dt}) {
      const flow::AirPocket pocket{volume, 1.5 * ambient * volume, exponent, vent, {}};
      const double exact = volume_by(pocket);
      const flow::AirPocketEnd end = blown(exponent, vent);
      EXPECT_NEAR(end.volume - volume, exact - volume, 5e-3 * (exact - volume)) << exponent << ' ' << vent;
      const double pressure = flow::pressure_at(pocket, ambient, dt, exact).value;
      const double outflow = vent > 0 ? dt * flow::vent_outflow(vent, pressure, ambient).value : 0;
      EXPECT_NEAR(end.outflow, outflow, 1e-3 * outflow);
      EXPECT_LT(exact, 1.2 * volume);
      EXPECT_GT(exact, 1.02 * volume);
    }
}

}  // namespace
}  // namespace parison::tests
