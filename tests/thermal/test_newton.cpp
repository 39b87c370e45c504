// SPDX-License-Identifier: GPL-3.0-or-later
// The full derivative of the heat equations, and Newton's method with it.
#include <gtest/gtest.h>

#include <random>

#include "thermal/bodies.hpp"
#include "thermal/time/stage_solver.hpp"
#include "thermal/time/step_matrix.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::thermal::test {
namespace {

using core::Geometry;

/// h over the viscosity of container glass: x = scale / eta^power, h = 500 + 19500 x/(1 + x).
core::Conductance softening(double T, double scale, double power) {
  const double above = T - 273.15 - 291, eta = std::pow(10, -2.309 + 3922 / above);
  const double dlog_eta = -std::log(10.0) * 3922 / (above * above), x = scale * std::pow(eta, -power);
  return {500 + 19500 * x / (1 + x), -19500 * x / ((1 + x) * (1 + x)) * power * dlog_eta};
}

/// Glass with internal radiation on iron, everything that depends on temperature present.
struct HotPair {
  Material glass{2400, {{300, 1800}, {900, 1500}}, {{300, 1800}, {1.0, 1.8}}, Radiation{1.518, 150, false}};
  Material iron{7200, {{300, 1800}, {450, 700}}, {{300, 1800}, {50, 30}}, {}};
  core::Mesh upper = rectangle(divide(0, 0.02, 5), divide(0, 0.004, 5, 1.3)), lower;
  Problem problem;
  std::vector<Eigen::VectorXd> start;

  HotPair(Geometry geometry, double scale, double power) {
    std::vector<double> below = divide(0, -0.01, 5, 1.3);
    std::reverse(below.begin(), below.end());
    lower = rectangle(divide(0, 0.02, 5), below);
    problem = {geometry, {body(upper, glass), body(lower, iron)}, {}, {}};
    for (BodyView& each : problem.bodies)
      for (auto& exchange : each.exchange) exchange = SurfaceExchange{40, 320, 0.8, 320};
    problem.interface = stack(upper, lower, geometry);
    for (auto& point : problem.interface) point.contact_weight = 0.7;
    problem.law = pointwise([=](const core::InterfacePoint&, double T) { return softening(T, scale, power); });
    start = {Eigen::VectorXd::Constant(upper.node_count(), 1400), Eigen::VectorXd::Constant(lower.node_count(), 740)};
  }
  HotPair(const HotPair&) = delete;
};

TEST(Newton, the_derivative_of_the_whole_residual_is_that_of_finite_differences) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  const double step = 0.05, small = 1e-3;
  for (const Geometry geometry : {Geometry::planar, Geometry::axisymmetric}) {
    const HotPair pair(geometry, 20, 0.5);
    const HeatSystem system = make_heat_system(pair.problem);
    Eigen::VectorXd T = join(system, pair.start), direction(system.size());
    for (Index i = 0; i < system.size(); ++i) T[i] += 150 * unit(random), direction[i] = unit(random);
    const auto residual = [&](double shift) -> Eigen::VectorXd {
      const Response response = evaluate(system, 0, T + shift * direction);
      return response.content - step * response.power;
    };
    const Eigen::VectorXd difference = (residual(small) - residual(-small)) / (2 * small);
    Linearisation derivatives = linearise(system, 0, T);
    const Eigen::VectorXd product = apply(system, derivatives, step, direction);
    const double size = difference.lpNorm<Eigen::Infinity>();
    EXPECT_LT((product - difference).lpNorm<Eigen::Infinity>(), 1e-7 * size);
    derivatives.contacts.conductance.setZero();
    EXPECT_GT((apply(system, derivatives, step, direction) - product).lpNorm<Eigen::Infinity>(), 1e-3 * size);
    for (BatchDerivatives& batch : derivatives.batches) batch.flow_a = batch.flow_b = {};
    EXPECT_GT((apply(system, derivatives, step, direction) - product).lpNorm<Eigen::Infinity>(), 1e-3 * size);
  }
}

/// A conductance that collapses as the glass stiffens, from hot to cold in one stage.
StageSolution collapse(double power, double step) {
  const HotPair pair(Geometry::axisymmetric, std::pow(2e3, power), power);
  const HeatSystem system = make_heat_system(pair.problem);
  StepMatrix matrix;
  prepare(matrix, system);
  const Eigen::VectorXd start = join(system, pair.start);
  const Response at_start = evaluate(system, 0, start);
  const StageEquation equation{0, step, at_start.content};
  EXPECT_TRUE(factorise(matrix, system, 0, start, step));
  StageSolution stage = solve_stage(system, matrix, equation, {start, at_start.content, at_start.power}, 1e-6);
  EXPECT_TRUE(stage.converged) << "power " << power << ", step " << step;
  const Response response = evaluate(system, 0, stage.temperature);
  const Eigen::VectorXd left = response.content - step * response.power - equation.target;
  EXPECT_LT(matrix.cholesky.solve(left).lpNorm<Eigen::Infinity>(), 1e-5);
  return stage;
}

TEST(Newton, a_collapsing_conductance_is_solved_in_one_stage_of_any_length) {
  for (const double power : {0.25, 1.0, 2.0, 4.0})
    for (const double step : {0.01, 1.0, 10.0}) {
      const StageSolution stage = collapse(power, step);
      std::printf("h over viscosity to the power %g, %g s: %d solves, %d updates with the full derivative\n", power,
                  step, stage.solves, stage.full_updates);
      EXPECT_LT(stage.solves, 100);
    }
}

TEST(Newton, the_full_derivative_is_used_where_the_factor_stalls_and_only_there) {
  EXPECT_EQ(collapse(0.25, 0.01).full_updates, 0);
  EXPECT_GT(collapse(2.0, 10.0).full_updates, 0);
}

}  // namespace
}  // namespace parison::thermal::test
