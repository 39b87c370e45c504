// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "contact/conductance/conductance.hpp"
#include "figure.hpp"

namespace parison::contact {
namespace {

/// The constants of the README.
const GapConductance published{2.5e-7, 4e-5, 0.25, 1, 0.9, 0};

/// The equation of the gap by the classical Runge-Kutta method.
double integrated(const GapConductance& law, double gap, double pressure, double viscosity, double time, int steps) {
  const auto rate = [&](double g) {
    return (law.open_gap - g) / law.opening_time - law.closing * pressure / viscosity * (g - law.touch_gap);
  };
  const double dt = time / steps;
  for (int i = 0; i < steps; ++i) {
    const double a = rate(gap), b = rate(gap + 0.5 * dt * a), c = rate(gap + 0.5 * dt * b), d = rate(gap + dt * c);
    gap += dt / 6 * (a + 2 * b + 2 * c + d);
  }
  return gap;
}

TEST(GapConductance, the_opening_follows_its_equation_whatever_the_length_of_a_step) {
  tests::Figure figure("gap of a contact against its equation by a Runge-Kutta method, relative");
  for (const double pressure : {0.0, 1e5, 7e5})
    for (const double viscosity : {1e3, 1e5, 1e8})
      for (const double time : {1e-3, 0.05, 1.0, 3.0}) {
        const double rate = published.closing_rate(pressure, viscosity);
        const double exact = integrated(published, published.touch_gap, pressure, viscosity, time, 20000);
        const double once = published.touch_gap + published.opening_after(0, rate, time);
        figure.add(std::abs(once / exact - 1));
        double in_parts = 0;
        for (const double part : {0.1, 0.6, 0.3}) in_parts = published.opening_after(in_parts, rate, part * time);
        EXPECT_NEAR(in_parts, once - published.touch_gap, 1e-12 * once);
      }
  figure.at_most(1e-9);
}

TEST(GapConductance, passes_through_the_published_gaps_and_conductances) {
  const auto gap = [](double age) { return published.touch_gap + published.opening_after(0, 0, age); };
  const auto h = [](double age) { return published.at_opening(published.opening_after(0, 0, age), 1000.0, 750.0); };
  EXPECT_DOUBLE_EQ(gap(0), 2.5e-7);
  tests::expect_at_most("gap a second after first touch against 40 um, relative", std::abs(gap(1) / 4e-5 - 1), 0.02);
  for (const double age : {0.0, 0.001, 0.003, 0.01}) {
    EXPECT_GE(h(age), 1e4) << age;
    EXPECT_LE(h(age), 6e4) << age;
  }
  for (const double age : {0.1, 0.2, 0.3}) {
    EXPECT_GE(h(age), 2e3) << age;
    EXPECT_LE(h(age), 5e3) << age;
  }
  tests::expect_at_most("conductance of a contact of three seconds against 1600 W/m2/K, relative",
                        std::abs(h(3) / 1600 - 1), 0.1);
}

TEST(GapConductance, pressure_and_softness_close_the_gap_and_age_opens_it) {
  const auto opening = [](double pressure, double viscosity, double age) {
    return published.opening_after(0, published.closing_rate(pressure, viscosity), age);
  };
  EXPECT_LT(opening(2e5, 1e5, 0.2), opening(1e5, 1e5, 0.2));
  EXPECT_LT(opening(1e5, 1e4, 0.2), opening(1e5, 1e5, 0.2));
  EXPECT_LT(opening(1e5, 1e5, 0.1), opening(1e5, 1e5, 0.2));
  EXPECT_NEAR(opening(1e5, 1e5, 100), 3.975e-5 / (1 + 0.25), 1e-15) << "opening and closing in balance";
  const double wide = opening(0, 1e5, 1);
  EXPECT_LT(published.opening_after(wide, published.closing_rate(1e6, 1e3), 0.01), 1e-2 * wide) << "pressed shut again";
  EXPECT_GT(conductance(published, 1e6, 1e4).h, 2 * conductance(published, 1e4, 1e6).h);
}

TEST(GapConductance, derivative_agrees_with_finite_differences_and_is_not_zero) {
  GapConductance law = published;
  for (const double emissivity : {0.0, 0.72}) {
    law.exchange_emissivity = emissivity;
    for (const double opening : {0.0, 1e-6, 3e-5})
      for (const double glass : {700.0, 1000.0, 1400.0}) {
        const auto at = law.at_opening(opening, core::Dual<double>{glass, 1}, core::Dual<double>{750, 0});
        const double by =
            (law.at_opening(opening, glass + 0.1, 750.0) - law.at_opening(opening, glass - 0.1, 750.0)) / 0.2;
        EXPECT_GT(std::abs(by), 1e-3);
        EXPECT_NEAR(at.derivative, by, 1e-6 * std::abs(by));
      }
  }
}

TEST(GapConductance, air_conducts_as_tables_say_and_radiation_is_that_of_grey_planes) {
  // Incropera and DeWitt, Fundamentals of Heat and Mass Transfer, table A.4.
  for (const auto& [temperature, tabulated] : {std::pair{300.0, 0.0263}, {600.0, 0.0469}, {1000.0, 0.0667}})
    EXPECT_NEAR(air_conductivity(temperature) / tabulated, 1, 0.02) << temperature;
  EXPECT_NEAR(air_free_path(293.15) / 6.543e-8, 1, 0.01) << "S. G. Jennings, J. Aerosol Sci. 19 (1988) 159-166";
  GapConductance law = published;
  law.exchange_emissivity = 1 / (1 / 0.89 + 1 / 0.8 - 1);
  const double more = law.at_opening(1e-5, 1100.0, 700.0) - published.at_opening(1e-5, 1100.0, 700.0);
  EXPECT_NEAR(more * 400, law.exchange_emissivity * 5.670374419e-8 * (std::pow(1100, 4) - std::pow(700, 4)), 1e-6);
}

}  // namespace
}  // namespace parison::contact
