// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "forming/flow/material.hpp"

namespace parison::flow {
namespace {

const Viscosity soda_lime{-2.309, 3922, 564.15, {}};

TEST(Viscosity, follows_the_vft_law_and_falls_with_temperature) {
  EXPECT_NEAR(std::log10(soda_lime(1273.15)), -2.309 + 3922 / (1273.15 - 564.15), 1e-13);
  for (double T = 850; T < 1700; T += 25) EXPECT_LT(soda_lime(T + 25), soda_lime(T));
}

TEST(Viscosity, is_limited_to_1e12_also_where_the_law_has_no_value) {
  for (const double T : {300.0, 564.15, 564.16, 800.0}) {
    EXPECT_NEAR(soda_lime(T) / 1e12, 1, 1e-13);
    EXPECT_EQ(soda_lime.log_derivative(T), 0);
  }
}

TEST(Viscosity, of_the_flow_is_that_of_the_law_up_to_the_shear_modulus_times_a_second) {
  const Viscosity constant{0, 0, 0, 1e15};
  for (double T = 600; T < 1700; T += 20) {
    EXPECT_EQ(soda_lime.in_flow(T), std::min(soda_lime(T), 3e10));
    const Eigen::ArrayXd at = Eigen::ArrayXd::Constant(1, T);
    EXPECT_NEAR(std::exp(soda_lime.logarithm_in_flow(at)[0]) / soda_lime.in_flow(T), 1, 1e-13);
    EXPECT_EQ(constant.in_flow(T), constant(T));
    EXPECT_EQ(soda_lime.is_softened(T), soda_lime.in_flow(T) < soda_lime(T));
    EXPECT_FALSE(constant.is_softened(T));
  }
}

TEST(Viscosity, derivatives_agree_with_finite_differences_and_are_not_zero) {
  for (const double T : {850.0, 1000.0, 1250.0, 1500.0}) {
    const double step = 1e-3;
    const double by_difference = (soda_lime(T + step) - soda_lime(T - step)) / (2 * step);
    EXPECT_LT(soda_lime.derivative(T), 0);
    EXPECT_NEAR(soda_lime.derivative(T) / by_difference, 1, 1e-7);
    EXPECT_NEAR(soda_lime.log_derivative(T) * soda_lime(T) / by_difference, 1, 1e-7);
  }
}

TEST(Viscosity, of_an_array_has_the_bits_of_each_temperature) {
  const Eigen::ArrayXd T = Eigen::ArrayXd::LinSpaced(37, 500, 1600);
  for (const Viscosity& law : {soda_lime, Viscosity{0, 0, 0, 1e4}}) {
    const Eigen::ArrayXd logarithm = law.logarithm(T), derivative = law.log_derivative(T);
    for (Eigen::Index i = 0; i < T.size(); ++i) {
      const Eigen::ArrayXd alone = law.logarithm(T.segment(i, 1));
      EXPECT_EQ(logarithm[i], alone[0]);
      EXPECT_NEAR(law(T[i]) / std::exp(logarithm[i]), 1, 1e-14);
      EXPECT_EQ(derivative[i], law.log_derivative(T[i]));
    }
  }
}

TEST(Viscosity, a_constant_is_the_same_at_every_temperature) {
  const Viscosity constant{0, 0, 0, 1e4};
  for (const double T : {-10.0, 300.0, 1500.0}) {
    EXPECT_EQ(constant(T), 1e4);
    EXPECT_EQ(constant.derivative(T), 0);
  }
}

TEST(Carreau, is_one_at_rest_and_a_power_of_the_rate_at_high_rates) {
  const Carreau law{0.01, 0.4};
  EXPECT_EQ(law(0), 1);
  EXPECT_NEAR(law(1e16) / std::pow(0.01 * 1e8, 0.4 - 1), 1, 1e-11);
  EXPECT_NEAR(law(3e4), std::pow(1 + 1e-4 * 3e4, -0.3), 1e-15);
}

TEST(Carreau, the_derivative_agrees_with_finite_differences_and_is_not_zero) {
  const Carreau law{0.01, 0.4};
  for (const double squared_rate : {1.0, 1e4, 1e6}) {
    const double step = 1e-4 * squared_rate;
    const double by_difference = (std::log(law(squared_rate + step)) - std::log(law(squared_rate - step))) / (2 * step);
    EXPECT_LT(law.log_derivative(squared_rate), 0);
    EXPECT_NEAR(law.log_derivative(squared_rate) / by_difference, 1, 1e-7);
  }
}

}  // namespace
}  // namespace parison::flow
