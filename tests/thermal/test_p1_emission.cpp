// SPDX-License-Identifier: GPL-3.0-or-later
// Emission of isothermal slabs, cylinders and spheres by P1, with and without cones, against the radiative transfer
// equation, whose solution is an integral over the chords.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "figure.hpp"
#include "thermal/bodies.hpp"
#include "thermal/system.hpp"

namespace parison::thermal::test {
namespace {

using core::Geometry;
using Model = Radiation::Model;

constexpr double size = 0.01, hot = 1300;  ///< m, K: thickness or diameter; temperature
enum class Shape { slab, cylinder, sphere };
constexpr const char* name_of(Shape shape) {
  return shape == Shape::slab ? "slabs" : shape == Shape::cylinder ? "cylinders" : "spheres";
}

/// A body whose right and, of the sphere, top sides are its surface.
core::Mesh mesh_of(Shape shape, int cells) {
  if (shape == Shape::slab) return rectangle(divide(0, size, cells), {0, size / cells});
  if (shape == Shape::cylinder) return rectangle(divide(0, size / 2, cells), {0, size / cells});
  core::Mesh mesh = rectangle(divide(0, 1, cells), divide(0, 1, cells));
  for (Point& x : mesh.nodes)
    x = 0.5 * size * Point(x[0] * std::sqrt(1 - x[1] * x[1] / 2), x[1] * std::sqrt(1 - x[0] * x[0] / 2));
  return mesh;
}

double surface_of(Shape shape, int cells) {
  return shape == Shape::slab       ? 2 * size / cells
         : shape == Shape::cylinder ? M_PI * size * size / cells
                                    : M_PI * size * size / 2;
}

/// Light out of an isothermal body in cold surroundings over that of a black surface; its optical size is that of its
/// thickness or diameter.
double emissivity(Shape shape, Model model, double optical, double index, int cells) {
  const Material material{
      2400, core::constant(1300), core::constant(1.3),
      Radiation{index, 0, false, model, {{std::numeric_limits<double>::infinity(), optical / size}}}};
  const core::Mesh mesh = mesh_of(shape, cells);
  Problem problem{shape == Shape::slab ? Geometry::planar : Geometry::axisymmetric, {body(mesh, material)}, {}, {}};
  auto& surroundings = problem.bodies[0].light.surroundings;
  surroundings.resize(4);
  surroundings[right] = core::TimeFunction(0);
  if (shape == Shape::slab) surroundings[left] = core::TimeFunction(0);
  if (shape == Shape::sphere) surroundings[top] = core::TimeFunction(0);
  const HeatSystem system = make_heat_system(problem);
  const Flows flows = evaluate_flows(system, 0, Eigen::VectorXd::Constant(system.size(), hot));
  return flows.to_air[0] / (surface_of(shape, cells) * stefan_boltzmann * std::pow(hot, 4));
}

/// int_0^1 f, f smooth over s^2 from `start` on and zero below.
double integrate(const std::function<double(double)>& f, double start) {
  constexpr int panels = 300;
  double sum = 0;
  for (int i = 0; i < panels; ++i)
    for (const auto& at : core::edge_rule(5)) {
      const double s = (i + at.s) / panels;
      sum += at.weight / panels * 2 * (1 - start) * s * f(start + (1 - start) * s * s);
    }
  return sum;
}

/// n^2 times the mean over the directions of (1 - R)(1 - e)/(1 - R e), e the transmission of the chord, on which a ray
/// meets the surface at the same angle again and again.
double exact(Shape shape, double optical, double index) {
  const double critical = critical_cosine(index);
  const auto leaving = [&](double mu, double chord) {
    const double R = fresnel_reflectivity(index, mu), passed = std::exp(-optical * chord);
    return (1 - R) * (1 - passed) / (1 - R * passed);
  };
  if (shape == Shape::slab)
    return 2 * index * index * integrate([&](double mu) { return mu * leaving(mu, 1 / mu); }, critical);
  if (shape == Shape::sphere)
    return 2 * index * index * integrate([&](double mu) { return mu * leaving(mu, mu); }, critical);
  // mu = sin b cos p, b from the axis, p from the normal in the plane across it; the chord is cos p/sin b. For each
  // mu the angle b runs from where sin b = mu.
  return 2 * index * index *
         integrate(
             [&](double mu) {
               constexpr int parts = 200;
               double sum = 0;
               for (int i = 0; i < parts; ++i) {
                 // Azimuth around the normal: sin^2 b = 1 - (1 - mu^2) cos^2 a.
                 const double a = M_PI / 2 * (i + 0.5) / parts;
                 const double square = 1 - (1 - mu * mu) * std::pow(std::cos(a), 2);
                 sum += leaving(mu, mu / square) / parts;
               }
               return mu * sum;
             },
             critical);
}

TEST(P1Emission, the_reference_has_the_known_values) {
  EXPECT_NEAR(exact(Shape::slab, 0.1, 1.518), 0.10612, 1e-5);
  EXPECT_NEAR(exact(Shape::slab, 0.45, 1.518), 0.38154, 1e-5);
  EXPECT_NEAR(exact(Shape::slab, 5, 1.518), 0.90236, 1e-5);
  for (const double d : {0.1, 1.0, 10.0}) {
    EXPECT_NEAR(exact(Shape::sphere, d, 1), 1 - 2 / (d * d) * (1 - (1 + d) * std::exp(-d)), 1e-7);
    EXPECT_LT(exact(Shape::sphere, d, 1), exact(Shape::cylinder, d, 1));
    EXPECT_LT(exact(Shape::cylinder, d, 1), exact(Shape::slab, d, 1));
  }
  // Thin bodies emit from their whole volume: 4 kappa V/A is d for a cylinder.
  EXPECT_NEAR(exact(Shape::cylinder, 1e-4, 1) / 1e-4, 1, 1e-3);
}

/// Records by how much the emission of bodies of several optical sizes is off, the largest.
void compare(Shape shape, Model model, double index, std::optional<double> bound) {
  const char* how = model == Model::p1 ? "P1" : "P1 in cones";
  tests::Figure off(fmt::format("{}: emission of isothermal {} of optical size 0.1 to 5, n = {}, against radiative "
                                "transfer: off by",
                                how, name_of(shape), index),
                    "%");
  for (const double optical : {0.1, 0.45, 1.2, 5.0}) {
    const double found = emissivity(shape, model, optical, index, shape == Shape::sphere ? 16 : 40),
                 transfer = exact(shape, optical, index);
    off.add(100 * std::abs(found / transfer - 1));
    std::printf("%s, n = %g, %s of optical size %g: %.5f, exact %.5f\n", how, index, name_of(shape), optical, found,
                transfer);
  }
  if (bound)
    off.at_most(*bound);
  else
    off.for_comparison();
}

TEST(P1Emission, cones_make_glass_slabs_emit_as_they_do_within_two_percent) {
  compare(Shape::slab, Model::p1_cones, 1.518, 2);
}

TEST(P1Emission, the_error_of_the_approximation_in_other_shapes_is_printed) {
  for (const Shape shape : {Shape::slab, Shape::cylinder, Shape::sphere})
    for (const double index : {1.0, 1.518}) {
      compare(shape, Model::p1, index, {});
      if (index > 1 && shape != Shape::slab) compare(shape, Model::p1_cones, index, {});
    }
}

/// The same of the equations of P1 without a mesh.
double exact_in_p1(Model model, double optical, double index) {
  const LightLaws laws({index, 0, false, model, {{std::numeric_limits<double>::infinity(), 1}}});
  double sum = 0;
  for (int g = 0; g < laws.group_count(); ++g) {
    const LightGroup& group = laws.group(g);
    const double slope = std::sqrt(group.diffusion) * std::tanh(optical / 2 / std::sqrt(group.diffusion));
    sum += 4 * index * index * group.share * group.open * slope / (group.open + slope);
  }
  return sum;
}

TEST(P1Emission, a_slab_emits_as_the_equations_say) {
  tests::Figure off("P1, with and without cones: emission of isothermal slabs against its exact solution: off by", "%");
  for (const Model model : {Model::p1, Model::p1_cones})
    for (const double optical : {0.1, 0.45, 1.2, 5.0})
      off.add(100 *
              std::abs(emissivity(Shape::slab, model, optical, 1.518, 40) / exact_in_p1(model, optical, 1.518) - 1));
  off.at_most(0.01);
  const auto error = [](int cells) {
    return std::abs(emissivity(Shape::slab, Model::p1, 5, 1.518, cells) / exact_in_p1(Model::p1, 5, 1.518) - 1);
  };
  tests::expect_at_least("the same: order in space", std::log2(error(4) / error(8)), 3.5);
}

TEST(P1Emission, a_finer_mesh_changes_the_emission_of_a_sphere_by_less_than_a_thousandth) {
  for (const Model model : {Model::p1, Model::p1_cones}) {
    const double coarse = emissivity(Shape::sphere, model, 1.2, 1.518, 8);
    EXPECT_NEAR(emissivity(Shape::sphere, model, 1.2, 1.518, 16) / coarse, 1, 1e-3);
  }
}

}  // namespace
}  // namespace parison::thermal::test
