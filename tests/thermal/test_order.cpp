// SPDX-License-Identifier: GPL-3.0-or-later
// Temperature linear between the vertices: Problem::order 1.

#include <gtest/gtest.h>

#include "thermal/bodies.hpp"
#include "thermal/time/ida.hpp"
#include "thermal/time/tr_bdf2.hpp"
#include "thermal/varying.hpp"

namespace parison::thermal::test {
namespace {

using core::Geometry;

/// Largest difference between a mid-side value and the mean of its ends.
double off_the_line(const core::Mesh& mesh, const Eigen::VectorXd& nodal) {
  return (nodal - core::from_vertices(mesh, nodal.head(mesh.vertex_count()))).lpNorm<Eigen::Infinity>();
}

TEST(LinearTemperature, the_error_falls_with_the_second_power_of_the_element_size_for_varying_properties) {
  const Varying v;
  const double time = 0.3;
  std::vector<double> errors;
  for (const int n : {8, 16, 32}) {
    const core::Mesh mesh = rectangle(divide(0, v.side, n, std::pow(2, 1.0 / n)), divide(0, v.side, n));
    Problem problem = v.problem(mesh);
    problem.order = 1;
    StepOptions options;
    options.tolerance = 1e-2;
    StepMatrix matrix;
    const auto start = sample(mesh, [&](const Point& x) { return v.exact(x, 0); });
    const StepOutcome outcome = advance(problem, 0, {start}, time, options, matrix);
    ASSERT_TRUE(outcome.converged) << outcome.reason;
    EXPECT_LT(off_the_line(mesh, outcome.temperature[0]), 1e-10);
    const auto exact = [&](const Point& x) { return v.exact(x, time); };
    errors.push_back(distance(mesh, Geometry::planar, outcome.temperature[0], exact));
  }
  std::printf("errors %.3e %.3e %.3e K: orders %.2f %.2f\n", errors[0], errors[1], errors[2],
              std::log2(errors[0] / errors[1]), std::log2(errors[1] / errors[2]));
  EXPECT_GT(std::log2(errors[0] / errors[1]), 1.8);
  EXPECT_GT(std::log2(errors[1] / errors[2]), 1.9);
}

/// Slave above master on a level line, each with its own division of it: points on the common boundaries.
std::vector<core::InterfacePoint> facing(const core::Mesh& slave, const core::Mesh& master, Geometry geometry) {
  const auto edges = [](const core::Mesh& mesh, Index boundary) {
    std::vector<core::BoundaryEdge> found;
    for (const auto& edge : mesh.boundary_edges())
      if (edge.boundary_id == boundary) found.push_back(edge);
    return found;
  };
  std::vector<core::InterfacePoint> points;
  for (const auto& upper : edges(slave, bottom))
    for (const auto& lower : edges(master, top)) {
      const double a = slave.nodes[upper.nodes[0]][0], b = slave.nodes[upper.nodes[1]][0];
      const double c = master.nodes[lower.nodes[1]][0], d = master.nodes[lower.nodes[0]][0];
      const double from = std::max(a, c), to = std::min(b, d);
      for (const auto& at : core::edge_rule(3)) {
        if (to - from < 1e-9) continue;
        const double x = from + at.s * (to - from);
        const Point place(x, 0);
        points.push_back({0, 1, upper.nodes, lower.nodes, core::edge_shape((x - a) / (b - a)),
                          core::edge_shape((d - x) / (d - c)), place,
                          at.weight * (to - from) * core::depth(geometry, place), 0, 1, 1e5, 0});
      }
    }
  return points;
}

TEST(LinearTemperature, a_steady_linear_temperature_crosses_a_non_matching_contact_exactly) {
  const Material glass{2500, core::constant(1300), core::constant(1.3), {}};
  const Material iron{7200, core::constant(490), core::constant(46), {}};
  const double high = 0.01, low = 0.02, h = 3000, hot = 1400, cold = 700;
  for (const Geometry geometry : {Geometry::planar, Geometry::axisymmetric}) {
    const core::Mesh upper = rectangle(divide(0, 0.02, 7), divide(0, high, 3));
    const core::Mesh lower = rectangle(divide(0, 0.02, 4, 1.3), divide(-low, 0, 3));
    Problem problem{geometry, {body(upper, glass), body(lower, iron)}, {}, constant_conductance(h), 1};
    problem.bodies[0].prescribed[top] = hot;
    problem.bodies[1].prescribed[bottom] = cold;
    problem.interface = facing(upper, lower, geometry);
    const double flux = (hot - cold) / (high / 1.3 + 1 / h + low / 46);
    const std::vector<Eigen::VectorXd> exact{
        sample(upper, [&](const Point& x) { return hot - flux * (high - x[1]) / 1.3; }),
        sample(lower, [&](const Point& x) { return cold + flux * (low + x[1]) / 46; })};
    StepMatrix matrix;
    const std::vector<Eigen::VectorXd> start{Eigen::VectorXd::Constant(upper.node_count(), hot),
                                             Eigen::VectorXd::Constant(lower.node_count(), cold)};
    StepOptions options;
    options.tolerance = 1e9;
    const StepOutcome outcome = advance(problem, 0, start, 1e9, options, matrix);
    ASSERT_TRUE(outcome.converged) << outcome.reason;
    const StepOutcome steady = advance(problem, 0, outcome.temperature, 1e9, options, matrix);
    for (int b = 0; b < 2; ++b) EXPECT_LT((steady.temperature[b] - exact[b]).lpNorm<Eigen::Infinity>(), 1e-8);
    const double area = geometry == Geometry::planar ? 0.02 : M_PI * 0.02 * 0.02;
    EXPECT_NEAR(steady.balance.pairs[0].heat / (flux * area * 1e9), 1, 1e-10);
  }
}

TEST(LinearTemperature, the_balance_closes_and_both_integrators_agree) {
  const Varying v;
  const core::Mesh mesh = rectangle(divide(0, v.side, 8), divide(0, v.side, 8));
  Problem problem = v.problem(mesh);
  problem.order = 1;
  problem.bodies[0].prescribed[right] = problem.bodies[0].prescribed[top] = std::nullopt;
  problem.bodies[0].exchange[right] = SurfaceExchange{500, 400, 0.8, 400};
  const std::vector<double> source(6 * mesh.cells().size(), 0.4);
  problem.bodies[0].source = &source;
  const auto linear = [&](const Eigen::VectorXd& nodal) {
    return core::from_vertices(mesh, nodal.head(mesh.vertex_count()));
  };
  const auto start = linear(sample(mesh, [&](const Point& x) { return v.exact(x, 0); }));
  StepOptions options;
  options.tolerance = 1e-3;
  StepMatrix matrix;
  const StepOutcome outcome = advance(problem, 0, {start}, 1.0, options, matrix);
  ASSERT_TRUE(outcome.converged) << outcome.reason;
  const double held = heat_content(problem.bodies[0], problem.geometry, start);
  const double kept = heat_content(problem.bodies[0], problem.geometry, outcome.temperature[0]);
  EXPECT_NEAR(outcome.balance.bodies[0].content_change / (kept - held), 1, 1e-10);
  EXPECT_LT(std::abs(imbalance(outcome.balance, 0)), 1e-9 * std::abs(held));
  IdaIntegrator integrator(problem, 0, {start}, {1e-4});
  const IdaOutcome other = integrator.advance_to(1.0);
  ASSERT_TRUE(other.converged) << other.reason;
  EXPECT_LT((other.temperature[0] - outcome.temperature[0]).lpNorm<Eigen::Infinity>(), 0.02);
  EXPECT_LT(off_the_line(mesh, other.temperature[0]), 1e-10);
}

}  // namespace
}  // namespace parison::thermal::test
