// SPDX-License-Identifier: GPL-3.0-or-later
// Heat in single bodies in space against exact solutions.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "figure.hpp"
#include "solid/solid_meshes.hpp"
#include "thermal/solid/solid_system.hpp"

namespace parison::thermal::test {
namespace {

const Material plain{2500, core::constant(1282), core::constant(2.77), {}};

double linear(const Vector3& x) {
  return 900 + 4000 * x[0] - 7000 * x[1] + 11000 * x[2];
}

/// Largest heat into a node that is not on the surface, over the largest on it, for a field linear in space.
double patch_residual(const SolidBodyView& view, const std::set<Index>& surface) {
  const SolidProblem problem{{view}, {}, {}};
  const SolidSystem system = make_solid_system(problem, {});
  EXPECT_EQ(why_not_solvable(system), "");
  const Eigen::VectorXd power = evaluate(system, 0, sample(*view.nodes, linear)).power;
  double inside = 0, outside = 0;
  for (Index n = 0; n < power.size(); ++n) {
    double& largest = surface.count(n) ? outside : inside;
    largest = std::max(largest, std::abs(power[n]));
  }
  EXPECT_GT(inside, 0);
  return inside / outside;
}

TEST(SolidHeat, distorted_cells_conduct_a_linear_field_exactly) {
  tests::Figure hexahedra("linear field in distorted hexahedra: heat left inside"),
      prisms("linear field in distorted prisms: heat left inside");
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-0.12, 0.12);
  for (const bool straight : {true, false}) {
    const double share = straight ? 1 : 0.25;
    Block cube = block(3, 3, 3, [&](const Vector3& x) -> Vector3 {
      const bool inside = x.minCoeff() > 0.01 && x.maxCoeff() < 0.99;
      return 0.01 * (inside ? x + share * Vector3(shift(random), shift(random), shift(random)) : x);
    });
    if (straight) straighten(cube.mesh);
    std::set<Index> surface;
    for (const auto& face : cube.faces) surface.insert(face.nodes.begin(), face.nodes.end());
    const auto mass = masses(cube.mesh, core::hexahedron_table(), plain);
    hexahedra.add(patch_residual(solid_body(cube.mesh, cube.faces, mass, plain), surface));
  }
  // A solid of revolution with its axis; all that is not on the cuts.
  const auto disc = core::sweep(rectangle(divide(0, 0.03, 3, 1.3), divide(0, 0.02, 3)), 0.2, 1.3, 3);
  std::set<Index> surface;
  for (const auto& face : disc.faces) surface.insert(face.nodes.begin(), face.nodes.end());
  for (Index n = 0; n < disc.node_count(); ++n)
    if (std::hypot(disc.nodes[n][0], disc.nodes[n][1]) < 1e-9 || std::abs(disc.angle[n] - 0.2) < 1e-9 ||
        std::abs(disc.angle[n] - 1.3) < 1e-9)
      surface.insert(n);
  const auto mass = masses(disc, core::prism_table(), plain);
  prisms.add(patch_residual(solid_body(disc, mass, plain), surface));
  EXPECT_NEAR(mass.sum(), 2500 * 0.5 * 1.1 * 0.03 * 0.03 * 0.02, 1e-4 * mass.sum());
  hexahedra.at_most(1e-12);
  prisms.at_most(1e-12);
}

TEST(SolidHeat, a_rod_with_a_source_has_the_parabola_of_the_exact_solution_on_its_axis) {
  const auto rod = core::sweep(rectangle(divide(0, 0.02, 4), divide(0, 0.01, 1)), 0, 0.8, 4);
  const auto mass = masses(rod, core::prism_table(), plain);
  SolidProblem problem{{solid_body(rod, mass, plain)}, {}, {}};
  constexpr double heating = 2e7;  // W/m3
  const Eigen::VectorXd source = heating / plain.density * mass;
  problem.bodies[0].source = &source;
  problem.bodies[0].prescribed.resize(4);
  problem.bodies[0].prescribed[right] = core::TimeFunction(600);
  const StepOutcome end = settle(problem, {Eigen::VectorXd::Constant(rod.node_count(), 600)});
  ASSERT_TRUE(end.converged) << end.reason;
  tests::Figure off("rod with a source: off by, share of its rise");
  for (Index n = 0; n < rod.node_count(); ++n) {
    const double r = std::hypot(rod.nodes[n][0], rod.nodes[n][1]), rise = heating * 0.02 * 0.02 / (4 * 2.77);
    off.add(std::abs(end.temperature[0][n] - 600 - heating * (0.02 * 0.02 - r * r) / (4 * 2.77)) / rise);
  }
  off.at_most(2e-4);
  EXPECT_NEAR(end.balance.bodies[0].from_source, 1e9 * heating * mass.sum() / plain.density,
              1e-9 * end.balance.bodies[0].from_source);
}

/// A cube that is cooled on all faces: an eighth of it, by the product of three series (H. S. Carslaw, J. C. Jaeger,
/// Conduction of Heat in Solids, 2nd ed. 1959, section 5.6).
struct CoolingCube {
  static constexpr double length = 0.01, h = 800, start = 1400, air = 300;
  std::vector<double> roots;

