// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary values that change with time.
#include <gtest/gtest.h>

#include <numeric>

#include "thermal/bodies.hpp"
#include "thermal/time/ida.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::thermal::test {
namespace {

using core::Geometry;
using core::TimeFunction;

/// A smooth function as a table so fine that its intervals do not show in the results.
TimeFunction tabulate(const std::function<double(double)>& f) {
  constexpr int count = 100000;
  constexpr double first = -10, last = 60;
  core::Table table;
  for (int i = 0; i <= count; ++i) {
    table.x.push_back(first + (last - first) * i / count);
    table.y.push_back(f(table.x.back()));
  }
  return TimeFunction(table);
}

/// Manufactured solution on two stacked slabs, y the distance from their contact:
///   upper: T = hot + amplitude g(t) cos(y/length - 1), lower: T = cold + amplitude_lower g(t) sin(y/length)
/// with a flux that is continuous at the contact. It asks for a conductance, an air temperature, a prescribed
/// temperature and volume sources that all change with time; so does the heat transfer coefficient of the air.
struct Manufactured {
  static constexpr double hot = 1300, cold = 700, amplitude = 100, high = 0.015, low = 0.008, length = 0.01;
  static constexpr double end = 30, start_time = 7;
  Material glass{2500, core::constant(1300), core::constant(1.3), {}};
  Material iron{7200, core::constant(490), core::constant(46), {}};
  core::Mesh upper = rectangle({0, 0.002}, divide(0, high, 24)), lower = rectangle({0, 0.002}, divide(-low, 0, 8));
  std::vector<double> upper_source, lower_source;
  Problem problem{Geometry::planar, {body(upper, glass), body(lower, iron)}, {}, {}};

  static double g(double t) { return 1 + 0.5 * std::sin(2 * M_PI * t / 25); }
  static double g_rate(double t) { return 0.5 * 2 * M_PI / 25 * std::cos(2 * M_PI * t / 25); }
  static double h(double t) { return 300 + 100 * std::sin(2 * M_PI * t / 18); }
  static double amplitude_lower() { return 1.3 * amplitude * std::sin(1.0) / 46; }
  static double upper_exact(double y, double t) { return hot + amplitude * g(t) * std::cos(y / length - 1); }
  static double lower_exact(double y, double t) { return cold + amplitude_lower() * g(t) * std::sin(y / length); }
  static double conductance(double t) {
    return 1.3 * amplitude * g(t) * std::sin(1.0) / length / (upper_exact(0, t) - cold);
  }
  static double air_temperature(double t) {
    const double flux = 1.3 * amplitude * g(t) * std::sin(high / length - 1) / length;
    return upper_exact(high, t) - flux / h(t);
  }
  /// W/m3 for a solution whose dependence on y has the second derivative -1/length^2 times itself, over that.
  static TimeFunction source_factor(const Material& material) {
    const double stored = material.density * material.heat_capacity(0), k = material.conductivity(0);
    return tabulate([=](double t) { return stored * g_rate(t) + k / (length * length) * g(t); });
  }
  static std::vector<double> weigh(const core::Mesh& mesh, const std::function<double(double)>& shape) {
    std::vector<double> weights;
    for (Index c = 0; c < mesh.cell_count(); ++c)
      for (const auto& at : core::triangle_rule(4)) {
        const core::CellPoint point = core::map_cell_point(mesh, c, Geometry::planar, at);
        weights.push_back(point.volume * shape(point.position[1]));
      }
    return weights;
  }

  Manufactured() {
    upper_source = weigh(upper, [](double y) { return amplitude * std::cos(y / length - 1); });
    lower_source = weigh(lower, [](double y) { return amplitude_lower() * std::sin(y / length); });
    problem.bodies[0].source = &upper_source;
    problem.bodies[1].source = &lower_source;
    problem.bodies[0].source_factor = source_factor(glass);
    problem.bodies[1].source_factor = source_factor(iron);
    problem.bodies[0].exchange[top] = SurfaceExchange{tabulate(h), tabulate(air_temperature), 0, 300};
    problem.bodies[1].prescribed[bottom] = tabulate([](double t) { return lower_exact(-low, t); });
    problem.interface = stack(upper, lower, Geometry::planar);
    problem.law = [](double time, const std::vector<core::InterfacePoint>&, const InterfaceTemperatures&,
                     Eigen::ArrayXd& h, Eigen::ArrayXd* dh_dT) {
      h.setConstant(conductance(time));
      if (dh_dT) dh_dT->setZero();
    };
  }
  Manufactured(const Manufactured&) = delete;

