// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "figure.hpp"
#include "thermal/bodies.hpp"
#include "thermal/time/ida.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::thermal::test {
namespace {

using core::Geometry;

/// Hot glass on a cold tool with everything that can exchange heat: air, radiation, cooling, source, a given
/// temperature, an interface whose conductance depends on temperature, and a heat capacity with a tall peak.
struct Everything {
  Material glass{2400,
                 {{400, 1150, 1200, 1250, 1600}, {900, 1200, 6000, 1200, 1400}},
                 core::constant(1.3),
                 Radiation{1.518, 150, true}};
  Material iron{7200, {{300, 1000}, {460, 700}}, {{300, 1000}, {50, 30}}, {}};
  core::Mesh upper = rectangle(divide(0, 0.02, 5), divide(0, 0.01, 8, 1.4));
  core::Mesh lower = rectangle(divide(0, 0.02, 5), divide(-0.02, 0, 8, 0.7));
  Eigen::VectorXd wall = Eigen::VectorXd::Constant(upper.node_count(), 0.01);
  std::vector<double> source = std::vector<double>(upper.cell_count() * core::triangle_rule(4).size(), 0.05);
  Problem problem{Geometry::axisymmetric, {body(upper, glass), body(lower, iron)}, {}, {}};
  std::vector<Eigen::VectorXd> start{Eigen::VectorXd::Constant(upper.node_count(), 1400),
                                     Eigen::VectorXd::Constant(lower.node_count(), 700)};

