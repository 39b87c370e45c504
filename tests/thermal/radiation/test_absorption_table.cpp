// SPDX-License-Identifier: GPL-3.0-or-later
// Absorption that depends on temperature.
#include <gtest/gtest.h>

#include "figure.hpp"
#include "thermal/radiation/camera/line_of_sight.hpp"
#include "thermal/radiation/exact_emission.hpp"
#include "thermal/radiation/light_checks.hpp"

namespace parison::thermal::test {
namespace {

constexpr Model models[] = {Model::p1, Model::p1_cones, Model::transfer};

/// Bands whose absorption falls to a half or rises to threefold between 1000 and 1600 K.
const std::vector<Band> varying{{2.75e-6, 30, {{1000, 1600}, {1, 3}}},
                                {4.3e-6, 450, {{1000, 1300, 1600}, {1, 0.8, 0.5}}}};

/// Power into each unknown by all that the glass on its tool has, with absorption at its scattered temperatures.
Eigen::VectorXd power_with(const std::vector<Band>& bands, Model model, double temperature = 0) {
  GlassOnTool pair(Geometry::axisymmetric, bands, 320, 0.9, model);
  Eigen::VectorXd T =
      scattered(make_heat_system(GlassOnTool(Geometry::axisymmetric, {}, 320, 0.9, model).problem), pair.start);
  const Eigen::VectorXd at = temperature > 0 ? Eigen::VectorXd::Constant(pair.upper.node_count(), temperature)
                                             : Eigen::VectorXd(T.head(pair.upper.node_count()));
  if (temperature > 0) T.setConstant(temperature);
  pair.problem.bodies[0].absorption_at = &at;
  return evaluate(make_heat_system(pair.problem), 0, T).power;
}

TEST(AbsorptionTable, that_is_the_same_at_all_temperatures_is_a_constant) {
  const core::Table same{{900, 1200, 1700}, {1, 1, 1}};
  for (const Model model : models) {
    const Eigen::VectorXd a = power_with({{2.75e-6, 30, same}, {4.3e-6, 450, same}}, model),
                          b = power_with(flint, model);
    EXPECT_LT((a - b).lpNorm<Eigen::Infinity>(), 1e-12 * b.lpNorm<Eigen::Infinity>());
  }
}

TEST(AbsorptionTable, in_glass_of_one_temperature_is_the_constant_of_that_temperature) {
  for (const Model model : models) {
    const Eigen::VectorXd a = power_with(varying, model, 1300),
                          b = power_with({{2.75e-6, 60}, {4.3e-6, 360}}, model, 1300);
    EXPECT_LT((a - b).lpNorm<Eigen::Infinity>(), 1e-12 * b.lpNorm<Eigen::Infinity>());
  }
}

/// What the sources of a band in the glass differ by from its light through the surface, over what crosses that.
double imbalance_of_band(const Band& band, Geometry geometry, Model model) {
  GlassOnTool pair(geometry, {band}, 320, 0, model);
  const Eigen::VectorXd at = sample(pair.upper, [](const Point& x) { return 1000 + 3e4 * x[0] + 4e4 * x[1]; });
  pair.problem.bodies[0].absorption_at = &at;
  const HeatSystem system = make_heat_system(pair.problem);
  const LightFlows light(system, scattered(system, pair.start));
  EXPECT_GT(std::abs(light.flows.radiated[0]), 0);
  return light.imbalance(system) / light.through_surface();
}

TEST(AbsorptionTable, keeps_the_balance_of_each_band) {
  tests::Figure off(
      "absorption by temperature: sources of a band in the glass against its light through the surface: off by");
  for (const Model model : models)
    for (const Geometry geometry : {Geometry::planar, Geometry::axisymmetric})
      for (const Band& band : varying) off.add(imbalance_of_band(band, geometry, model));
  off.at_most(1e-12);
}

TEST(AbsorptionTable, lets_nothing_flow_where_all_is_at_one_temperature_wherever_it_absorbs_more) {
  for (const Model model : models) {
    GlassOnTool pair(Geometry::axisymmetric, varying, 1400, 0.9, model);
    const Eigen::VectorXd at = sample(pair.upper, [](const Point& x) { return 1000 + 3e4 * x[0] + 4e4 * x[1]; });
    pair.problem.bodies[0].absorption_at = &at;
    expect_no_light(pair.problem, 1400);
  }
}

/// A slab of grey glass between a mirror and cold surroundings, hot at the mirror, whose absorption rises by
/// temperature.
struct UnevenSlab {
  static constexpr double length = 0.01;
  Band band;

  static double temperature(double x) { return 1500 - 500 * x / length; }
  double absorption(double x) const { return band.absorption * band.relative(temperature(x)); }

