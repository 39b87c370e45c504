// SPDX-License-Identifier: GPL-3.0-or-later
// Emission of isothermal slabs, cylinders and spheres by P1, with and without cones, against the radiative transfer
// equation, whose solution is an integral over the chords.
#include <gtest/gtest.h>

#include "figure.hpp"
#include "thermal/radiation/exact_emission.hpp"

namespace parison::thermal::test {
namespace {

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
