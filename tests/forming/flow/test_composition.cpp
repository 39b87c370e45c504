// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "forming/flow/viscosity/composition.hpp"

namespace parison::flow {
namespace {

constexpr double zero_celsius = 273.15;

/// A glass of Lakatos, Johansson and Simmingskoeld 1976 by mass, %, and the temperatures, degC, at which it has 10, 1e3
/// and 1e5 Pa.s by the model as the paper prints them.
struct PublishedGlass {
  const char* name;
  Composition percent;
  std::array<double, 3> temperature;
};

const std::vector<PublishedGlass> published{
    {"S1", {{"SiO2", 77.02}, {"Al2O3", 0.19}, {"Na2O", 12.03}, {"K2O", 0.13}, {"CaO", 10.12}}, {1503.7, 1054.3, 843.3}},
    {"S7",
     {{"SiO2", 71.41}, {"Al2O3", 2.21}, {"Na2O", 12.44}, {"K2O", 2.6}, {"CaO", 10.1}, {"MgO", 0.77}},
     {1465.9, 1034.0, 829.9}},
    {"S28",
     {{"SiO2", 72.37}, {"Al2O3", 2.02}, {"Na2O", 12.87}, {"K2O", 0.08}, {"CaO", 11.12}, {"MgO", 0.65}},
     {1467.3, 1039.1, 837.6}},
    {"D17", {{"SiO2", 62.01}, {"Al2O3", 1.05}, {"Na2O", 12.15}, {"CaO", 10.42}, {"B2O3", 14.37}}, {1200, 905.3, 772.4}},
    {"F2-10",
     {{"SiO2", 73.3}, {"Al2O3", 1.65}, {"Na2O", 11.2}, {"K2O", 0.48}, {"Li2O", 3}, {"CaO", 10.3}},
     {1365.4, 939.2, 743.0}},
    {"FAL5", {{"SiO2", 68}, {"Al2O3", 6}, {"Na2O", 11}, {"K2O", 2}, {"CaO", 11}, {"MgO", 2}}, {1499.7, 1069.9, 864.3}}};

Composition shares(const Composition& percent) {
  Composition composition;
  for (const auto& [oxide, value] : percent) composition[oxide] = value / 100;
  return composition;
}

TEST(Composition, gives_the_temperatures_that_the_paper_prints_for_its_glasses) {
  for (const PublishedGlass& glass : published) {
    const auto T = isokom_temperatures(shares(glass.percent));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(T[i] - zero_celsius, glass.temperature[i], 1.6) << glass.name << i;
  }
}

TEST(Composition, law_goes_through_its_three_points) {
  for (const PublishedGlass& glass : published) {
    const auto T = isokom_temperatures(shares(glass.percent));
    const Viscosity law = viscosity_of(shares(glass.percent));
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(std::log10(law(T[i])), 1 + 2 * static_cast<double>(i), 1e-9) << glass.name;
  }
}

/// The standard glass I of the DGG, whose viscosity is known: log10 eta = -2.9224 + 4789.2/(T - 218.06), Fluegel 2007.
TEST(Composition, comes_within_16_K_of_the_standard_glass_of_the_DGG) {
  const Composition dgg =
      shares({{"SiO2", 71.72}, {"Al2O3", 1.23}, {"Na2O", 14.95}, {"K2O", 0.38}, {"CaO", 6.73}, {"MgO", 4.18}});
  const auto T = isokom_temperatures(dgg);
  const std::array<double, 3> slack{17, 2, 5};
  for (std::size_t i = 0; i < 3; ++i) {
    const double certified = 218.06 + 4789.2 / (1 + 2 * static_cast<double>(i) + 2.9224);
    EXPECT_NEAR(T[i] - zero_celsius, certified, slack[i]);
  }
}

TEST(Composition, soda_and_lithia_make_glass_softer_and_alumina_makes_it_stiffer) {
  const Composition glass = shares(published[1].percent);
  const auto with = [&](const char* oxide) {
    Composition changed = glass;
    changed[oxide] += 0.01;
    return viscosity_of(changed)(1273.15);
  };
  const double before = viscosity_of(glass)(1273.15);
  EXPECT_LT(with("Na2O"), before);
  EXPECT_LT(with("Li2O"), with("Na2O"));
  EXPECT_GT(with("Al2O3"), before);
}

TEST(ViscosityTable, goes_through_its_points_and_falls_between_and_beyond_them) {
  const std::vector<double> T{812, 994, 1200, 1574}, eta{1e12, 3.98e6, 2e3, 31.6};
  const ViscosityTable table(T, eta);
  for (std::size_t i = 0; i < T.size(); ++i) EXPECT_NEAR(table(T[i]).logarithm, std::log(eta[i]), 1e-12);
  for (double at = 700; at < 1800; at += 10) {
    EXPECT_LT(table(at + 10).logarithm, table(at).logarithm) << at;
    const double step = 1e-3, by_difference = (table(at + step).logarithm - table(at - step).logarithm) / (2 * step);
    EXPECT_LT(table(at).derivative, 0);
    EXPECT_NEAR(table(at).derivative / by_difference, 1, 1e-4) << at;
  }
}

TEST(ViscosityTable, of_points_on_a_vft_law_follows_it_to_three_percent) {
  const Viscosity law{-2.309, 3922, 564.15, {}};
  std::vector<double> T, eta;
  for (double at = 850; at <= 1650; at += 50) {
    T.push_back(at);
    eta.push_back(law(at));
  }
  Viscosity by_table;
  by_table.table.emplace(T, eta);
  for (double at = 910; at < 1600; at += 7) EXPECT_NEAR(by_table(at) / law(at), 1, 0.03) << at;
}

TEST(ViscosityTable, is_limited_like_a_law_and_has_the_same_bits_alone_and_in_an_array) {
  Viscosity viscosity;
  viscosity.table.emplace(std::vector<double>{900, 1500}, std::vector<double>{1e9, 1e2});
  EXPECT_NEAR(viscosity(500) / 1e12, 1, 1e-12);
  EXPECT_EQ(viscosity.log_derivative(500), 0);
  EXPECT_TRUE(viscosity.is_capped(500));
  EXPECT_FALSE(viscosity.is_capped(1000));
  const Eigen::ArrayXd T = Eigen::ArrayXd::LinSpaced(9, 500, 1600);
  for (Eigen::Index i = 0; i < T.size(); ++i) {
    EXPECT_EQ(viscosity.logarithm(T)[i], viscosity.logarithm(T.segment(i, 1))[0]);
    EXPECT_EQ(viscosity.log_derivative(T)[i], viscosity.log_derivative(T[i]));
  }
}

}  // namespace
}  // namespace parison::flow