  /// Flux out of the glass, W/m2, by integration along all rays that leave: that towards the surface and that from the
  /// mirror, with all reflections between.
  double exact(double index) const {
    constexpr int parts = 4000;
    std::vector<double> depth{0}, emission;
    for (int i = 0; i < parts; ++i) {
      const double x = (i + 0.5) * length / parts;
      depth.push_back(depth.back() + absorption(x) * length / parts);
      emission.push_back(index * index * stefan_boltzmann * std::pow(temperature(x), 4));
    }
    const auto leaving = [&](double mu) {
      double forth = 0, back = 0;
      for (int i = 0; i < parts; ++i) {
        const double part = -std::expm1(-(depth[i + 1] - depth[i]) / mu) * emission[i];
        forth += part * std::exp(-(depth.back() - depth[i + 1]) / mu);
        back += part * std::exp(-depth[i] / mu);
      }
      const double R = fresnel_reflectivity(index, mu), passed = std::exp(-depth.back() / mu);
      return (1 - R) * (forth + back * passed) / (1 - R * passed * passed);
    };
    return 2 * integrate([&](double mu) { return mu * leaving(mu); }, critical_cosine(index));
  }

  double found(Model model, double index) const {
    const core::Mesh mesh = even_mesh();
    return flux(mesh, glass_with({band}, index, 1e-9, model), temperatures());
  }

  /// The same of a slab that absorbs alike everywhere, with the same temperatures at the same optical depths.
  double found_by_depth(Model model, double index) const {
    core::Mesh mesh = even_mesh();
    for (Point& x : mesh.nodes) x[0] = depth(x[0]) / band.absorption;
    return flux(mesh, glass_with({{everything, band.absorption}}, index, 1e-9, model), temperatures());
  }

