// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "figure.hpp"
#include "flow_case.hpp"

namespace parison::flow {
namespace {

using core::Geometry;

constexpr double radius = 0.01, viscosity = 100, tension = 0.3;

using Mode = std::function<double(double angle)>;

/// A quarter of a drop of radius R (1 + amplitude mode(angle)), the angle taken from the horizontal; bottom and left
/// are symmetry planes.
FlowProblem drop(Geometry geometry, Index n, double amplitude, const Mode& mode) {
  const auto map = [&](double s, double t) {
    const Point x(s, t);
    const double ring = std::max(s, t);
    if (ring == 0) return x;
    const Point unit = x / x.norm(), place = (1 - ring) * x / std::sqrt(2.0) + ring * ring * unit;
    return Point(radius * (1 + amplitude * mode(std::atan2(t, s))) * place);
  };
  FlowProblem flow(tests::structured(n, n, map), geometry, viscosity);
  flow.boundary("bottom").kind = flow.boundary("left").kind = BoundaryCondition::Kind::symmetry;
  flow.material.surface_tension = tension;
  return flow;
}

/// Rate of growth of a mode's amplitude on the surface of a drop of radius R, 1/s.
double growth(FlowProblem flow, const Mode& mode) {
  const auto solution = flow.solve();
  EXPECT_TRUE(solution.converged) << solution.reason;
  double projected = 0, square = 0;
  for (const auto& edge : flow.mesh.boundary_edges()) {
    if (flow.problem.boundary_conditions[edge.boundary_id].kind != BoundaryCondition::Kind::free) continue;
    for (const auto& rule : core::edge_rule(4)) {
      const auto at = core::map_edge_point(flow.mesh, edge.nodes, flow.problem.geometry, rule);
      const double shape = mode(std::atan2(at.position[1], at.position[0]));
      Point v = Point::Zero();
      for (int i = 0; i < 3; ++i) v += at.shape[i] * node_velocity(solution.velocity, edge.nodes[i]);
      projected += at.area * shape * v.dot(at.position) / at.position.norm();
      square += at.area * shape * shape;
    }
  }
  return projected / square / radius;
}

/// Decay rate from both signs of the amplitude: what is even in it drops out.
void expect_decay(const char* name, Geometry geometry, const Mode& mode, double exact) {
  constexpr double amplitude = 1e-3;
  for (const Index n : {8, 16}) {
    const double rate =
        -(growth(drop(geometry, n, amplitude, mode), mode) - growth(drop(geometry, n, -amplitude, mode), mode)) /
        (2 * amplitude);
    std::printf("%s, %2d elements along the quarter: decays at %.6f 1/s, exact %.6f, off by %.1e\n", name, 2 * n, rate,
                exact, rate / exact - 1);
    tests::expect_at_most(fmt::format("{}, {} elements along the quarter: rate of relaxing off by", name, 2 * n),
                          std::abs(rate / exact - 1), n == 8 ? 1e-3 : 1e-4);
  }
}

TEST(Drop, second_mode_decays_at_the_exact_rate) {
  const auto second = [](double angle) { return 0.5 * (3 * std::pow(std::sin(angle), 2) - 1); };
  expect_decay("drop", Geometry::axisymmetric, second, 20.0 / 19 * tension / (viscosity * radius));
}

TEST(Drop, plane_modes_decay_at_the_exact_rates) {
  for (const int n : {2, 4})
    expect_decay(
        n == 2 ? "plane drop, mode 2" : "plane drop, mode 4", Geometry::planar,
        [=](double angle) { return std::cos(n * angle); }, n * tension / (2 * viscosity * radius));
}

TEST(Drop, a_round_drop_rests_under_its_surface_tension) {
  for (const auto geometry : {Geometry::planar, Geometry::axisymmetric}) {
    auto flow = drop(geometry, 8, 0, [](double) { return 0.0; });
    const auto solution = flow.solve();
    ASSERT_TRUE(solution.converged) << solution.reason;
    const double pressure = (geometry == Geometry::planar ? 1 : 2) * tension / radius;
    const double speed = solution.velocity.lpNorm<Eigen::Infinity>() * viscosity / tension;
    const double off = (solution.pressure.array() / pressure - 1).abs().maxCoeff();
    std::printf("round drop: speed %.1e gamma/eta, pressure off by %.1e\n", speed, off);
    EXPECT_LT(speed, 5e-4);
    EXPECT_LT(off, 2e-3);
  }
}

}  // namespace
}  // namespace parison::flow
