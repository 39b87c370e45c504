// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/mesh/element.hpp"
#include "figure.hpp"
#include "thermal/radiation/fresnel.hpp"
#include "thermal/radiation/light_laws.hpp"
#include "thermal/radiation/planck.hpp"

namespace parison::thermal::test {
namespace {

/// Planck's law integrated over x = hc/(wavelength k T) from `low` to infinity, over the whole.
double integrated_fraction(double low) {
  double sum = 0;
  constexpr int panels = 4000;
  const double high = std::max(60.0, low + 60);
  for (int i = 0; i < panels; ++i)
    for (const auto& at : core::edge_rule(5)) {
      const double x = low + (high - low) * (i + at.s) / panels;
      sum += at.weight * (high - low) / panels * x * x * x / std::expm1(x);
    }
  return 15 / std::pow(M_PI, 4) * sum;
}

TEST(Planck, the_fraction_below_a_wavelength_is_the_integral_of_Planck_s_law) {
  tests::Figure off(
      "fraction of a black body's emission below a wavelength, against the integral of Planck's law: off by");
  for (double product = 0.3e-3; product < 1; product *= 1.3)
    off.add(std::abs(planck_fraction(product) - integrated_fraction(1.438776877e-2 / product)));
  off.at_most(1e-10);
  EXPECT_EQ(planck_fraction(0), 0);
  EXPECT_NEAR(planck_fraction(1e3), 1, 1e-9);
  // Tables of radiation functions, at 2000 and 4000 um K.
  EXPECT_NEAR(planck_fraction(2000e-6), 0.06673, 3e-5);
  EXPECT_NEAR(planck_fraction(4000e-6), 0.48087, 3e-5);
}

TEST(Planck, the_bands_of_a_spectrum_sum_up_to_the_whole) {
  const double edges[] = {0, 0.5e-6, 2.75e-6, 4.3e-6, 50e-6, std::numeric_limits<double>::infinity()};
  for (const double T : {200.0, 700.0, 1373.15, 2400.0, 5000.0}) {
    double sum = 0;
    for (int i = 0; i < 5; ++i) sum += emission_between(edges[i], edges[i + 1], T).value;
    EXPECT_NEAR(sum / (stefan_boltzmann * std::pow(T, 4)), 1, 1e-12);
  }
}

TEST(Planck, the_prepared_band_follows_the_series_and_its_derivative_is_its_own) {
  tests::Figure off("emission of a band prepared for many evaluations, over that of the spectrum: off by");
  for (const auto& [from, to] : {std::pair(0.0, 2.75e-6), {2.75e-6, 4.3e-6}, {4.3e-6, 1e300}}) {
    const BandEmission prepared(from, to);
    for (double T = 251; T < 3400; T += 17.3) {
      const Emission exact = emission_between(from, to, T), at = prepared(T);
      off.add(std::abs(at.value - exact.value) / (stefan_boltzmann * std::pow(T, 4)));
      const double slope = (prepared.value(T + 1e-3) - prepared.value(T - 1e-3)) / 2e-3;
      EXPECT_NEAR(at.derivative / slope, 1, 1e-6) << T;
      EXPECT_NEAR(emission_between(from, to, T + 0.05).value - emission_between(from, to, T - 0.05).value,
                  0.1 * exact.derivative, 1e-6 * exact.derivative);
    }
    EXPECT_EQ(prepared.value(-900), -prepared.value(900));
  }
  off.at_most(1e-8);
}

TEST(Fresnel, the_reflectivity_has_its_exact_values) {
  for (const double n : {1.2, 1.518, 2.0}) {
    EXPECT_NEAR(fresnel_reflectivity(n, 1), std::pow((n - 1) / (n + 1), 2), 1e-15);
    EXPECT_EQ(fresnel_reflectivity(n, critical_cosine(n) * (1 - 1e-12)), 1);
    EXPECT_EQ(fresnel_reflectivity(n, 0), 1);
    // At Brewster's angle light polarised in the plane of incidence is not reflected.
    const double brewster = n / std::sqrt(1 + n * n), across = (n * n - 1) / (n * n + 1);
    EXPECT_NEAR(fresnel_reflectivity(n, brewster), 0.5 * across * across, 1e-14);
  }
  EXPECT_NEAR(fresnel_reflectivity(1, 0.3), 0, 1e-15);
  EXPECT_EQ(critical_cosine(1), 0);
}

/// Reflectivity for diffuse light from outside, in closed form (J. W. T. Walsh 1926).
double walsh(double n) {
  const double s = n * n, l = std::log((n - 1) / (n + 1));
  return 0.5 + (3 * n + 1) * (n - 1) / (6 * (n + 1) * (n + 1)) + s * std::pow(s - 1, 2) / std::pow(s + 1, 3) * l -
         2 * n * s * (s + 2 * n - 1) / ((s + 1) * (s * s - 1)) +
         8 * s * s * (s * s + 1) / ((s + 1) * std::pow(s * s - 1, 2)) * std::log(n);
}

TEST(Fresnel, the_hemispherical_emissivity_is_that_of_the_closed_form) {
  tests::Figure off("hemispherical emissivity of an opaque surface of index 1.1 to 3, against the closed form: off by");
  for (const double n : {1.1, 1.3, 1.518, 2.0, 3.0}) off.add(std::abs(surface_emissivity(n) - (1 - walsh(n))));
  off.at_most(1e-9);
  EXPECT_NEAR(surface_emissivity(1), 1, 1e-14);
}

TEST(Fresnel, the_moments_converge_to_no_and_to_all_reflection) {
  EXPECT_NEAR(reflectivity_moments(1).first, 0, 1e-15);
  EXPECT_NEAR(reflectivity_moments(1).second, 0, 1e-15);
  EXPECT_NEAR(reflectivity_moments(1e4).first, 0.5, 1e-3);
  EXPECT_NEAR(reflectivity_moments(1e4).second, 1.0 / 3, 1e-3);
}

using Model = Radiation::Model;

TEST(LightLaws, light_goes_to_a_black_tool_as_to_the_surroundings_and_not_at_all_to_a_mirror) {
  for (const Model model : {Model::p1, Model::p1_cones}) {
    const LightLaws laws({1.518, 0, false, model, {{2.75e-6, 30}}});
    const int leaving = laws.group_count() - 1;
    EXPECT_DOUBLE_EQ(laws.to_tool(leaving, 1), laws.group(leaving).open);
    EXPECT_EQ(laws.to_tool(leaving, 0), 0);
    EXPECT_LT(laws.to_tool(leaving, 0.3), laws.to_tool(leaving, 0.8));
    EXPECT_LT(laws.to_tool(leaving, 0.8), laws.group(leaving).open);
    EXPECT_LT(laws.group(leaving).open, laws.group(leaving).black);
  }
  const LightLaws clear({1, 0, false, Model::p1, {{2.75e-6, 30}}});
  EXPECT_DOUBLE_EQ(clear.group(0).open, 0.5);
  EXPECT_DOUBLE_EQ(clear.group(0).black, 0.5);
  EXPECT_DOUBLE_EQ(grey_exchange(0.8, 0.5), 1 / (1.25 + 2 - 1));
  EXPECT_EQ(grey_exchange(0.8, 0), 0);
}

TEST(LightLaws, the_cones_share_all_directions_and_only_light_that_is_not_totally_reflected_leaves) {
  const LightLaws laws({1.518, 0, false, Model::p1_cones, {{2.75e-6, 30}, {4.3e-6, 450}}});
  ASSERT_EQ(laws.group_count(), 4);
  for (const int band : {0, 1}) {
    const LightGroup &kept = laws.group(2 * band), &leaving = laws.group(2 * band + 1);
    EXPECT_EQ(kept.band, band);
    EXPECT_DOUBLE_EQ(kept.share + leaving.share, 1);
    EXPECT_DOUBLE_EQ(kept.share * kept.diffusion + leaving.share * leaving.diffusion, 1 / (3 * kept.absorption));
    EXPECT_EQ(kept.open, 0);
    EXPECT_EQ(laws.to_tool(2 * band, 0.8), 0);
    EXPECT_GT(leaving.open, 0);
    // Thick glass of one temperature emits as an opaque surface does; the layer's own resistance is sqrt(d/kappa).
    const double inside = std::sqrt(leaving.diffusion * leaving.absorption);
    EXPECT_NEAR(4 * 1.518 * 1.518 * leaving.share / (1 / leaving.open + 1 / inside), surface_emissivity(1.518), 0.01);
  }
  EXPECT_EQ(LightLaws({1, 0, false, Model::p1_cones, {{2.75e-6, 30}}}).group_count(), 1);
}

}  // namespace
}  // namespace parison::thermal::test