  Everything() {
    const SurfaceExchange air{20, 320, 0.89, 320};
    problem.bodies[0].exchange = {air, air, air, {}};
    problem.bodies[0].wall_thickness = &wall;
    problem.bodies[0].source = &source;
    problem.bodies[1].exchange = {SurfaceExchange{400, 350, 0, 300}, {}, air, {}};
    problem.bodies[1].prescribed[right] = 650;
    problem.interface = stack(upper, lower, problem.geometry);
    problem.law = pointwise([](const core::InterfacePoint&, double T) {
      const double x = std::exp((T - 1100) / 150);
      return core::Conductance{500 + 19500 * x / (1 + x), 19500 * x / (150 * (1 + x) * (1 + x))};
    });
  }
  Everything(const Everything&) = delete;
};

TEST(HeatBalance, every_step_closes_to_1e_10_with_all_kinds_of_exchange) {
  tests::Figure open("heat balance of a step with all kinds of exchange, over the content's change: open by");
  Everything e;
  StepOptions options;
  StepMatrix matrix;
  auto temperature = e.start;
  for (int step = 0; step < 40; ++step) {
    const StepOutcome outcome = advance(e.problem, 0, temperature, 0.1, options, matrix);
    ASSERT_TRUE(outcome.converged) << outcome.reason;
    for (const Index b : {0, 1}) {
      const BodyBalance& body = outcome.balance.bodies[b];
      const double content = heat_content(e.problem.bodies[b], e.problem.geometry, outcome.temperature[b]) -
                             heat_content(e.problem.bodies[b], e.problem.geometry, temperature[b]);
      EXPECT_NEAR(body.content_change / content, 1, 1e-9);
      open.add(std::abs(imbalance(outcome.balance, b) / body.content_change));
      EXPECT_GT(body.to_air, 0);
    }
    EXPECT_GT(outcome.balance.bodies[0].from_source, 0);
    EXPECT_LT(outcome.balance.bodies[1].from_prescribed, 0);
    EXPECT_GT(outcome.balance.pairs[0].heat, 0);
    temperature = outcome.temperature;
    options.initial_substep = outcome.next_substep;
  }
  open.at_most(1e-10);
  EXPECT_LT(temperature[0].minCoeff(), 1150);  // through the peak of the heat capacity
}

TEST(HeatBalance, the_heat_through_the_boundaries_of_a_body_is_all_that_leaves_it_without_contact) {
  Everything e;
  StepMatrix matrix;
  const StepOutcome outcome = advance(e.problem, 0, e.start, 0.1, {}, matrix);
  IdaIntegrator ida(e.problem, 0, e.start, {1e-4});
  for (const HeatBalance& balance : {outcome.balance, ida.advance_to(0.1).balance})
    for (const std::size_t b : {0u, 1u}) {
      double sum = 0;
      for (Index i = balance.first_boundary[b]; i < balance.first_boundary[b + 1]; ++i)
        sum += balance.through_boundary[static_cast<std::size_t>(i)];
      const BodyBalance& body = balance.bodies[b];
      EXPECT_NEAR(sum / (body.to_air - body.from_prescribed), 1, 1e-9);
    }
}

TEST(HeatBalance, each_face_of_a_slab_has_the_heat_that_flows_through_it) {
  const core::Mesh mesh = rectangle(divide(0, 0.02, 4), divide(0, 0.01, 6));
  const Material iron{7200, core::constant(490), core::constant(46), {}};
  Problem problem{Geometry::planar, {body(mesh, iron)}, {}, {}};
  problem.bodies[0].prescribed[bottom] = 500;
  // 46 W/m/K over 10 mm let 50 K drive 230 kW/m2, which 2300 W/m2/K take off at 100 K above the air.
  problem.bodies[0].exchange[top] = SurfaceExchange{2300, 350, 0, 300};
  const std::vector<Eigen::VectorXd> start{sample(mesh, [](const Point& x) { return 500 - 5000 * x[1]; })};
  StepMatrix matrix;
  const HeatBalance balance = advance(problem, 0, start, 2, {}, matrix).balance;
  const double through = 46 * 5000 * 0.02 * 2;
  EXPECT_NEAR(balance.through_boundary[bottom] / through, -1, 1e-9);
  EXPECT_NEAR(balance.through_boundary[top] / through, 1, 1e-9);
  EXPECT_EQ(balance.through_boundary[left], 0);
  EXPECT_EQ(balance.through_boundary[right], 0);
}

TEST(HeatBalance, flux_out_of_one_body_equals_flux_into_the_other) {
  Everything e;
  for (BodyView& body : e.problem.bodies) {
    body.exchange.clear();
    body.prescribed.clear();
    body.source = nullptr;
  }
  const HeatSystem system = make_heat_system(e.problem);
  const Eigen::VectorXd temperature = Eigen::VectorXd::LinSpaced(system.size(), 1400, 700);
  const Response response = evaluate(system, 0, temperature);
  const double out = response.power.head(system.first_unknown[1]).sum();
  const double in = response.power.tail(system.size() - system.first_unknown[1]).sum();
  EXPECT_LT(out, -1);
  EXPECT_NEAR(-out / response.flows.across[0], 1, 1e-13);
  EXPECT_NEAR(in / response.flows.across[0], 1, 1e-13);
}

TEST(HeatBalance, contact_replaces_the_air_as_far_as_it_is_closed) {
  Everything e;
  const SurfaceExchange air{20, 320, 0.89, 320};
  for (BodyView& body : e.problem.bodies) {
    body.exchange = {{}, {}, {}, {}};
    body.source = nullptr;
  }
  e.problem.bodies[0].exchange[bottom] = air;
  e.problem.bodies[1].exchange[top] = air;
  const auto flows = [&](double contact_weight) {
    for (core::InterfacePoint& point : e.problem.interface) point.contact_weight = contact_weight;
    const HeatSystem system = make_heat_system(e.problem);
    return evaluate_flows(system, 0, join(system, e.start));
  };
  const Flows open = flows(0), half = flows(0.5), closed = flows(1);
  for (const Index b : {0, 1}) {
    EXPECT_GT(open.to_air[b], 1);
    EXPECT_NEAR(half.to_air[b] / open.to_air[b], 0.5, 1e-12);
    EXPECT_NEAR(closed.to_air[b] / open.to_air[b], 0, 1e-12);
  }
  EXPECT_EQ(open.across[0], 0);
  EXPECT_NEAR(half.across[0] / closed.across[0], 0.5, 1e-12);
}

TEST(HeatBalance, IDA_closes_to_its_tolerance_and_agrees_with_TR_BDF2) {
  Everything e;
  IdaIntegrator integrator(e.problem, 0, e.start, {1e-4});
  StepOptions options;
  options.tolerance = 2e-3;
  StepMatrix matrix;
  auto temperature = e.start;
  for (const double until : {0.5, 1.0, 3.0}) {
    const IdaOutcome ida = integrator.advance_to(until);
    ASSERT_TRUE(ida.converged) << ida.reason;
    const StepOutcome tr = advance(e.problem, 0, temperature, until == 3 ? 2 : 0.5, options, matrix);
    ASSERT_TRUE(tr.converged) << tr.reason;
    temperature = tr.temperature;
    options.initial_substep = tr.next_substep;
    for (const Index b : {0, 1}) {
      EXPECT_LT((ida.temperature[b] - tr.temperature[b]).lpNorm<Eigen::Infinity>(), 0.05);
      EXPECT_LT(std::abs(imbalance(ida.balance, b) / ida.balance.pairs[0].heat), 1e-5);
      EXPECT_NEAR(ida.balance.bodies[b].to_air / tr.balance.bodies[b].to_air, 1, 1e-4);
    }
    EXPECT_NEAR(ida.balance.pairs[0].heat / tr.balance.pairs[0].heat, 1, 1e-4);
    EXPECT_NEAR(ida.balance.bodies[1].from_prescribed / tr.balance.bodies[1].from_prescribed, 1, 1e-3);
  }
}

}  // namespace
}  // namespace parison::thermal::test
