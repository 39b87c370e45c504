// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include "thermal/bodies.hpp"
#include "thermal/time/ida.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::thermal::test {
namespace {

/// Two blocks, 1000 K apart, the hot one radiating and with Rosseland conduction.
struct Blocks {
  Material glass{2400, core::constant(1300), core::constant(1.3), Radiation{1.518, 150, true}};
  Material iron{7200, core::constant(490), core::constant(46), {}};
  core::Mesh upper = rectangle(divide(0, 0.02, 4), divide(0, 0.01, 12, 1.3));
  core::Mesh lower = rectangle(divide(0, 0.02, 4), divide(-0.02, 0, 12, 1 / 1.3));
  Problem problem{core::Geometry::axisymmetric, {body(upper, glass), body(lower, iron)}, {}, {}};
  std::vector<Eigen::VectorXd> start{Eigen::VectorXd::Constant(upper.node_count(), 1423),
                                     Eigen::VectorXd::Constant(lower.node_count(), 423)};

  explicit Blocks(double h) {
    problem.bodies[0].exchange[top] = SurfaceExchange{20, 320, 0.89, 320};
    problem.interface = stack(upper, lower, problem.geometry);
    problem.law = constant_conductance(h);
  }
  Blocks(const Blocks&) = delete;
};

TEST(Extremes, any_conductance_and_any_step_gives_bounded_balanced_temperatures) {
  for (const double h : {0.0, 1.0, 5000.0, 1e9})
    for (const double dt : {1e-9, 1e-3, 10.0}) {
      Blocks blocks(h);
      StepMatrix matrix;
      const StepOutcome outcome = advance(blocks.problem, 0, blocks.start, dt, {}, matrix);
      ASSERT_TRUE(outcome.converged) << "h " << h << ", dt " << dt << ": " << outcome.reason;
      double change = 0, content = 0;
      for (const Index b : {0, 1}) {
        EXPECT_LT(outcome.temperature[b].maxCoeff(), 1423 + 100);
        EXPECT_GT(outcome.temperature[b].minCoeff(), 423 - 100);
        content += std::abs(heat_content(blocks.problem.bodies[b], blocks.problem.geometry, outcome.temperature[b]));
        change = std::max(change, std::abs(outcome.balance.bodies[b].content_change));
      }
      for (const Index b : {0, 1}) EXPECT_LT(std::abs(imbalance(outcome.balance, b)), 1e-8 * change + 1e-14 * content);
      EXPECT_EQ(outcome.balance.pairs[0].heat > 0, h > 0);
    }
}

TEST(Extremes, perfect_contact_leaves_no_jump_and_the_classical_contact_temperature) {
  Blocks blocks(1e9);
  blocks.glass.radiation.reset();
  blocks.problem.bodies[0].exchange.clear();
  StepMatrix matrix;
  const StepOutcome outcome = advance(blocks.problem, 0, blocks.start, 1.0, {}, matrix);
  ASSERT_TRUE(outcome.converged) << outcome.reason;
  const double e1 = std::sqrt(1.3 * 2400 * 1300), e2 = std::sqrt(46 * 7200 * 490.0);
  const double contact = (e1 * 1423 + e2 * 423) / (e1 + e2);
  for (const core::InterfacePoint& point : blocks.problem.interface)
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(outcome.temperature[0][point.slave_nodes[i]], contact, 0.5);
      EXPECT_NEAR(outcome.temperature[1][point.master_nodes[i]], contact, 0.5);
    }
}

TEST(Extremes, a_temperature_that_is_not_a_number_is_refused_with_a_reason) {
  Blocks blocks(5000);
  blocks.start[0][3] = std::numeric_limits<double>::quiet_NaN();
  StepMatrix matrix;
  const StepOutcome outcome = advance(blocks.problem, 0, blocks.start, 0.1, {}, matrix);
  EXPECT_FALSE(outcome.converged);
  EXPECT_NE(outcome.reason.find("not finite"), std::string::npos);
}

TEST(Extremes, a_step_that_needs_too_small_substeps_fails_with_a_reason) {
  Blocks blocks(5000);
  StepOptions options;
  options.min_substep = 0.5;
  StepMatrix matrix;
  const StepOutcome outcome = advance(blocks.problem, 0, blocks.start, 1.0, options, matrix);
  EXPECT_FALSE(outcome.converged);
  EXPECT_NE(outcome.reason.find("substeps below 0.5 s"), std::string::npos);
}

TEST(Extremes, IDA_survives_a_jump_of_1000_K_through_any_conductance) {
  for (const double h : {0.0, 5000.0, 1e9}) {
    Blocks blocks(h);
    IdaIntegrator integrator(blocks.problem, 0, blocks.start, {});
    const IdaOutcome outcome = integrator.advance_to(10);
    ASSERT_TRUE(outcome.converged) << outcome.reason;
    for (const Index b : {0, 1}) {
      EXPECT_LT(outcome.temperature[b].maxCoeff(), 1424);
      EXPECT_GT(outcome.temperature[b].minCoeff(), 422);
    }
  }
}

TEST(Extremes, a_new_contact_and_a_lost_contact_are_taken_in_the_next_step) {
  Blocks blocks(5000);
  const auto closed = blocks.problem.interface;
  StepMatrix matrix;
  auto temperature = blocks.start;
  for (const bool touching : {false, true, false, true}) {
    blocks.problem.interface = touching ? closed : std::vector<core::InterfacePoint>{};
    const StepOutcome outcome = advance(blocks.problem, 0, temperature, 0.1, {}, matrix);
    ASSERT_TRUE(outcome.converged) << outcome.reason;
    EXPECT_EQ(outcome.balance.pairs.size(), touching ? 1u : 0u);
    temperature = outcome.temperature;
  }
}

}  // namespace
}  // namespace parison::thermal::test
