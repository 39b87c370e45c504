// SPDX-License-Identifier: GPL-3.0-or-later
// Light in bands by P1: its balance, its derivative, and its exact solutions.
#include <gtest/gtest.h>

#include "figure.hpp"
#include "thermal/radiation/light_checks.hpp"
#include "thermal/time/ida.hpp"

namespace parison::thermal::test {
namespace {

/// What the sources of a band in the glass differ by from its light through the surface, over what glass and surface
/// send.
double imbalance_of_band(const Band& band, Geometry geometry) {
  const GlassOnTool pair(geometry, {band}, 320, 0);
  const HeatSystem system = make_heat_system(pair.problem);
  const LightFlows light(system, scattered(system, pair.start));
  const Flows& flows = light.flows;
  const double emitted =
      band.absorption * core::integral(pair.upper, geometry, pair.start[0], [&](double at) {
        return system.light[0].laws().irradiation(0, at).value + system.light[0].laws().irradiation(1, at).value;
      });
  EXPECT_NE(flows.radiated[0], 0);
  EXPECT_EQ(flows.radiated[0], flows.across[0]);
  EXPECT_EQ(flows.light_to_air[0], flows.to_air[0]);
  EXPECT_NEAR(flows.received[0] / flows.across[0], 1, 1e-13);
  EXPECT_NEAR(light.power.tail(system.size() - system.first_unknown[1]).sum() / flows.across[0], 1, 1e-13);
  return light.imbalance(system) / (emitted + std::abs(flows.to_air[0]) + std::abs(flows.across[0]));
}

TEST(P1, the_sources_of_each_band_are_what_crosses_the_surface_in_it) {
  const char* what =
      "P1: sources of a band in the glass against its light through the surface, over what both send: off by";
  tests::Figure off(what), clear("the same in very clear glass, 1 1/m");
  for (const Geometry geometry : {Geometry::planar, Geometry::axisymmetric}) {
    for (const Band& band : {Band{2.75e-6, 30}, Band{everything, 150}, Band{everything, 2000}})
      off.add(imbalance_of_band(band, geometry));
    clear.add(imbalance_of_band({4e-6, 1}, geometry));
  }
  off.at_most(1e-12);
  clear.at_most(1e-10);
}

TEST(P1, nothing_flows_where_all_is_at_one_temperature) {
  expect_no_light(GlassOnTool(Geometry::axisymmetric, flint, 1400).problem, 1400);
}

TEST(P1, the_derivative_with_light_is_that_of_finite_differences) {
  for (const Geometry geometry : {Geometry::planar, Geometry::axisymmetric}) {
    const GlassOnTool pair(geometry, flint);
    StepDerivative derivative(pair);
    EXPECT_LT(derivative.error(), 1e-7);
    LightDerivatives& light = derivative.derivatives.light[0];
    for (auto* part : {&light.opaque_slave, &light.opaque_master, &light.opaque_open, &light.from_tool[1]}) {
      const Eigen::ArrayXd kept = *part;
      part->setZero();
      EXPECT_GT(derivative.change(), 1e-6);
      *part = kept;
    }
    light.emission[0] = Field(light.emission[0].size());
    EXPECT_GT(derivative.change(), 1e-5);
  }
}

TEST(P1, a_step_of_ten_seconds_converges_and_is_balanced) {
  const StepOutcome outcome = step_of_ten_seconds(
      Model::p1_cones, "heat balance of a step of 10 s with light, over the content's change: open by");
  EXPECT_GT(outcome.balance.pairs[0].radiated, 0);
  EXPECT_LT(outcome.balance.pairs[0].radiated, outcome.balance.pairs[0].heat);
}

TEST(P1, the_order_in_time_is_two_with_light) {
  tests::expect_at_least("heat with light by P1: order in time of TR-BDF2", order_in_time(Model::p1_cones, 256), 1.8);
}

TEST(P1, ida_and_tr_bdf2_agree_with_light) {
  const GlassOnTool pair(Geometry::planar, flint);
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
  for (const auto& [thickness, transfer] : exact_flux) {
    const EquilibriumSlab slab(thickness, Model::p1, 0.9);
    // What leaves to the cold side is found with the hot side reflecting its own light only.
    const HeatSystem system = make_heat_system(slab.problem);
    const Eigen::MatrixXd G = irradiation(system.light[0], system, 0, slab.temperature);
    double flux = 0;
    int count = 0;
    for (Index i = 0; i < slab.mesh.node_count(); ++i)
      if (slab.mesh.nodes[i][0] == slab.length)
        flux += 0.5 * (G(i, 0) - 4 * stefan_boltzmann * std::pow(800, 4)), ++count;
    const double share = slab.share(flux / count);
    off.add(100 * std::abs(share * (1 + 0.75 * thickness) - 1));
    model.add(100 * std::abs(share / transfer - 1));
  }
  off.at_most(0.02);
  model.for_comparison();
}

TEST(P1, light_in_thick_glass_is_Rosseland_s_conduction) {
  tests::expect_at_most("P1: sources in glass of 75 free paths against Rosseland's conduction: off by",
                        ThickGlass().off(glass_with({{everything, ThickGlass::absorption}}),
                                         Radiation{1.518, ThickGlass::absorption, false}),
                        1, "%");
}

}  // namespace
}  // namespace parison::thermal::test