 private:
  static constexpr int cells = 40;
  static core::Mesh even_mesh() { return rectangle(divide(0, length, cells), {0, length / cells}); }
  static Eigen::VectorXd temperatures() {
    return sample(even_mesh(), [](const Point& x) { return temperature(x[0]); });
  }
  double depth(double to) const {
    constexpr int parts = 1000;
    double sum = 0;
    for (int i = 0; i < parts; ++i) sum += absorption((i + 0.5) * to / parts) * to / parts;
    return sum;
  }
  static double flux(const core::Mesh& mesh, const Material& material, const Eigen::VectorXd& T) {
    Problem problem{Geometry::planar, {body(mesh, material)}, {}, {}};
    problem.bodies[0].light.surroundings.resize(4);
    problem.bodies[0].light.surroundings[right] = core::TimeFunction(0);
    problem.bodies[0].absorption_at = &T;
    return evaluate_flows(make_heat_system(problem), 0, T).to_air[0] * cells / length;
  }
};

const std::vector<Band> uneven{{everything, 30, {{1000, 1500}, {1, 8}}},
                               {everything, 300, {{1000, 1200, 1500}, {1, 0.3, 1 / 6.0}}},
                               {everything, 400, {{1000, 1500}, {1, 3}}}};

TEST(AbsorptionTable, gives_an_uneven_slab_the_light_that_integration_along_the_rays_gives) {
  tests::Figure off(
      "transfer: light of a slab at 1000 to 1500 K whose absorption rises eightfold or falls to a sixth by "
      "temperature, n = 1 and 1.518: off by",
      "%"),
      p1("the same by P1 in cones", "%");
  for (const double index : {1.0, 1.518})
    for (const Band& band : uneven) {
      const UnevenSlab slab{band};
      const double wanted = slab.exact(index), found = slab.found(Model::transfer, index),
                   by_p1 = slab.found(Model::p1_cones, index);
      std::printf("n = %g, from %g 1/m: %.5g W/m2, exact %.5g; P1 in cones %.5g\n", index, band.absorption, found,
                  wanted, by_p1);
      off.add(100 * std::abs(found / wanted - 1));
      p1.add(100 * std::abs(by_p1 / wanted - 1));
    }
  off.at_most(1);
  p1.for_comparison();
}

TEST(AbsorptionTable, makes_a_slab_the_same_as_one_of_its_optical_depths) {
  for (const Model model : models) {
    tests::Figure off(fmt::format("{}: light of such slabs against those that absorb alike, by optical depth: off by",
                                  model == Model::p1         ? "P1"
                                  : model == Model::p1_cones ? "P1 in cones"
                                                             : "transfer"),
                      "%");
    for (const Band& band : uneven) {
      const UnevenSlab slab{band};
      off.add(100 * std::abs(slab.found(model, 1.518) / slab.found_by_depth(model, 1.518) - 1));
    }
    off.at_most(model == Model::transfer ? 1 : 0.02);
  }
}

TEST(AbsorptionTable, is_that_of_Rosseland_in_thick_glass) {
  const core::Table table{{1000, 1400}, {1, 1.4}};
  tests::expect_at_most(
      "P1, absorption by temperature: sources in glass of some 75 free paths against Rosseland's conduction: off by",
      ThickGlass().off(glass_with({{everything, ThickGlass::absorption, table}}),
                       Radiation{1.518, ThickGlass::absorption, false, Model::rosseland, {}, table}),
      1, "%");
}

/// Temperatures of glass and tool after half a second in equal steps.
Eigen::VectorXd after(const GlassOnTool& pair, int steps) {
  StepMatrix matrix;
  StepOptions options;
  options.tolerance = 1e9;
  std::vector<Eigen::VectorXd> T = pair.start;
  for (int i = 0; i < steps; ++i) {
    StepOutcome outcome = advance(pair.problem, 0.5 * i / steps, T, 0.5 / steps, options, matrix);
    EXPECT_TRUE(outcome.converged) << outcome.reason;
    for (const Index b : {0, 1}) {
      const double change = outcome.balance.bodies[b].content_change;
      EXPECT_NEAR(imbalance(outcome.balance, b) / change, 0, 1e-9);
    }
    T = std::move(outcome.temperature);
  }
  return T[0];
}

TEST(AbsorptionTable, keeps_the_order_in_time) {
  const GlassOnTool pair(Geometry::axisymmetric, varying);
  const Eigen::VectorXd fine = after(pair, 256);
  const auto error = [&](int steps) { return (after(pair, steps) - fine).lpNorm<Eigen::Infinity>(); };
  tests::expect_at_least("heat with light by P1, absorption by temperature: order in time of TR-BDF2",
                         std::log2(error(16) / error(32)), 1.8);
}

TEST(AbsorptionTable, goes_on_from_where_light_was_traced_with_the_same_bits) {
  GlassOnTool pair(Geometry::axisymmetric, varying, 320, 0.9, Model::transfer);
  StepMatrix matrix;
  StepOptions options;
  options.tolerance = 1;
  std::vector<Eigen::VectorXd> T = pair.start;
  TracedPlaces traced;
  std::size_t traces = 0;
  for (int i = 0; i < 10; ++i) {
    pair.problem.traced = &traced;
    StepMatrix fresh;
    fresh.couplings = matrix.couplings;
    matrix.factored_step = 0;
    const StepOutcome whole = advance(pair.problem, 0, T, 0.1, options, matrix);
    const StepOutcome resumed = advance(pair.problem, 0, T, 0.1, options, fresh);
    ASSERT_TRUE(whole.converged && resumed.converged) << whole.reason << resumed.reason;
    EXPECT_EQ(whole.temperature[0], resumed.temperature[0]);
    const TracedPlaces now = traced_places(matrix.kept);
    EXPECT_EQ(now.absorption, traced_places(fresh.kept).absorption);
    traces += now.absorption != traced.absorption;
    traced = now;
    T = whole.temperature;
  }
  EXPECT_GT(traces, 1u) << "the absorption has not changed by so much that light was traced again";
  EXPECT_LT(traces, 10u);
}

TEST(AbsorptionTable, of_Rosseland_divides_the_conductivity_and_deepens_the_wall) {
  Material material = glass_with({}, 1.5);
  material.radiation = Radiation{1.5, 200, true, Model::rosseland, {}, {{1000, 1600}, {1, 3}}};
  const double wall = 0.004, T = 1150, kappa = 200 * 1.5;
  const double radiant = 16.0 / 3 * 1.5 * 1.5 * stefan_boltzmann * T * T * T / kappa / (1 + 4 / (3 * kappa * wall));
  const double factor = thin_wall_factor(*material.radiation, wall);
  EXPECT_NEAR(conductivity(material, T, factor), 1.3 + radiant, 1e-12);
  const Conductivity law(material);
  PointValues at{}, thin{}, values, derivatives;
  for (int q = 0; q < 6; ++q) at[q] = VectorizedArray{} + (T + 10 * q), thin[q] = VectorizedArray{} + factor;
  law.set_values(at, thin, values);
  law.set_derivatives(at, thin, derivatives);
  for (int q = 0; q < 6; ++q) {
    EXPECT_NEAR(values[q][0], law(T + 10 * q, factor), 1e-12);
    const double slope = (law(T + 10 * q + 0.01, factor) - law(T + 10 * q - 0.01, factor)) / 0.02;
    EXPECT_NEAR(derivatives[q][3] / slope, 1, 1e-6);
  }
}

TEST(AbsorptionTable, is_what_a_camera_looks_through) {
  const core::Mesh mesh = rectangle(divide(0, 1, 1), divide(0, 0.01, 20));
  const auto seen = [&](const Band& band) {
    const Eigen::VectorXd T = Eigen::VectorXd::Constant(mesh.node_count(), 1300);
    const LineOfSight view(mesh, Geometry::planar, T, {1.5, {band}}, {1e-6, 2e-6}, 300);
    return view.radiance({{0.5, 0, 0.02}, {0, 0, -1}});
  };
  EXPECT_NEAR(seen(varying[0]) / seen({2.75e-6, 60}), 1, 1e-12);
  EXPECT_GT(seen(varying[0]) / seen({2.75e-6, 30}), 1.1);
}

}  // namespace
}  // namespace parison::thermal::test
