#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// What light has to fulfil by whatever model it is computed.
#include <gtest/gtest.h>

#include "figure.hpp"
#include "thermal/radiation/glass_on_tool.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::thermal::test {

/// The light of the first body without all else: power into each unknown, and where it flows, W.
struct LightFlows {
  Eigen::VectorXd power;
  Flows flows;

  LightFlows(const HeatSystem& system, const Eigen::VectorXd& T)
      : power(Eigen::VectorXd::Zero(system.size())), flows(evaluate_flows(system, 0, T)) {
    for (auto* flow : {&flows.to_air, &flows.light_to_air, &flows.across, &flows.received, &flows.radiated})
      flow->setZero();
    add_light(system.light[0], system, 0, T, flows, &power);
  }
  /// What the sources in the glass differ by from the light through its surface, W.
  double imbalance(const HeatSystem& system) const {
    const double in_glass = power.head(system.first_unknown[1]).sum();
    return std::abs(in_glass + flows.to_air[0] + flows.across[0]);
  }
  double through_surface() const { return flows.to_air[0] + std::abs(flows.across[0]); }
};

/// Light neither heats nor flows where all is at one temperature, K.
inline void expect_no_light(const Problem& problem, double temperature) {
  const HeatSystem system = make_heat_system(problem);
  const Eigen::VectorXd T = Eigen::VectorXd::Constant(system.size(), temperature);
  const double scale = evaluate_flows(system, 0, T).to_air.cwiseAbs().maxCoeff();
  const LightFlows light(system, T);
  EXPECT_LT(light.power.lpNorm<Eigen::Infinity>(), 1e-11 * scale);
  EXPECT_NEAR(light.flows.to_air[0] / scale, 0, 1e-11);
  EXPECT_NEAR(light.flows.across[0] / scale, 0, 1e-11);
}

/// The derivative of the residual of a step along some direction, at scattered temperatures.
struct StepDerivative {
  static constexpr double step = 0.5, small = 1e-2;  // s, K
  HeatSystem system;
  Eigen::VectorXd direction, difference, product;
  Linearisation derivatives;

  explicit StepDerivative(const GlassOnTool& pair) : system(make_heat_system(pair.problem)), direction(system.size()) {
    const Eigen::VectorXd T = scattered(system, pair.start);
    std::mt19937 random(2);
    for (double& d : direction) d = std::uniform_real_distribution<double>(-1, 1)(random);
    const auto residual = [&](double shift) -> Eigen::VectorXd {
      const Response response = evaluate(system, 0, T + shift * direction);
      return response.content - step * response.power;
    };
    difference = (residual(small) - residual(-small)) / (2 * small);
    derivatives = linearise(system, 0, T);
    product = apply(system, derivatives, step, direction);
  }
  /// Of the derivative from finite differences, over these.
  double error() const { return (product - difference).lpNorm<Eigen::Infinity>() / size(); }
  /// What a change of `derivatives` since then makes, over the finite differences.
  double change() const {
    return (apply(system, derivatives, step, direction) - product).lpNorm<Eigen::Infinity>() / size();
  }

 private:
  double size() const { return difference.lpNorm<Eigen::Infinity>(); }
};

/// A step of ten seconds in one substep; records as `what` how far its balance is open.
inline StepOutcome step_of_ten_seconds(Model model, const std::string& what) {
  tests::Figure open(what);
  const GlassOnTool pair(Geometry::axisymmetric, {{2.75e-6, 400}, {4.3e-6, 700}}, 320, 0.9, model);
  StepMatrix matrix;
  StepOptions options;
  options.tolerance = 1e9;
  const StepOutcome outcome = advance(pair.problem, 0, pair.start, 10, options, matrix);
  EXPECT_TRUE(outcome.converged) << outcome.reason;
  EXPECT_EQ(outcome.substeps, 1);
  EXPECT_LT(outcome.temperature[0].maxCoeff(), 1401);
  for (const Index b : {0, 1})
    open.add(std::abs(imbalance(outcome.balance, b) / outcome.balance.bodies[b].content_change));
  open.at_most(1e-9);
  return outcome;
}

