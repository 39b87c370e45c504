// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "figure.hpp"
#include "thermal/bodies.hpp"
#include "thermal/radiation/camera/line_of_sight.hpp"
#include "thermal/radiation/fresnel.hpp"

namespace parison::thermal {
namespace {

using namespace test;
constexpr double pi = 3.14159265358979323846, everything = std::numeric_limits<double>::infinity();
constexpr CameraBand mid_infrared{3e-6, 5e-6};
constexpr double cold = 300;

double black(double temperature) {
  return emission_between(mid_infrared.from, mid_infrared.to, temperature).value / pi;
}

/// A slab from z = 0 to 10 mm, seen from above.
struct Slab {
  core::Mesh mesh = rectangle(divide(0, 1, 1), divide(0, 0.01, 20));

  double seen(const Optics& optics, const std::function<double(double)>& temperature, double sine = 0) const {
    const auto field = sample(mesh, [&](const Point& x) { return temperature(x[1]); });
    const LineOfSight view(mesh, core::Geometry::planar, field, optics, mid_infrared, cold);
    return view.radiance({{0.5, 0, 0.02}, {0, sine, -std::sqrt(1 - sine * sine)}});
  }
};

TEST(LineOfSight, an_isothermal_opaque_body_shows_its_temperature_times_its_emissivity) {
  tests::Figure error("camera: isothermal opaque body against emissivity times black body, relative");
  for (const double n : {1.0, 1.5, 1.9})
    for (const double sine : {0.0, 0.6, 0.95}) {
      const double R = fresnel_reflectivity(n, std::sqrt(1 - sine * sine / (n * n)));
      const double exact = (1 - R) * black(1000) + R * black(cold);
      error.add(std::abs(Slab().seen(
                             {n, {}}, [](double) { return 1000.0; }, sine) /
                             exact -
                         1));
    }
  error.at_most(1e-5);
}

/// Light towards `up` or down in glass that fills the slab between its surfaces, by a fine midpoint rule.
double emitted(double absorption, const std::function<double(double)>& temperature, bool up, double mu) {
  constexpr int parts = 20000;
  const double length = 0.01 / parts;
  double sum = 0;
  for (int i = 0; i < parts; ++i) {
    const double z = (i + 0.5) * length, way = (up ? 0.01 - z : z) / mu;
    sum += absorption * length / mu * std::exp(-absorption * way) * black(temperature(z));
  }
  return sum;
}

TEST(LineOfSight, a_slab_of_linear_temperature_shows_the_exact_integral_with_all_its_reflections) {
  const auto linear = [](double z) { return 800 + 4e4 * z; };
  tests::Figure error("camera: slab of linear temperature against the exact integral, relative");
  for (const double n : {1.0, 1.518})
    for (const double absorption : {10.0, 150.0, 1000.0})
      for (const double sine : {0.0, 0.7}) {
        const double mu = std::sqrt(1 - sine * sine / (n * n)), R = fresnel_reflectivity(n, mu);
        const double through = std::exp(-absorption * 0.01 / mu), all = 1 - R * R * through * through;
        const double up = emitted(absorption, linear, true, mu), down = emitted(absorption, linear, false, mu);
        const double outside = black(cold) * (R + (1 - R) * (1 - R) * through * (1 + R * through) / all);
        const double exact = (1 - R) * (up + R * through * down) / all + outside;
        error.add(std::abs(Slab().seen({n, {{everything, absorption}}}, linear, sine) / exact - 1));
      }
  error.at_most(2e-3);
}

TEST(LineOfSight, thin_glass_shows_its_optical_depth_and_thick_glass_its_surface) {
  const double depth = 1e-3;
  const auto even = [](double) { return 1100.0; };
  const double thin = Slab().seen({1.0, {{everything, depth / 0.01}}}, even) - black(cold);
  EXPECT_NEAR(thin / (depth * (black(1100) - black(cold))), 1, 1e-3);
  const auto linear = [](double z) { return 800 + 4e4 * z; };
  const double thick = Slab().seen({1.518, {{everything, 1e7}}}, linear), opaque = Slab().seen({1.518, {}}, linear);
  tests::expect_at_most("camera: optically thick slab against an opaque one, relative", std::abs(thick / opaque - 1),
                        1e-4);
}

TEST(LineOfSight, glass_as_warm_as_its_surroundings_cannot_be_seen_and_colder_glass_looks_darker) {
  const Optics optics{1.518, {{4e-6, 50}, {4.5e-6, 500}}};
  for (const double sine : {0.0, 0.5, 0.99})
    EXPECT_NEAR(Slab().seen(
                    optics, [](double) { return cold; }, sine) /
                    black(cold),
                1, 1e-12);
  EXPECT_LT(Slab().seen(optics, [](double) { return 280.0; }), black(cold));
  EXPECT_GT(Slab().seen(optics, [](double) { return 320.0; }), black(cold));
}

/// A tube from 20 to 25 mm radius, 100 mm high.
struct Tube {
  core::Mesh mesh = rectangle(divide(0.02, 0.025, 4), divide(0, 0.1, 10));

  LineOfSight view(const Optics& optics, double temperature) const {
    const Eigen::VectorXd field = Eigen::VectorXd::Constant(mesh.node_count(), temperature);
    return {mesh, core::Geometry::axisymmetric, field, optics, mid_infrared, cold};
  }
  static Ray line(double beside, double z = 0.05) { return {{1, beside, z}, {-1, 0, 0}}; }
};

TEST(LineOfSight, crosses_both_walls_of_a_tube) {
  const double absorption = 60;
  const Tube tube;
  const auto view = tube.view({1.0, {{everything, absorption}}}, 1200);
  tests::Figure error("camera: both walls of a tube without refraction against the exact chord, relative");
  for (const double beside : {0.0, 0.007, 0.0193, 0.022, 0.0245}) {
    const auto half = [&](double r) { return std::sqrt(std::max(0.0, r * r - beside * beside)); };
    const double passed = std::exp(-absorption * 2 * (half(0.025) - half(0.02)));
    error.add(std::abs(view.radiance(Tube::line(beside)) / ((1 - passed) * black(1200) + passed * black(cold)) - 1));
  }
  error.at_most(1e-4);
  EXPECT_FALSE(view.meets(Tube::line(0.0251)));
  EXPECT_TRUE(view.meets(Tube::line(0.0249)));
}

TEST(LineOfSight, refraction_and_reflection_keep_an_isothermal_enclosure_black) {
  const Tube tube;
  const auto view = tube.view({1.518, {{everything, 60}}}, cold);
  for (const double beside : {0.0, 0.01, 0.0195, 0.021, 0.0249})
    for (const double z : {0.01, 0.05})
      EXPECT_NEAR(view.radiance(Tube::line(beside, z)) / black(cold), 1, 1e-12) << beside;
  EXPECT_NEAR(view.apparent_temperature(black(1234.5)), 1234.5, 0.01);
}

}  // namespace
}  // namespace parison::thermal
