// SPDX-License-Identifier: GPL-3.0-or-later
// Light by rays: emission of bodies against exact solutions.
#include <gtest/gtest.h>

#include "figure.hpp"
#include "thermal/radiation/exact_emission.hpp"
#include "thermal/radiation/exact_tube.hpp"
#include "thermal/radiation/light_checks.hpp"
#include "thermal/radiation/light_error.hpp"
#include "thermal/radiation/light_heat.hpp"

namespace parison::thermal::test {
namespace {

TEST(Transfer, isothermal_bodies_emit_as_the_integral_over_their_chords_says) {
  for (const Shape shape : {Shape::slab, Shape::cylinder, Shape::sphere})
    for (const double index : {1.0, 1.518}) {
      tests::Figure off(fmt::format("transfer: emission of isothermal {} of optical size 0.1 to 10, n = {}: off by",
                                    name_of(shape), index),
                        "%");
      for (const double optical : {0.1, 0.45, 1.2, 5.0, 10.0}) {
        const double found = emissivity(shape, Model::transfer, optical, index, shape == Shape::sphere ? 16 : 40),
                     wanted = exact(shape, optical, index);
        off.add(100 * std::abs(found / wanted - 1));
        std::printf("n = %g, %s of optical size %g: %.5f, exact %.5f\n", index, name_of(shape), optical, found, wanted);
      }
      off.at_most(1);
    }
}

TEST(Transfer, a_wall_bent_to_a_tube_emits_as_its_rays_do) {
  for (const double inner : {0.003, 0.03}) {
    tests::Figure off(fmt::format("transfer: emission of an isothermal tube of glass, wall 3 mm, inner radius {} mm, "
                                  "optical thickness 0.09 to 2.1: off by",
                                  1e3 * inner),
                      "%");
    for (const double absorption : {30.0, 150.0, 450.0, 700.0}) {
      const double found = tube_emissivity(Model::transfer, inner, absorption), wanted = exact_tube(inner, absorption);
      off.add(100 * std::abs(found / wanted - 1));
      std::printf("inner radius %g mm, %g 1/m: %.4f, exact %.4f\n", 1e3 * inner, absorption, found, wanted);
    }
    off.at_most(4);
  }
}

/// Light out of a boundary of a body of one group, W/m2, that sees surroundings of a temperature there.
double flux_through(Index boundary, const HeatSystem& system, const Eigen::VectorXd& T,
                    const std::vector<double>& surroundings) {
  const Light& light = system.light[0];
  const LightGroup& group = light.laws().group(0);
  GroupSource source{at_cell_points(light, system, T), {}, Eigen::ArrayXd()};
  for (std::size_t b = 0; b < source.cells.size(); ++b)
    for (int q = 0; q < core::cell_points; ++q)
      for (int lane = 0; lane < core::batch_size; ++lane)
        source.cells[b][q][lane] =
            group.absorption * light.volumes[b][q][lane] * light.laws().irradiation(0, source.cells[b][q][lane]).value;
  for (const LightEdge& edge : light.edges) {
    auto& sent = source.edges.emplace_back();
    for (int q = 0; q < 3; ++q)
      sent[q] = group.open * edge.area[q] * light.laws().irradiation(0, surroundings[edge.boundary]).value;
  }
  const GroupLight found = solve_group(light, 0, source);
  double flux = 0, area = 0;
  for (std::size_t e = 0; e < light.edges.size(); ++e)
    for (int q = 0; q < 3 && light.edges[e].boundary == boundary; ++q) {
      flux += group.open * light.edges[e].area[q] * found.edges[e][q] - source.edges[e][q];
      area += light.edges[e].area[q];
    }
  return flux / area;
}

TEST(Transfer, a_grey_slab_in_radiative_equilibrium_between_black_walls_carries_the_exact_flux) {
  tests::Figure off(
      "transfer: grey slab in radiative equilibrium between black walls, optical thickness 0.1, 1, 10: flux off by",
      "%");
  for (const auto& [thickness, wanted] : exact_flux) {
    const EquilibriumSlab slab(thickness, Model::transfer, 0);
    const HeatSystem system = make_heat_system(slab.problem);
    const double share = slab.share(flux_through(right, system, slab.temperature, {0, 800, 0, 1500}));
    std::printf("optical thickness %g: %.4f, exact %.4f\n", thickness, share, wanted);
    off.add(100 * std::abs(share / wanted - 1));
  }
  off.at_most(1);
}

/// What the sources of a band in the glass differ by from its light through the surface, over what crosses that.
double imbalance_of_band(const Band& band, Geometry geometry) {
  const GlassOnTool pair(geometry, {band}, 320, 0, Model::transfer);
  const HeatSystem system = make_heat_system(pair.problem);
  const LightFlows light(system, scattered(system, pair.start));
  const Flows& flows = light.flows;
  EXPECT_NE(flows.radiated[0], 0);
  EXPECT_GT(flows.light_to_air[0], 0);
  EXPECT_NEAR(light.power.tail(system.size() - system.first_unknown[1]).sum() / flows.across[0], 1, 1e-13);
  return light.imbalance(system) / light.through_surface();
}

TEST(Transfer, the_sources_of_each_band_are_what_crosses_the_surface_in_it) {
  tests::Figure off("transfer: sources of a band in the glass against its light through the surface: off by");
  for (const Geometry geometry : {Geometry::planar, Geometry::axisymmetric})
    for (const Band& band : {Band{2.75e-6, 30}, Band{everything, 150}, Band{everything, 2000}, Band{4e-6, 1}})
      off.add(imbalance_of_band(band, geometry));
  off.at_most(1e-12);
}

TEST(Transfer, nothing_flows_where_all_is_at_one_temperature) {
  expect_no_light(GlassOnTool(Geometry::axisymmetric, flint, 1400, 0.9, Model::transfer).problem, 1400);
}

TEST(Transfer, the_derivative_is_that_of_finite_differences) {
  const GlassOnTool pair(Geometry::axisymmetric, flint, 320, 0.9, Model::transfer);
  StepDerivative derivative(pair);
  EXPECT_LT(derivative.error(), 1e-7);
  LightDerivatives& light = derivative.derivatives.light[0];
  light.emission[0] = Field(light.emission[0].size());
  EXPECT_GT(derivative.change(), 1e-5);
  light.from_tool[1].setZero();
  EXPECT_GT(derivative.change(), 1e-5);
}

TEST(Transfer, a_step_of_ten_seconds_converges_and_is_balanced) {
  step_of_ten_seconds(Model::transfer,
                      "heat balance of a step of 10 s with light by rays, over the content's change: open by");
}

TEST(Transfer, the_order_in_time_is_two) {
  tests::expect_at_least("heat with light by rays: order in time of TR-BDF2", order_in_time(Model::transfer, 128), 1.8);
}

TEST(Transfer, light_in_thick_glass_is_Rosseland_s_conduction) {
  const ThickGlass glass;
  const Material light = glass_with({{everything, glass.absorption}}, 1.518, 1.3, Model::transfer);
  BodyView view = open_body(glass.mesh, light, 1200, 0);
  view.light.surroundings = {{}, core::TimeFunction(1050), {}, core::TimeFunction(1350)};
  // Heat into a half, which far from the walls is the flux through the middle.
  const auto gained = [&](const Eigen::VectorXd& power) {
    double sum = 0;
    for (Index i = 0; i < glass.mesh.node_count(); ++i)
      if (const double x = glass.mesh.nodes[i][0]; x > 0.25 * glass.length && x < 0.75 * glass.length)
        sum += power[i] * (x - 0.5 * glass.length);
    return sum;
  };
  const double a = gained(glass.by_light(view)),
               b = gained(glass.by_conduction(light, Radiation{1.518, glass.absorption, false}));
  tests::expect_at_most("transfer: heat moved inside glass of 75 free paths against Rosseland's conduction: off by",
                        100 * std::abs(a / b - 1), 1, "%");
}

/// Heat rates of a disc between cold and hot, by a mesh of its own.
Flows disc_flows(int across, int high) {
  const Material material = glass_with(flint, 1.518, 1.3, Model::transfer);
  const core::Mesh mesh = rectangle(divide(0, 0.02, across), divide(0, 0.008, high, 1.07));
  Problem problem{Geometry::axisymmetric, {open_body(mesh, material, 320)}, {}, {}};
  problem.bodies[0].light.surroundings[left].reset();
  const HeatSystem system = make_heat_system(problem);
  const auto T = sample(mesh, [](const Point& x) { return 1300 - 2e6 * (x[1] - 0.003) * (x[1] - 0.003) - 4e3 * x[0]; });
  return evaluate_flows(system, 0, T);
}

TEST(Transfer, another_mesh_changes_the_heat_rates_by_little) {
  tests::Figure off("transfer: light out of a disc by four meshes: off from that of the finest by", "%");
  const double reference = disc_flows(40, 20).light_to_air[0];
  for (const auto& [across, high] : {std::pair<int, int>{12, 6}, {17, 9}, {23, 8}})
    off.add(100 * std::abs(disc_flows(across, high).light_to_air[0] / reference - 1));
  off.at_most(0.3);
}

TEST(Transfer, parts_of_the_rays_tell_how_wrong_all_of_them_are) {
  GlassOnTool pair(Geometry::axisymmetric, flint, 320, 0.9, Model::transfer);
  const auto flows = [&](double rays) {
    pair.problem.light_resolution.rays = rays;
    const HeatSystem system = make_heat_system(pair.problem);
    return evaluate_flows(system, 0, scattered(system, pair.start)).exchanged;
  };
  const auto told = [&](double rays) {
    pair.problem.light_resolution.rays = rays;
    const HeatSystem system = make_heat_system(pair.problem);
    const Eigen::VectorXd T = scattered(system, pair.start);
    std::vector<Eigen::VectorXd> by_body;
    for (std::size_t b = 0; b + 1 < system.first_unknown.size(); ++b)
      by_body.push_back(T.segment(system.first_unknown[b], system.first_unknown[b + 1] - system.first_unknown[b]));
    return light_error(pair.problem, 0, by_body);
  };
  const LightError coarse = told(1000), fine = told(16000);
  EXPECT_LT((flows(1000) - flows(32000)).cwiseAbs().sum(), coarse.power);
  EXPECT_LT(fine.power, 0.3 * coarse.power);
  EXPECT_LT(fine.power, 0.01 * fine.all_heat);
  EXPECT_GT(fine.power, 0);
}

}  // namespace
}  // namespace parison::thermal::test