/// Order in time, from 16 and 32 substeps of half a second against `finest` ones.
inline double order_in_time(Model model, int finest) {
  const GlassOnTool pair(Geometry::axisymmetric, flint, 320, 0.9, model);
  std::vector<Eigen::VectorXd> found;
  for (const int substeps : {16, 32, finest}) {
    StepMatrix matrix;
    StepOptions options;
    options.tolerance = 1e9;
    options.initial_substep = options.max_substep = 0.5 / substeps;
    const StepOutcome outcome = advance(pair.problem, 0, pair.start, 0.5, options, matrix);
    EXPECT_TRUE(outcome.converged) << outcome.reason;
    found.push_back(outcome.temperature[0]);
  }
  const auto error = [&](int i) { return (found[i] - found[2]).lpNorm<Eigen::Infinity>(); };
  return std::log2(error(0) / error(1));
}

/// Optical thicknesses of grey slabs in radiative equilibrium between black walls, and their exact flux over that
/// between the walls without them.
inline constexpr std::pair<double, double> exact_flux[] = {{0.1, 0.9157}, {1, 0.5532}, {10, 0.1167}};

/// Such a slab between 800 K on its right and 1500 K on its left.
struct EquilibriumSlab {
  static constexpr double length = 0.01;
  Material material;
  core::Mesh mesh = rectangle(divide(0, length, 30), {0, length / 30});
  Problem problem;
  Eigen::VectorXd temperature;

  EquilibriumSlab(double thickness, Model model, double emissivity)
      : material(glass_with({{everything, thickness / length}}, 1, 1e-9, model)) {
    problem = {Geometry::planar, {open_body(mesh, material, 800, emissivity)}, {}, {}};
    problem.bodies[0].light.surroundings = {{}, core::TimeFunction(800), {}, core::TimeFunction(1500)};
    StepMatrix matrix;
    StepOptions options;
    options.tolerance = 1;
    const StepOutcome outcome =
        advance(problem, 0, {Eigen::VectorXd::Constant(mesh.node_count(), 1200)}, 1e6, options, matrix);
    EXPECT_TRUE(outcome.converged) << outcome.reason;
    temperature = join(make_heat_system(problem), outcome.temperature);
  }
  EquilibriumSlab(const EquilibriumSlab&) = delete;
  /// A flux, W/m2, over that between the walls.
  static double share(double flux) { return flux / (stefan_boltzmann * (std::pow(1500, 4) - std::pow(800, 4))); }
};

/// Glass whose temperatures vary over many free paths.
struct ThickGlass {
  static constexpr double length = 0.05, absorption = 1500;
  core::Mesh mesh = rectangle(divide(0, length, 100), {0, length / 100});
  Eigen::VectorXd T = sample(mesh, [](const Point& x) { return 1200 + 150 * std::cos(M_PI * x[0] / length); });

  /// Power into each node by light; by conduction.
  Eigen::VectorXd by_light(BodyView view) const {
    view.absorption_at = &T;
    return evaluate(make_heat_system({Geometry::planar, {std::move(view)}, {}, {}}), 0, T).power;
  }
  Eigen::VectorXd by_conduction(Material material, const Radiation& radiation) const {
    material.radiation = radiation;
    return evaluate(make_heat_system({Geometry::planar, {body(mesh, material)}, {}, {}}), 0, T).power;
  }
  /// By how much light differs from such conduction far from the walls, %.
  double off(const Material& material, const Radiation& rosseland) const {
    BodyView view = body(mesh, material);
    view.light.surroundings.resize(4);
    const Eigen::VectorXd a = by_light(view), b = by_conduction(material, rosseland);
    return 100 * (a - b).norm() / b.norm();
  }
};

}  // namespace parison::thermal::test