  std::vector<Eigen::VectorXd> exact(double t) const {
    return {sample(upper, [t](const Point& x) { return upper_exact(x[1], t); }),
            sample(lower, [t](const Point& x) { return lower_exact(x[1], t); })};
  }
  /// Largest error at any node, K.
  double error(const std::vector<Eigen::VectorXd>& temperature) const {
    const auto expected = exact(start_time + end);
    return std::max((temperature[0] - expected[0]).lpNorm<Eigen::Infinity>(),
                    (temperature[1] - expected[1]).lpNorm<Eigen::Infinity>());
  }
  /// Heat that the air takes over the whole time, J.
  static double heat_to_air() {
    double sum = 0;
    constexpr int count = 20000;
    for (int i = 0; i < count; ++i) {
      const double t = start_time + end * (i + 0.5) / count;
      sum += end / count * 0.002 * h(t) * (upper_exact(high, t) - air_temperature(t));
    }
    return sum;
  }
};

TEST(BoundaryValues, TR_BDF2_is_of_second_order_where_they_change_with_time) {
  const Manufactured m;
  std::vector<double> errors, heat_errors;
  for (const int substeps : {8, 16, 32}) {
    StepOptions options;
    options.tolerance = 1e9;
    options.newton_tolerance = 1e-9;
    options.initial_substep = options.max_substep = m.end / substeps;
    StepMatrix matrix;
    const StepOutcome outcome = advance(m.problem, m.start_time, m.exact(m.start_time), m.end, options, matrix);
    ASSERT_TRUE(outcome.converged) << outcome.reason;
    EXPECT_EQ(outcome.substeps, substeps);
    errors.push_back(m.error(outcome.temperature));
    heat_errors.push_back(std::abs(outcome.balance.bodies[0].to_air / m.heat_to_air() - 1));
    for (const Index b : {0, 1})
      EXPECT_LT(std::abs(imbalance(outcome.balance, b)),
                1e-9 * heat_content(m.problem.bodies[b], Geometry::planar, outcome.temperature[b]));
  }
  std::printf("errors %.3e %.3e %.3e K, of the heat to the air %.3e %.3e %.3e\n", errors[0], errors[1], errors[2],
              heat_errors[0], heat_errors[1], heat_errors[2]);
  EXPECT_LT(errors[2], 0.1);
  for (const int i : {0, 1}) {
    EXPECT_NEAR(std::log2(errors[i] / errors[i + 1]), 2, 0.25);
    EXPECT_NEAR(std::log2(heat_errors[i] / heat_errors[i + 1]), 2, 0.4);
  }
}

TEST(BoundaryValues, IDA_follows_them_to_its_tolerance) {
  const Manufactured m;
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    IdaIntegrator integrator(m.problem, m.start_time, m.exact(m.start_time), {tolerance});
    HeatBalance balance;
    IdaOutcome outcome;
    for (const double part : {0.2, 0.5, 1.0}) {
      outcome = integrator.advance_to(m.start_time + part * m.end);
      ASSERT_TRUE(outcome.converged) << outcome.reason;
      add(balance, outcome.balance);
    }
    const double heat_error = std::abs(balance.bodies[0].to_air / m.heat_to_air() - 1);
    std::printf("tolerance %.0e K: error %.3e K, of the heat to the air %.3e, %ld steps\n", tolerance,
                m.error(outcome.temperature), heat_error, outcome.steps);
    EXPECT_LT(m.error(outcome.temperature), 10 * tolerance);
    EXPECT_LT(heat_error, tolerance);
    EXPECT_LT(std::abs(imbalance(balance, 0)), tolerance * m.heat_to_air());
    EXPECT_LT(std::abs(imbalance(balance, 1)), tolerance * m.heat_to_air());
  }
}

TEST(BoundaryValues, a_prescribed_temperature_is_met_at_the_end_of_a_step) {
  const Material iron{7200, core::constant(490), core::constant(46), {}};
  const core::Mesh mesh = rectangle(divide(0, 0.01, 4), {0, 0.002});
  Problem problem{Geometry::planar, {body(mesh, iron)}, {}, {}};
  problem.bodies[0].prescribed[left] = TimeFunction(core::Table{{1, 3}, {600, 800}});
  const std::vector<Eigen::VectorXd> start{Eigen::VectorXd::Constant(mesh.node_count(), 600)};
  for (const auto& [time, expected] : {std::pair{2.5, 750.0}, std::pair{4.0, 800.0}}) {
    StepMatrix matrix;
    const StepOutcome tr_bdf2 = advance(problem, 0, start, time, {}, matrix);
    const IdaOutcome ida = IdaIntegrator(problem, 0, start, {}).advance_to(time);
    ASSERT_TRUE(tr_bdf2.converged && ida.converged);
    for (Index i = 0; i < mesh.node_count(); ++i)
      if (mesh.nodes[i][0] == 0) {
        EXPECT_NEAR(tr_bdf2.temperature[0][i], expected, 1e-9);
        EXPECT_NEAR(ida.temperature[0][i], expected, 1e-9);
      }
    EXPECT_GT(tr_bdf2.temperature[0].minCoeff(), 600.1);
  }
}

}  // namespace
}  // namespace parison::thermal::test
