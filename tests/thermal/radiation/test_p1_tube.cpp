// SPDX-License-Identifier: GPL-3.0-or-later
// The wall bent to a tube: its emission to both sides by P1, with and without cones, against the radiative transfer
// equation along its rays.
#include <gtest/gtest.h>

#include "figure.hpp"
#include "thermal/radiation/exact_tube.hpp"

namespace parison::thermal::test {
namespace {

TEST(P1Tube, a_wide_tube_emits_as_the_slab_does) {
  // Isothermal slabs of optical thickness 0.45 and 1.2, n = 1.518.
  EXPECT_NEAR(exact_tube(3, 0.45 / wall), 0.38154, 1e-3);
  EXPECT_NEAR(exact_tube(3, 1.2 / wall), 0.68595, 1e-3);
  EXPECT_NEAR(exact_tube(0.03, 1e6), surface_emissivity(index_of_glass), 1e-3);
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
        const double found = tube_emissivity(model, inner, absorption), transfer = exact_tube(inner, absorption);
        off.add(100 * std::abs(found / transfer - 1));
        std::printf("%s, inner radius %g mm, %g 1/m: %.4f, exact %.4f\n", how, 1e3 * inner, absorption, found,
                    transfer);
      }
      off.for_comparison();
    }
}

}  // namespace
}  // namespace parison::thermal::test
