// SPDX-License-Identifier: GPL-3.0-or-later
// Light in bands by P1: its balance, its derivative, and its exact solutions.
#include <gtest/gtest.h>

#include "figure.hpp"
#include "thermal/radiation/glass_on_tool.hpp"
#include "thermal/time/ida.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::thermal::test {
namespace {

/// What the sources of a band in the glass differ by from its light through the surface, over what glass and surface
/// send.
double imbalance_of_band(const Band& band, Geometry geometry, int order) {
  const GlassOnTool pair(geometry, order, {band}, 320, 0);
  const HeatSystem system = make_heat_system(pair.problem);
  const Eigen::VectorXd T = scattered(system, pair.start);
  Eigen::VectorXd power = Eigen::VectorXd::Zero(system.size());
  Flows flows = evaluate_flows(system, 0, T);
  for (auto* flow : {&flows.to_air, &flows.light_to_air, &flows.across, &flows.received, &flows.radiated})
    flow->setZero();
  add_light(system.light[0], system, 0, T, flows, &power);
  const double in_glass = power.head(system.first_unknown[1]).sum();
  const double emitted =
      band.absorption * core::integral(pair.upper, geometry, pair.start[0], [&](double at) {
        return system.light[0].laws().irradiation(0, at).value + system.light[0].laws().irradiation(1, at).value;
      });
  EXPECT_NE(flows.radiated[0], 0);
  EXPECT_EQ(flows.radiated[0], flows.across[0]);
  EXPECT_EQ(flows.light_to_air[0], flows.to_air[0]);
  EXPECT_NEAR(flows.received[0] / flows.across[0], 1, 1e-13);
  EXPECT_NEAR(power.tail(system.size() - system.first_unknown[1]).sum() / flows.across[0], 1, 1e-13);
  const double sent = emitted + std::abs(flows.to_air[0]) + std::abs(flows.across[0]);
  return std::abs(in_glass + flows.to_air[0] + flows.across[0]) / sent;
}

TEST(P1, the_sources_of_each_band_are_what_crosses_the_surface_in_it) {
  const char* what =
      "P1: sources of a band in the glass against its light through the surface, over what both send: off by";
  tests::Figure off(what), clear("the same in very clear glass, 1 1/m");
  for (const Geometry geometry : {Geometry::planar, Geometry::axisymmetric})
    for (const int order : {1, 2}) {
      for (const Band& band : {Band{2.75e-6, 30}, Band{everything, 150}, Band{everything, 2000}})
        off.add(imbalance_of_band(band, geometry, order));
      clear.add(imbalance_of_band({4e-6, 1}, geometry, order));
    }
  off.at_most(1e-12);
  clear.at_most(1e-10);
}

TEST(P1, nothing_flows_where_all_is_at_one_temperature) {
  GlassOnTool pair(Geometry::axisymmetric, 2, flint, 1400);
  const HeatSystem system = make_heat_system(pair.problem);
  Eigen::VectorXd power = Eigen::VectorXd::Zero(system.size());
  Flows flows = evaluate_flows(system, 0, Eigen::VectorXd::Constant(system.size(), 1400));
  const double scale = flows.to_air.cwiseAbs().maxCoeff();
  flows.to_air.setZero(), flows.across.setZero();
  add_light(system.light[0], system, 0, Eigen::VectorXd::Constant(system.size(), 1400), flows, &power);
  EXPECT_LT(power.lpNorm<Eigen::Infinity>(), 1e-11 * scale);
  EXPECT_NEAR(flows.to_air[0] / scale, 0, 1e-11);
  EXPECT_NEAR(flows.across[0] / scale, 0, 1e-11);
}

TEST(P1, the_derivative_with_light_is_that_of_finite_differences) {
  const double step = 0.5, small = 1e-2;
  for (const Geometry geometry : {Geometry::planar, Geometry::axisymmetric})
    for (const int order : {1, 2}) {
      const GlassOnTool pair(geometry, order, flint);
      const HeatSystem system = make_heat_system(pair.problem);
      const Eigen::VectorXd T = scattered(system, pair.start);
      std::mt19937 random(2);
      Eigen::VectorXd direction(system.size());
      for (double& d : direction) d = std::uniform_real_distribution<double>(-1, 1)(random);
      const auto residual = [&](double shift) -> Eigen::VectorXd {
        const Response response = evaluate(system, 0, T + shift * direction);
        return response.content - step * response.power;
      };
      const Eigen::VectorXd difference = (residual(small) - residual(-small)) / (2 * small);
      Linearisation derivatives = linearise(system, 0, T);
      const Eigen::VectorXd product = apply(system, derivatives, step, direction);
      const double size = difference.lpNorm<Eigen::Infinity>();
      EXPECT_LT((product - difference).lpNorm<Eigen::Infinity>(), 1e-7 * size);
      LightDerivatives& light = derivatives.light[0];
      for (auto* part : {&light.opaque_slave, &light.opaque_master, &light.opaque_open, &light.from_tool[1]}) {
        const Eigen::ArrayXd kept = *part;
        part->setZero();
        EXPECT_GT((apply(system, derivatives, step, direction) - product).lpNorm<Eigen::Infinity>(), 1e-6 * size);
        *part = kept;
      }
      light.emission[0] = Field(light.emission[0].size());
      EXPECT_GT((apply(system, derivatives, step, direction) - product).lpNorm<Eigen::Infinity>(), 1e-5 * size);
    }
}

TEST(P1, a_step_of_ten_seconds_converges_and_is_balanced) {
  tests::Figure open("heat balance of a step of 10 s with light, over the content's change: open by");
  const GlassOnTool pair(Geometry::axisymmetric, 2, {{2.75e-6, 400}, {4.3e-6, 700}});
  StepMatrix matrix;
  StepOptions options;
  options.tolerance = 1e9;
  const StepOutcome outcome = advance(pair.problem, 0, pair.start, 10, options, matrix);
  ASSERT_TRUE(outcome.converged) << outcome.reason;
  EXPECT_EQ(outcome.substeps, 1);
  EXPECT_LT(outcome.temperature[0].maxCoeff(), 1401);
  for (const Index b : {0, 1})
    open.add(std::abs(imbalance(outcome.balance, b) / outcome.balance.bodies[b].content_change));
  EXPECT_GT(outcome.balance.pairs[0].radiated, 0);
  EXPECT_LT(outcome.balance.pairs[0].radiated, outcome.balance.pairs[0].heat);
  open.at_most(1e-9);
}

TEST(P1, the_order_in_time_is_two_with_light) {
  const GlassOnTool pair(Geometry::axisymmetric, 2, flint);
  std::vector<Eigen::VectorXd> found;
  for (const int substeps : {8, 16, 32, 256}) {
    StepMatrix matrix;
    StepOptions options;
    options.tolerance = 1e9;
    options.initial_substep = options.max_substep = 0.5 / substeps;
    const StepOutcome outcome = advance(pair.problem, 0, pair.start, 0.5, options, matrix);
    ASSERT_TRUE(outcome.converged) << outcome.reason;
    found.push_back(outcome.temperature[0]);
  }
  const auto error = [&](int i) { return (found[i] - found[3]).lpNorm<Eigen::Infinity>(); };
  tests::expect_at_least("heat with light by P1: order in time of TR-BDF2", std::log2(error(1) / error(2)), 1.8);
}

TEST(P1, ida_and_tr_bdf2_agree_with_light) {
  const GlassOnTool pair(Geometry::planar, 2, flint);
  IdaIntegrator ida(pair.problem, 0, pair.start, {1e-4});
  const IdaOutcome by_ida = ida.advance_to(1.0);
  ASSERT_TRUE(by_ida.converged) << by_ida.reason;
  StepMatrix matrix;
  StepOptions options;
  options.tolerance = 1e-3;
  const StepOutcome outcome = advance(pair.problem, 0, pair.start, 1.0, options, matrix);
  ASSERT_TRUE(outcome.converged) << outcome.reason;
  EXPECT_LT((by_ida.temperature[0] - outcome.temperature[0]).lpNorm<Eigen::Infinity>(), 0.05);
  EXPECT_NEAR(by_ida.balance.pairs[0].radiated / outcome.balance.pairs[0].radiated, 1, 1e-4);
}

TEST(P1, a_grey_slab_in_radiative_equilibrium_carries_the_flux_of_diffusion_with_jumps) {
  tests::Figure off("P1: grey slab in radiative equilibrium between black walls against 1/(1 + 3 t/4): off by", "%");
  tests::Figure model("the same against the exact flux, optical thickness 0.1, 1 and 10: off by", "%");
  const std::pair<double, double> exact[] = {{0.1, 0.9157}, {1, 0.5532}, {10, 0.1167}};
  for (const auto& [thickness, transfer] : exact) {
    const Material material = glass_with({{everything, thickness / 0.01}}, 1, 1e-9);
    const core::Mesh mesh = rectangle(divide(0, 0.01, 30), {0, 0.01 / 30});
    Problem problem{Geometry::planar, {open_body(mesh, material, 800)}, {}, {}};
    problem.bodies[0].light.surroundings = {{}, core::TimeFunction(800), {}, core::TimeFunction(1500)};
    StepMatrix matrix;
    StepOptions options;
    options.tolerance = 1;
    const StepOutcome outcome =
        advance(problem, 0, {Eigen::VectorXd::Constant(mesh.node_count(), 1200)}, 1e6, options, matrix);
    ASSERT_TRUE(outcome.converged) << outcome.reason;
    // What leaves to the cold side is found with the hot side reflecting its own light only.
    const HeatSystem system = make_heat_system(problem);
    const Eigen::MatrixXd G = irradiation(system.light[0], system, 0, join(system, outcome.temperature));
    double flux = 0;
    int count = 0;
    for (Index i = 0; i < mesh.node_count(); ++i)
      if (mesh.nodes[i][0] == 0.01) flux += 0.5 * (G(i, 0) - 4 * stefan_boltzmann * std::pow(800, 4)), ++count;
    const double share = flux / count / (stefan_boltzmann * (std::pow(1500, 4) - std::pow(800, 4)));
    off.add(100 * std::abs(share * (1 + 0.75 * thickness) - 1));
    model.add(100 * std::abs(share / transfer - 1));
  }
  off.at_most(0.02);
  model.for_comparison();
}

TEST(P1, light_in_thick_glass_is_Rosseland_s_conduction) {
  // Far from the walls: temperatures that vary over many free paths.
  const double absorption = 1500, length = 0.05;
  const core::Mesh mesh = rectangle(divide(0, length, 100), {0, length / 100});
  const auto T = sample(mesh, [&](const Point& x) { return 1200 + 150 * std::cos(M_PI * x[0] / length); });
  const Material light = glass_with({{everything, absorption}});
  Problem by_light{Geometry::planar, {body(mesh, light)}, {}, {}};
  by_light.bodies[0].light.surroundings.resize(4);
  Material conducting = light;
  conducting.radiation = Radiation{1.518, absorption, false};
  Problem by_conduction{Geometry::planar, {body(mesh, conducting)}, {}, {}};
  const Eigen::VectorXd a = evaluate(make_heat_system(by_light), 0, T).power,
                        b = evaluate(make_heat_system(by_conduction), 0, T).power;
  tests::expect_at_most("P1: sources in glass of 75 free paths against Rosseland's conduction: off by",
                        100 * (a - b).norm() / b.norm(), 1, "%");
}

}  // namespace
}  // namespace parison::thermal::test
