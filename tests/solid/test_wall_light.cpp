// SPDX-License-Identifier: GPL-3.0-or-later
// Light in bands through walls of layered cells: slabs by the exact integral and by discrete ordinates, and balances.
#include <gtest/gtest.h>

#include <limits>

#include "contact/solid/solid_conductance.hpp"
#include "contact/solid/solid_mortar.hpp"
#include "core/solid/cell_stacks.hpp"
#include "figure.hpp"
#include "solid/solid_meshes.hpp"
#include "thermal/radiation/fresnel.hpp"

namespace parison::thermal::test {
namespace {

constexpr double side = 0.01, celsius = 273.15;
constexpr double beyond = std::numeric_limits<double>::infinity();
const std::vector<Band> flint{{2.75e-6, 30}, {4.3e-6, 450}}, amber{{2.75e-6, 400}, {4.3e-6, 700}};

Material glass_of(const std::vector<Band>& bands, double index = 1.518) {
  Material material{2400, core::constant(1300), core::constant(1.3), {}};
  material.radiation = Radiation{index, 0, true, Radiation::Model::transfer, bands};
  return material;
}

/// A slab of glass between z = 0 and its thickness, on a tool that covers a part of its low side.
struct Slab {
  Material material, steel{7200, core::constant(1e6), core::constant(1e5), {}};
  Block glass;
  core::PrismMesh tool;
  std::vector<std::vector<Index>> stacks;
  Eigen::VectorXd mass, tool_mass;
  std::vector<Eigen::VectorXd> temperature;

  /// Cells get thinner to both sides; temperatures in K.
  Slab(const Material& of, double thickness, int layers, double start, double reach = 0, double of_tool = 0)
      : material(of),
        glass(block(2, 2, layers,
                    [&](const Vector3& x) -> Vector3 {
                      const double z = x[2] - 0.8 * std::sin(2 * M_PI * x[2]) / (2 * M_PI);
                      return {side * x[0], side * x[1], thickness * z};
                    })),
        tool(core::sweep(rectangle(divide(side, (1 + reach) * side, 3), divide(-side / 2, 0, 2)), 0, 1.2 * side, 3,
                         [](double r, double z, double y) -> Vector3 {
                           return {r - side, y, z};
                         })),
        stacks(core::cell_stacks(glass.mesh)),
        mass(masses(glass.mesh, core::hexahedron_table(), material)),
        tool_mass(masses(tool, core::prism_table(), steel)),
        temperature{Eigen::VectorXd::Constant(glass.mesh.node_count(), start)} {
    if (reach > 0) temperature.push_back(Eigen::VectorXd::Constant(tool.node_count(), of_tool));
  }
  bool on_tool() const { return temperature.size() > 1; }

