// SPDX-License-Identifier: GPL-3.0-or-later
// One body against exact solutions.
#include <gtest/gtest.h>

#include <numeric>

#include "figure.hpp"
#include "thermal/bodies.hpp"
#include "thermal/properties.hpp"
#include "thermal/time/ida.hpp"
#include "thermal/time/tr_bdf2.hpp"
#include "thermal/varying.hpp"

namespace parison::thermal::test {
namespace {

using core::Geometry;

double bisect(const std::function<double(double)>& f, double low, double high) {
  for (int i = 0; i < 200; ++i) {
    const double mid = 0.5 * (low + high);
    (f(low) * f(mid) <= 0 ? high : low) = mid;
  }
  return 0.5 * (low + high);
}

/// Advances in one call; asserts success.
StepOutcome run(const Problem& problem, const Eigen::VectorXd& start, double dt, const StepOptions& options) {
  StepMatrix matrix;
  StepOutcome outcome = advance(problem, 0, {start}, dt, options, matrix);
  EXPECT_TRUE(outcome.converged) << outcome.reason;
  return outcome;
}

TEST(Conduction, a_slab_cooled_on_one_face_follows_the_series_solution) {
  const Material material{2500, core::constant(1282), core::constant(2.77), {}};
  const double length = 0.01, h = 800, start = 1400, air = 300;
  const double biot = h * length / 2.77, diffusivity = 2.77 / (2500 * 1282.0);
  const core::Mesh mesh = rectangle(divide(0, length, 30, 0.9), {0, 0.001});
  Problem problem{Geometry::planar, {body(mesh, material)}, {}, {}};
  problem.bodies[0].exchange[right] = SurfaceExchange{h, air, 0, 300};
  std::vector<double> roots;
  for (int n = 0; n < 60; ++n)
    roots.push_back(bisect([&](double m) { return m * std::sin(m) - biot * std::cos(m); }, n * M_PI, (n + 0.5) * M_PI));
  const auto exact = [&](double x, double t) {
    double sum = 0;
    for (const double mu : roots)
      sum += 4 * std::sin(mu) / (2 * mu + std::sin(2 * mu)) * std::cos(mu * x / length) *
             std::exp(-mu * mu * diffusivity * t / (length * length));
    return air + (start - air) * sum;
  };
  StepOptions options;
  options.tolerance = 0.01;
  tests::Figure off("slab cooled on one face against its series: off by", "K");
  Eigen::VectorXd temperature = Eigen::VectorXd::Constant(mesh.node_count(), start);
  double lost = 0, time = 0;
  for (const double until : {0.5, 5.0, 30.0}) {
    const StepOutcome outcome = run(problem, temperature, until - time, options);
    temperature = outcome.temperature[0];
    lost += outcome.balance.bodies[0].to_air;
    time = until;
    for (Index i = 0; i < mesh.node_count(); ++i) off.add(std::abs(temperature[i] - exact(mesh.nodes[i][0], time)));
  }
  off.at_most(0.03);
  double mean = 0;
  for (const auto& at : core::edge_rule(5))
    for (int part = 0; part < 20; ++part) mean += at.weight / 20 * exact(length * (part + at.s) / 20, time);
  EXPECT_NEAR(lost / (2500 * 1282 * length * 0.001 * (start - mean)), 1, 1e-4);
}

TEST(Conduction, a_cylinder_cooled_on_its_mantle_follows_the_Bessel_series) {
  const Material material{7800, core::constant(620), core::constant(37), {}};
  const double radius = 0.02, h = 3000, start = 1000, air = 300, diffusivity = 37 / (7800 * 620.0);
  const double biot = h * radius / 37;
  const core::Mesh mesh = rectangle(divide(0, radius, 20, 0.95), {0, 0.002, 0.004});
  Problem problem{Geometry::axisymmetric, {body(mesh, material)}, {}, {}};
  problem.bodies[0].exchange[right] = SurfaceExchange{h, air, 0, 300};
  const auto j1 = [](double x) { return std::cyl_bessel_j(1, x); };
  std::vector<double> roots;  // one between neighbouring zeros of J1, the first zero being 0
  for (int n = 0; n < 30; ++n) {
    const double below = n == 0 ? 1e-9 : bisect(j1, (n + 0.25) * M_PI - 0.5, (n + 0.25) * M_PI + 0.5);
    const double above = bisect(j1, (n + 1.25) * M_PI - 0.5, (n + 1.25) * M_PI + 0.5);
    roots.push_back(bisect([&](double x) { return x * j1(x) - biot * std::cyl_bessel_j(0, x); }, below, above));
  }
  const auto exact = [&](double r, double t) {
    double sum = 0;
    for (const double z : roots) {
      const double j0z = std::cyl_bessel_j(0, z), j1z = j1(z);
      sum += 2 / z * j1z / (j0z * j0z + j1z * j1z) * std::cyl_bessel_j(0, z * r / radius) *
             std::exp(-z * z * diffusivity * t / (radius * radius));
    }
    return air + (start - air) * sum;
  };
  StepOptions options;
  options.tolerance = 0.01;
  tests::Figure off("cylinder cooled on its mantle against its Bessel series: off by", "K");
  const Eigen::VectorXd initial = Eigen::VectorXd::Constant(mesh.node_count(), start);
  for (const double time : {0.5, 5.0}) {
    const StepOutcome outcome = run(problem, initial, time, options);
    for (Index i = 0; i < mesh.node_count(); ++i)
      off.add(std::abs(outcome.temperature[0][i] - exact(mesh.nodes[i][0], time)));
  }
  off.at_most(0.03);
}

TEST(Conduction, the_error_falls_with_the_third_power_of_the_element_size_for_varying_properties) {
  const Varying v;
  const double time = 0.3;
  std::vector<double> errors;
  for (const int n : {4, 8, 16}) {
    const core::Mesh mesh = rectangle(divide(0, v.side, n, std::pow(2, 1.0 / n)), divide(0, v.side, n));
    StepOptions options;
    options.tolerance = 1e-4;
    const auto start = sample(mesh, [&](const Point& x) { return v.exact(x, 0); });
    const StepOutcome outcome = run(v.problem(mesh), start, time, options);
    const auto exact = [&](const Point& x) { return v.exact(x, time); };
    errors.push_back(distance(mesh, Geometry::planar, outcome.temperature[0], exact));
  }
  EXPECT_GT(std::log2(errors[0] / errors[1]), 2.7);
  tests::expect_at_least("heat with k(T) and c(T), manufactured: order in space", std::log2(errors[1] / errors[2]),
                         2.9);
  EXPECT_LT(errors[2], 0.1);
}

TEST(Conduction, the_error_falls_with_the_second_power_of_the_substep) {
  const Varying v;
  const core::Mesh mesh = rectangle(divide(0, v.side, 8), divide(0, v.side, 8));
  const auto start = sample(mesh, [&](const Point& x) { return v.exact(x, 0); });
  const Problem problem = v.problem(mesh);
  const double time = 0.8;
  IdaIntegrator reference(problem, 0, {start}, {1e-6});
  const IdaOutcome exact = reference.advance_to(time);
  ASSERT_TRUE(exact.converged) << exact.reason;
  std::vector<double> errors;
  for (const int substeps : {8, 16, 32}) {
    StepOptions options;
    options.tolerance = 1e9;
    options.initial_substep = options.max_substep = time / substeps;
    const StepOutcome outcome = run(problem, start, time, options);
    EXPECT_EQ(outcome.substeps, substeps);
    errors.push_back((outcome.temperature[0] - exact.temperature[0]).lpNorm<Eigen::Infinity>());
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.2);
  EXPECT_LT(std::log2(errors[1] / errors[2]), 2.1);
  tests::expect_at_least("the same: order in time of TR-BDF2", std::log2(errors[1] / errors[2]), 1.9);
}

TEST(Conduction, a_Rosseland_slab_between_given_temperatures_follows_the_Kirchhoff_transform) {
  const Material material{2400, core::constant(1300), core::constant(1.3), Radiation{1.518, 150, true}};
  const double length = 0.008, hot = 1500, cold = 800;
  const core::Mesh mesh = rectangle(divide(0, length, 60), {0, length / 60});
  const Eigen::VectorXd wall = Eigen::VectorXd::Constant(mesh.node_count(), length);
  const Radiation& r = *material.radiation;
  const double radiant = 4.0 / 3 * r.refractive_index * r.refractive_index * stefan_boltzmann / r.absorption /
                         (1 + 4 / (3 * r.absorption * length));
  const auto transform = [&](double T) { return 1.3 * T + radiant * std::pow(T, 4); };
  Problem problem{Geometry::planar, {body(mesh, material)}, {}, {}};
  problem.bodies[0].wall_thickness = &wall;
  problem.bodies[0].prescribed[left] = hot;
  problem.bodies[0].prescribed[right] = cold;
  tests::Figure off("Rosseland slab with thin-wall factor against the Kirchhoff transform: off by", "K");
  const StepOutcome steady = run(problem, Eigen::VectorXd::Constant(mesh.node_count(), 1000), 1e5, {});
  for (Index i = 0; i < mesh.node_count(); ++i) {
    const double x = mesh.nodes[i][0] / length;
    const double here = (1 - x) * transform(hot) + x * transform(cold);
    off.add(std::abs(steady.temperature[0][i] - bisect([&](double T) { return transform(T) - here; }, cold, hot)));
  }
  off.at_most(2e-3);
  const Response response = evaluate(make_heat_system(problem), 0, steady.temperature[0]);
  double flux = 0;
  for (Index i = 0; i < mesh.node_count(); ++i)
    if (mesh.nodes[i][0] == 0) flux -= response.power[i] / (length / 60);
  EXPECT_NEAR(flux / ((transform(hot) - transform(cold)) / length), 1, 1e-5);
}

TEST(Conduction, the_heat_through_a_given_temperature_is_the_steady_flux) {
  const Material material{2400, core::constant(1300), core::constant(1.3), {}};
  const core::Mesh mesh = rectangle(divide(0, 0.01, 4), {0, 0.002});
  Problem problem{Geometry::planar, {body(mesh, material)}, {}, {}};
  problem.bodies[0].prescribed[left] = 1000;
  problem.bodies[0].exchange[right] = SurfaceExchange{50, 300, 0, 300};
  const double surface = 300 + 700 / (1 + 50 * 0.01 / 1.3), flux = 50 * (surface - 300);
  const auto start = sample(mesh, [&](const Point& x) { return 1000 + (surface - 1000) * x[0] / 0.01; });
  const StepOutcome outcome = run(problem, start, 2.0, {});
  EXPECT_NEAR(outcome.balance.bodies[0].from_prescribed / (flux * 0.002 * 2), 1, 1e-10);
  EXPECT_NEAR(outcome.balance.bodies[0].to_air / (flux * 0.002 * 2), 1, 1e-10);
  EXPECT_NEAR((outcome.temperature[0] - start).lpNorm<Eigen::Infinity>(), 0, 1e-9);
}

TEST(Conduction, a_stretched_body_keeps_its_mass) {
  // Drawn out to twice its length it conducts like a body of half the density on the stretched mesh.
  Material material{2400, {{300, 1500}, {900, 1400}}, core::constant(1.3), {}};
  const core::Mesh before = rectangle(divide(0, 0.005, 8), {0, 0.002});
  core::Mesh after = before;
  for (Point& x : after.nodes) x[0] *= 2;
  const auto start = sample(before, [](const Point& x) { return 1400 - 4e6 * x[0] * x[0]; });
  Problem moved{Geometry::planar, {body(before, material)}, {}, {}};
  moved.bodies[0].mesh = &after;
  Problem thinned{Geometry::planar, {body(after, material)}, {}, {}};
  thinned.bodies[0].density = 1200;
  StepOptions tight;
  tight.newton_tolerance = 1e-9;
  const StepOutcome a = run(moved, start, 1, tight), b = run(thinned, start, 1, tight);
  EXPECT_LT((a.temperature[0] - b.temperature[0]).lpNorm<Eigen::Infinity>(), 1e-7);
  EXPECT_GT((a.temperature[0] - start).lpNorm<Eigen::Infinity>(), 1);
  EXPECT_NEAR(heat_content(moved.bodies[0], Geometry::planar, a.temperature[0]) /
                  heat_content(moved.bodies[0], Geometry::planar, start),
              1, 1e-12);
}

TEST(Conduction, a_source_raises_an_insulated_body_by_its_heat) {
  const Material material{2400, core::constant(1300), core::constant(1.3), {}};
  const core::Mesh mesh = rectangle(divide(0.01, 0.02, 4), divide(0, 0.01, 3));
  std::vector<double> source;
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (const auto& at : core::triangle_rule(4))
      source.push_back(2e7 * core::map_cell_point(mesh, c, Geometry::axisymmetric, at).volume);
  Problem problem{Geometry::axisymmetric, {body(mesh, material)}, {}, {}};
  problem.bodies[0].source = &source;
  const StepOutcome outcome = run(problem, Eigen::VectorXd::Constant(mesh.node_count(), 1000), 0.5, {});
  for (const double T : outcome.temperature[0]) EXPECT_NEAR(T, 1000 + 2e7 * 0.5 / (2400 * 1300.0), 1e-8);
  const double heat = 0.5 * std::accumulate(source.begin(), source.end(), 0.0);
  EXPECT_NEAR(outcome.balance.bodies[0].from_source / heat, 1, 1e-13);
}

}  // namespace
}  // namespace parison::thermal::test