  CoolingCube() {
    const double biot = h * length / 2.77;
    for (int n = 0; n < 60; ++n) {
      double low = n * M_PI, high = (n + 0.5) * M_PI;
      for (int i = 0; i < 200; ++i) {
        const double mid = 0.5 * (low + high);
        (mid * std::tan(mid) < biot ? low : high) = mid;
      }
      roots.push_back(0.5 * (low + high));
    }
  }
  double slab(double x, double t) const {
    double sum = 0;
    for (const double mu : roots)
      sum += 4 * std::sin(mu) / (2 * mu + std::sin(2 * mu)) * std::cos(mu * x / length) *
             std::exp(-mu * mu * 2.77 / (2500 * 1282.0) * t / (length * length));
    return sum;
  }
  double operator()(const Vector3& x, double t) const {
    return air + (start - air) * slab(x[0], t) * slab(x[1], t) * slab(x[2], t);
  }
  SolidProblem problem(const Block& cube, const Eigen::VectorXd& mass) const {
    SolidProblem made{{solid_body(cube.mesh, cube.faces, mass, plain)}, {}, {}};
    made.bodies[0].exchange.resize(6);
    for (const Index at : {x_high, y_high, z_high}) made.bodies[0].exchange[at] = SurfaceExchange{h, air, 0, 300};
    return made;
  }
};

TEST(SolidHeat, a_cooling_cube_follows_the_series_solution) {
  const CoolingCube exact;
  const Block cube =
      block(6, 6, 6, [](const Vector3& x) -> Vector3 { return CoolingCube::length * (1 - (1 - x.array()).pow(1.4)); });
  const auto mass = masses(cube.mesh, core::hexahedron_table(), plain);
  const SolidProblem problem = exact.problem(cube, mass);
  SolidStepMatrix matrix;
  StepOptions options;
  options.tolerance = 0.05;
  tests::Figure off("cooling cube against its series: off by", "K");
  std::vector<Eigen::VectorXd> temperature{Eigen::VectorXd::Constant(cube.mesh.node_count(), exact.start)};
  double time = 0, lost = 0;
  for (const double until : {0.5, 5.0, 20.0}) {
    const StepOutcome step = advance(problem, time, temperature, until - time, options, matrix);
    ASSERT_TRUE(step.converged) << step.reason;
    temperature = step.temperature;
    time = until;
    lost += step.balance.bodies[0].to_air;
    EXPECT_LT(std::abs(imbalance(step.balance, 0)), 1e-12 * mass.sum() * 1282 * 1100);
    for (Index n = 0; n < cube.mesh.node_count(); ++n)
      off.add(std::abs(temperature[0][n] - exact(cube.mesh.nodes[n], time)));
  }
  off.at_most(2);
  EXPECT_EQ(matrix.analyses, 1);
  EXPECT_GT(lost, 0);
}

TEST(SolidHeat, the_error_falls_with_the_square_of_the_step) {
  const CoolingCube exact;
  const Block cube = block(2, 2, 2, [](const Vector3& x) -> Vector3 { return CoolingCube::length * x; });
  const auto mass = masses(cube.mesh, core::hexahedron_table(), plain);
  SolidProblem problem = exact.problem(cube, mass);
  for (auto& exchange : problem.bodies[0].exchange)
    if (exchange) exchange->emissivity = 0.9;  // not linear
  const auto start = sample(cube.mesh.nodes, [&](const Vector3& x) { return exact(x, 2.0); });
  const auto after = [&](int steps) {
    SolidStepMatrix matrix;
    std::vector<Eigen::VectorXd> temperature{start};
    for (int i = 0; i < steps; ++i)
      temperature = advance(problem, i * 8.0 / steps, temperature, 8.0 / steps, one_step(), matrix).temperature;
    return temperature[0];
  };
  const Eigen::VectorXd fine = after(256);
  const double coarse = (after(4) - fine).norm(), half = (after(8) - fine).norm();
  tests::expect_at_least("order in time of heat in space", std::log2(coarse / half), 1.8);
}

}  // namespace
}  // namespace parison::thermal::test
