// SPDX-License-Identifier: GPL-3.0-or-later
// The wall bent to a tube: its emission to both sides by P1, with and without cones, against the radiative transfer
// equation along its rays.
#include <gtest/gtest.h>

#include <limits>

#include "figure.hpp"
#include "thermal/bodies.hpp"
#include "thermal/system.hpp"

namespace parison::thermal::test {
namespace {

using Model = Radiation::Model;

constexpr double wall = 0.003, hot = 1300, index_of_glass = 1.518;  ///< m, K

/// Light out of both faces of an isothermal tube in cold surroundings, which its inner face sees too, over that of
/// black ones.
double emissivity(Model model, double inner_radius, double absorption) {
  const Material material{
      2400, core::constant(1300), core::constant(1.3),
      Radiation{index_of_glass, 0, false, model, {{std::numeric_limits<double>::infinity(), absorption}}}};
  const double outer_radius = inner_radius + wall, height = wall / 40;
  const core::Mesh mesh = rectangle(divide(inner_radius, outer_radius, 40), {0, height});
  Problem problem{core::Geometry::axisymmetric, {body(mesh, material)}, {}, {}};
  problem.bodies[0].light.surroundings.resize(4);
  problem.bodies[0].light.surroundings[right] = problem.bodies[0].light.surroundings[left] = core::TimeFunction(0);
  const HeatSystem system = make_heat_system(problem);
  const Flows flows = evaluate_flows(system, 0, Eigen::VectorXd::Constant(system.size(), hot));
  return flows.to_air[0] / (2 * M_PI * (inner_radius + outer_radius) * height * stefan_boltzmann * std::pow(hot, 4));
}

/// The share of a black body's intensity that leaves at the end of a path between two reflections: `here` and `there`
/// are the reflectivities at its ends, `passed` its transmission.
double leaving(double here, double there, double passed) {
  const double from_there = there * (1 - passed) * (1 + passed * here) / (1 - here * there * passed * passed);
  return (1 - here) * (from_there * passed + 1 - passed);
}

/// Light that leaves a face of a radius at an angle b to the axis and p to the normal in the plane across it, for the
/// intensity of a black body 1.
double leaving_at(double radius, double b, double p, double inner, double outer, double absorption) {
  const double offset = radius * std::sin(p), far = std::sqrt(outer * outer - offset * offset);
  const double at_outer = fresnel_reflectivity(index_of_glass, std::sin(b) * far / outer);
  if (offset > inner) return leaving(at_outer, at_outer, std::exp(-absorption * 2 * far / std::sin(b)));
  const double near = std::sqrt(std::max(0.0, inner * inner - offset * offset));
  const double at_inner = fresnel_reflectivity(index_of_glass, std::sin(b) * near / inner);
  const double passed = std::exp(-absorption * (far - near) / std::sin(b));
  return radius == outer ? leaving(at_outer, at_inner, passed) : leaving(at_inner, at_outer, passed);
}

/// n^2 times the mean of that over the surfaces and the directions.
double exact(double inner, double absorption) {
  const double outer = inner + wall;
  constexpr int parts = 600;
  double sum = 0;
  for (const double radius : {inner, outer})
    for (int i = 0; i < parts; ++i)
      for (int j = 0; j < parts; ++j) {
        const double p = M_PI / 2 * (i + 0.5) / parts, b = M_PI / 2 * (j + 0.5) / parts;
        sum += radius * std::pow(std::sin(b), 2) * std::cos(p) * leaving_at(radius, b, p, inner, outer, absorption);
      }
  return index_of_glass * index_of_glass * sum * 4 / M_PI * std::pow(M_PI / 2 / parts, 2) / (inner + outer);
}

TEST(P1Tube, a_wide_tube_emits_as_the_slab_does) {
  // Isothermal slabs of optical thickness 0.45 and 1.2, n = 1.518.
  EXPECT_NEAR(exact(3, 0.45 / wall), 0.38154, 1e-3);
  EXPECT_NEAR(exact(3, 1.2 / wall), 0.68595, 1e-3);
  EXPECT_NEAR(exact(0.03, 1e6), surface_emissivity(index_of_glass), 1e-3);
}

TEST(P1Tube, the_error_of_the_approximation_in_bent_walls_is_printed) {
  for (const double inner : {0.003, 0.03})
    for (const Model model : {Model::p1, Model::p1_cones}) {
      const char* how = model == Model::p1 ? "P1" : "P1 in cones";
      tests::Figure off(
          fmt::format("{}: emission of an isothermal tube of glass, wall 3 mm, inner radius {} mm, optical "
                      "thickness 0.09 to 2.1, against radiative transfer: off by",
                      how, 1e3 * inner),
          "%");
      for (const double absorption : {30.0, 150.0, 450.0, 700.0}) {
        const double found = emissivity(model, inner, absorption), transfer = exact(inner, absorption);
        off.add(100 * std::abs(found / transfer - 1));
        std::printf("%s, inner radius %g mm, %g 1/m: %.4f, exact %.4f\n", how, 1e3 * inner, absorption, found,
                    transfer);
      }
      off.for_comparison();
    }
}

}  // namespace
}  // namespace parison::thermal::test