  /// In black surroundings on the sides that are walls, with this conductance to the tool, W/m2/K.
  SolidProblem problem(double surroundings, double conductance = 0) const {
    SolidProblem made{{solid_body(glass.mesh, glass.faces, mass, material)}, {}, {}};
    SolidBodyView& view = made.bodies.front();
    view.stacks = &stacks;
    view.light.surroundings.resize(6);
    for (const Index at : {z_low, z_high}) view.light.surroundings[at] = core::TimeFunction(surroundings);
    view.light.emissivity = 0.89;
    if (!on_tool()) return made;
    made.bodies.push_back(solid_body(tool, tool_mass, steel));
    made.bodies.back().light.emissivity = 0.8;
    const auto closed = [](Index, const std::array<double, 2>&) { return contact::ContactState{0, 1e5}; };
    made.interface =
        contact::build_interface(contact::solid_surface(0, glass.mesh.nodes, glass.faces, {z_low}),
                                 {{contact::solid_surface(1, tool.nodes, tool.faces, {top}), 0, 1e-4, closed}});
    made.law = constant_solid_conductance(conductance);
    return made;
  }
};

/// 2 n^2 int (1-R)(1-e^(-t/mu))/(1-R e^(-t/mu)) mu dmu over the directions that leave (M. F. Modest, Radiative Heat
/// Transfer, 3rd ed. 2013, chapter 14).
double exact_emissivity(double n, double depth) {
  const double critical = critical_cosine(n), rest = 1 - critical;
  constexpr int points = 20000;
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    const double s = (i + 0.5) / points, mu = critical + rest * s * s, R = fresnel_reflectivity(n, mu);
    const double passes = std::exp(-depth / mu);
    sum += (1 - R) * (1 - passes) / (1 - R * passes) * mu * 2 * rest * s / points;
  }
  return 2 * n * n * sum;
}

TEST(WallLight, isothermal_slabs_emit_what_the_exact_integral_says) {
  tests::Figure off("emission of isothermal slabs in space: off by", "%");
  for (const double n : {1.0, 1.518})
    for (const double depth : {0.1, 0.45, 1.2, 5.0, 15.0}) {
      const Slab slab(glass_of({{beyond, depth / 0.01}}, n), 0.01, 3, 1300);
      const SolidProblem problem = slab.problem(0);
      SolidStepMatrix matrix;
      constexpr double dt = 1e-6;
      const StepOutcome end = advance(problem, 0, slab.temperature, dt, one_step(), matrix);
      ASSERT_TRUE(end.converged) << end.reason;
      const double black = 2 * side * side * dt * stefan_boltzmann * std::pow(1300, 4);
      off.add(100 * std::abs(end.balance.bodies[0].light_to_air / black / exact_emissivity(n, depth) - 1));
    }
  off.at_most(0.1);
}

/// A ball of layers, its inner side a thousandth as wide as the outer.
double emissivity_of_ball(double n, double depth, int layers) {
  constexpr double radius = 0.005, inner = 1e-3 * radius;
  const auto& rule = core::edge_rule(3);
  std::vector<SlabLayer> shells;
  for (int c = 0; c < layers; ++c)
    shells.emplace_back((radius - inner) / layers, std::array<double, 3>{rule[0].s, rule[1].s, rule[2].s});
  const Eigen::Vector2d area = 4 * M_PI * Eigen::Vector2d(inner * inner, radius * radius);
  const std::vector<double> absorption(shells.size(), depth / (2 * radius));
  return SlabLight(n).exchange(shells, absorption, area).through.col(1).sum() * 4 * n * n / area[1];
}

TEST(WallLight, balls_emit_what_the_exact_integrals_say) {
  tests::Figure off("emission of isothermal balls by layers, n = 1: off by", "%"),
      clear("share of clear balls' light that total reflection lets out, n = 1.518: off by", "%");
  for (const int layers : {3, 6}) {
    for (const double d : {0.1, 1.0, 5.0}) {
      const double exact = 1 - 2 / (d * d) * (1 - (1 + d) * std::exp(-d));
      off.add(100 * std::abs(emissivity_of_ball(1, d, layers) / exact - 1));
    }
    constexpr double n = 1.518, thin = 1e-3;
    const double all = n * n * 4 * thin / 6, leaves = 1 - std::pow(critical_cosine(n), 3);
    clear.add(100 * std::abs(emissivity_of_ball(n, thin, layers) / all / leaves - 1));
  }
  off.at_most(1);
  clear.at_most(2);
}

TEST(WallLight, sides_that_are_nearly_as_large_do_no_more_than_equal_ones) {
  const auto& rule = core::edge_rule(3);
  std::vector<SlabLayer> layers;
  for (const double thickness : {3e-4, 5e-4, 3e-4})
    layers.emplace_back(thickness, std::array<double, 3>{rule[0].s, rule[1].s, rule[2].s});
  const auto through = [&](double larger) {
    return SlabLight(1.518).exchange(layers, {30, 30, 30}, {1e-6, 1e-6 * (1 + larger)}).through;
  };
  const auto exact = through(0);
  for (const double larger : {-1e-6, -1e-8, 1e-14, 1e-11, 1e-9, 1e-7, 1e-6})
    EXPECT_LT((through(larger) - exact).norm(), 2 * std::sqrt(std::abs(larger)) * exact.norm()) << larger;
}

/// A slab's history by discrete ordinates, as in tests/verification/test_light_slabs.cpp: degC and kJ/m2.
struct History {
  const char* name;
  double thickness, start, duration;
  double tool, h;  ///< h 0: both sides are open
  double surroundings;
  std::vector<Band> bands;
  double mean, low, high, radiated;
};
const History histories[] = {
    {"reheat, grey", 8, 1000, 1.6, 0, 0, 50, {{beyond, 150}}, 984.9, 974, 974, 318},
    {"reheat, flint", 8, 1000, 1.6, 0, 0, 50, flint, 986.0, 952, 952, 291},
    {"reheat, amber", 8, 1000, 1.6, 0, 0, 50, amber, 981.6, 945, 945, 401},
    {"thin wall, grey", 3, 900, 2, 0, 0, 50, {{beyond, 150}}, 876.2, 870, 870, 156},
    {"thin wall, flint", 3, 900, 2, 0, 0, 50, flint, 868.2, 851, 851, 232},
    {"thin wall, amber", 3, 900, 2, 0, 0, 50, amber, 859.3, 842, 842, 316},
    {"hold, grey", 3, 870, 3.5, 450, 1000, 700, {{beyond, 150}}, 766.5, 637, 822, 114},
    {"hold, flint", 3, 870, 3.5, 450, 1000, 700, flint, 764.8, 633, 820, 145},
    {"hold, amber", 3, 870, 3.5, 450, 1000, 700, amber, 758.0, 632, 808, 209},
};

TEST(WallLight, slabs_cool_as_discrete_ordinates_say) {
  tests::Figure mean("slabs that cool in space: mean off by", "K"), skin("their skins off by", "K"),
      heat("their heat of light off by", "kJ/m2");
  for (const History& at : histories) {
    const Slab slab(glass_of(at.bands), 1e-3 * at.thickness, 6, at.start + celsius, at.h > 0 ? 1.2 : 0,
                    at.tool + celsius);
    SolidProblem problem = slab.problem(at.surroundings + celsius, at.h);
    problem.bodies[0].exchange.resize(6);
    for (const Index open : {z_low, z_high})
      problem.bodies[0].exchange[open] = SurfaceExchange{20, at.surroundings + celsius, 0, 300};
    SolidStepMatrix matrix;
    const StepOutcome end = advance(problem, 0, slab.temperature, at.duration, {}, matrix);
    ASSERT_TRUE(end.converged) << end.reason;
    const double content = heat_content(problem.bodies[0], end.temperature[0]);
    mean.add(std::abs(content_reference + content / slab.mass.sum() / 1300 - celsius - at.mean));
    skin.add(std::abs(end.temperature[0][0] - celsius - at.low));
    skin.add(std::abs(end.temperature[0][slab.glass.mesh.node_count() - 1] - celsius - at.high));
    double radiated = end.balance.bodies[0].light_to_air;
    for (const PairBalance& pair : end.balance.pairs) radiated += pair.radiated;
    heat.add(std::abs(1e-3 * radiated / (side * side) - at.radiated));
  }
  mean.at_most(0.3);
  skin.at_most(1);
  heat.at_most(1);
}

TEST(WallLight, what_the_glass_loses_is_what_air_and_tool_get) {
  std::vector<Band> varying = flint;
  varying[0].relative = {{800, 1500}, {1, 0.5}};
  Slab slab(glass_of(varying), 0.005, 4, 1400, 0.7, 750);
  for (Vector3& x : slab.glass.mesh.nodes) x[2] *= 1 + 20 * x[0];  // no plane slab: its volumes and areas are uneven
  slab.mass = masses(slab.glass.mesh, core::hexahedron_table(), slab.material);
  slab.steel = {7200, core::constant(600), core::constant(30), {}};
  const SolidProblem problem = slab.problem(500, 800);
  SolidStepMatrix matrix;
  const StepOutcome end = advance(problem, 0, slab.temperature, 0.5, {}, matrix);
  ASSERT_TRUE(end.converged) << end.reason;
  const double passed = end.balance.pairs[0].heat;
  EXPECT_GT(end.balance.pairs[0].radiated, 0.01 * passed);
  EXPECT_GT(end.balance.bodies[0].light_to_air, end.balance.pairs[0].radiated);
  tests::Figure off("light in space: heat that no balance explains, share of what passed");
  for (Index body = 0; body < 2; ++body) {
    off.add(std::abs(imbalance(end.balance, body)) / passed);
    const double stored = heat_content(problem.bodies[body], end.temperature[body]) -
                          heat_content(problem.bodies[body], slab.temperature[body]);
    EXPECT_NEAR(end.balance.bodies[body].content_change, stored, 1e-10 * passed);
  }
  off.add(flux_mismatch(end.balance));
  off.at_most(1e-12);
}

TEST(WallLight, in_equilibrium_nothing_happens) {
  Slab slab(glass_of(amber), 0.004, 3, 1000, 0.7, 1000);
  for (Vector3& x : slab.glass.mesh.nodes) x[2] *= 1 + 30 * x[0] * x[1] / side;
  slab.mass = masses(slab.glass.mesh, core::hexahedron_table(), slab.material);
  SolidStepMatrix matrix;
  const StepOutcome end = advance(slab.problem(1000, 800), 0, slab.temperature, 1, {}, matrix);
  ASSERT_TRUE(end.converged) << end.reason;
  EXPECT_LT((end.temperature[0].array() - 1000).abs().maxCoeff(), 1e-8);
}

TEST(WallLight, in_equilibrium_nothing_happens_also_where_ways_through_the_wall_are_bent) {
  Slab slab(glass_of(amber), 0.004, 3, 1000);
  const std::vector<Vector3> upright = slab.glass.mesh.nodes;
  constexpr double lean = 2;
  for (const auto& cell : slab.glass.mesh.cells)
    for (int n = 0; n < 27; ++n) {  // nodes in the middle of a layer stay above those of its low side
      const double height = upright[cell[n < 18 ? n % 9 : n]][2];
      slab.glass.mesh.nodes[cell[n]][0] = upright[cell[n]][0] + lean * height;
    }
  slab.mass = masses(slab.glass.mesh, core::hexahedron_table(), slab.material);
  ASSERT_GT(slab.mass.minCoeff(), 0);
  SolidStepMatrix matrix;
  const StepOutcome end = advance(slab.problem(1000), 0, slab.temperature, 1, {}, matrix);
  ASSERT_TRUE(end.converged) << end.reason;
  EXPECT_LT((end.temperature[0].array() - 1000).abs().maxCoeff(), 1e-8);
}

TEST(WallLight, a_side_that_sees_itself_keeps_its_light) {
  const Slab slab(glass_of(flint), 0.006, 4, 1300);
  SolidProblem problem = slab.problem(300);
  SolidStepMatrix matrix;
  const double both = advance(problem, 0, slab.temperature, 1e-4, {}, matrix).balance.bodies[0].light_to_air;
  problem.bodies[0].light.surroundings[z_low].reset();
  // What is sent back goes through the wall and leaves on the other side, where the slab is as thick as twice its wall.
  const double one = advance(problem, 0, slab.temperature, 1e-4, {}, matrix).balance.bodies[0].light_to_air;
  EXPECT_GT(one, 0.5 * both);
  problem.bodies[0].light.surroundings[z_low] = core::TimeFunction(300);
  problem.bodies[0].own_view = {0, 0, 0, 0, 0.5, 0};
  const double half = advance(problem, 0, slab.temperature, 1e-4, {}, matrix).balance.bodies[0].light_to_air;
  EXPECT_GT(half, one);
  EXPECT_LT(half, both);
  problem.bodies[0].light.surroundings[z_low].reset();
  EXPECT_LT(one, both);
  problem.bodies[0].light.surroundings[z_high].reset();
  EXPECT_LT(std::abs(advance(problem, 0, slab.temperature, 1e-4, {}, matrix).balance.bodies[0].to_air), 1e-12 * both);
}

}  // namespace
}  // namespace parison::thermal::test
