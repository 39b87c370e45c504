// SPDX-License-Identifier: GPL-3.0-or-later
// Glass whose density changes: flows with a source at each quadrature point, against exact solutions.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "figure.hpp"
#include "flow_case.hpp"
#include "quarter_sphere.hpp"

namespace parison::flow {
namespace {

constexpr double radius = 0.01;

core::Mesh sphere(int rings) {
  return tests::quarter_sphere(radius, rings);
}

FlowProblem expanding(core::Mesh mesh, const std::function<double(double)>& rate_at_radius) {
  FlowProblem flow(std::move(mesh), core::Geometry::axisymmetric, 1e4);
  flow.boundary("axes").kind = BoundaryCondition::Kind::symmetry;
  for (Index c = 0; c < flow.mesh.cell_count(); ++c)
    for (const auto& rule : core::triangle_rule(4)) {
      const auto at = core::map_cell_point(flow.mesh, c, core::Geometry::axisymmetric, rule);
      flow.problem.expansion_rate.push_back(rate_at_radius(at.position.norm()));
    }
  return flow;
}

/// Largest error of the velocity at any node, relative to the largest velocity.
double velocity_error(const FlowProblem& flow, const Solution& solution, const std::function<double(double)>& exact) {
  double worst = 0, largest = 0;
  for (Index n = 0; n < flow.mesh.node_count(); ++n) {
    const Point& x = flow.mesh.nodes[n];
    const Point v = x.norm() > 0 ? Point(exact(x.norm()) * x / x.norm()) : Point(0, 0);
    worst = std::max(worst, (node_velocity(solution.velocity, n) - v).norm());
    largest = std::max(largest, v.norm());
  }
  return worst / largest;
}

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(Expansion, glass_that_shrinks_alike_everywhere_keeps_its_shape_without_stress) {
  FlowProblem flow = expanding(sphere(6), [](double) { return -1e-3; });
  flow.problem.viscosity = [](const Point& x) { return 1e3 * std::exp(2e3 * x[0]); };  // 1 : 5e8
  const Solution solution = flow.solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  EXPECT_LT(velocity_error(flow, solution, [](double r) { return -1e-3 * r / 3; }), 1e-10);
  EXPECT_LT(solution.pressure.lpNorm<Eigen::Infinity>(), 1e-6 * 1e3 * 5e8 * 1e-3);
  EXPECT_LT(std::abs(sum_of(solution.dissipation)), 1e-12 * 1e3 * 5e8 * 1e-6 * 2e-6);
}

/// A core that expands at another rate than the shell, straight between both: from `inner` to `outer` radius, m.
struct CoreAndShell {
  double core, shell, inner, outer;

  double rate(double r) const {
    if (r < inner || outer == inner) return r < inner ? core : shell;
    return r > outer ? shell : core + slope() * (r - inner);
  }
  /// v = 1/r2 times the integral of e r2, m/s.
  double velocity(double r) const {
    const double cube = std::pow(std::min(r, inner), 3), between = std::clamp(r, inner, outer);
    double integral = core * cube / 3;
    if (outer > inner)
      integral += (core - slope() * inner) * (std::pow(between, 3) - std::pow(inner, 3)) / 3 +
                  slope() * (std::pow(between, 4) - std::pow(inner, 4)) / 4;
    integral += shell * (std::pow(std::max(r, outer), 3) - std::pow(outer, 3)) / 3;
    return integral / (r * r);
  }

 private:
  double slope() const { return (shell - core) / (outer - inner); }
};

/// Errors of the velocity with 8 and 16 rings of cells.
std::array<double, 2> velocity_errors(const CoreAndShell& field) {
  std::array<double, 2> errors{};
  for (int i = 0; i < 2; ++i) {
    FlowProblem flow = expanding(sphere(8 << i), [&](double r) { return field.rate(r); });
    const Solution solution = flow.solve();
    EXPECT_TRUE(solution.converged) << solution.reason;
    errors[i] = velocity_error(flow, solution, [&](double r) { return field.velocity(r); });
  }
  std::printf("sphere, core to %.1f mm and shell from %.1f mm: velocity off by %.2e, %.2e\n", 1e3 * field.inner,
              1e3 * field.outer, errors[0], errors[1]);
  return errors;
}

TEST(Expansion, a_sphere_of_two_temperatures_has_the_exact_velocity) {
  const auto [coarse, fine] = velocity_errors({-3e-3, -1e-3, radius / 4, 0.75 * radius});
  tests::Figure error("sphere of a cold core and a hot shell, 16 rings of cells: velocity off by");
  error.add(fine);
  error.at_most(1e-4);
  tests::Figure order("the same: order of the velocity in space");
  order.add(std::log2(coarse / fine));
  order.at_least(2.5);
}

TEST(Expansion, where_the_temperature_jumps_the_velocity_is_of_first_order) {
  // The pressure jumps with it, and continuous pressures do not.
  const auto [coarse, fine] = velocity_errors({-3e-3, -1e-3, radius / 2, radius / 2});
  EXPECT_LT(fine, 3e-2);
  EXPECT_GT(std::log2(coarse / fine), 0.9);
}

TEST(Expansion, the_work_of_the_stress_closes_with_sources_and_viscosities_that_vary) {
  FlowProblem flow = expanding(sphere(8), [](double r) { return r < radius / 3 ? 2e-3 : -1e-3; });
  flow.problem.viscosity = [](const Point& x) { return 1e3 * std::exp(1e3 * x[1]); };
  flow.boundary("surface").pressure = 2;
  const Solution solution = flow.solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  double air = 0;
  for (const auto& edge : flow.mesh.boundary_edges())
    for (const auto& rule : core::edge_rule(4)) {
      if (edge.boundary_id != 0) continue;
      const auto at = core::map_edge_point(flow.mesh, edge.nodes, core::Geometry::axisymmetric, rule);
      for (int i = 0; i < 3; ++i)
        air -= 2 * at.area * at.shape[i] * at.normal.dot(node_velocity(solution.velocity, edge.nodes[i]));
    }
  const double dissipated = sum_of(solution.dissipation);
  for (const double power : solution.dissipation) EXPECT_GE(power, -1e-12 * dissipated);
  EXPECT_GT(dissipated, 0);
  EXPECT_NEAR(air, dissipated + solution.expansion_power, 1e-9 * dissipated);
}

}  // namespace
}  // namespace parison::flow
