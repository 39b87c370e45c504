// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "contact/conductance/conductance.hpp"
#include "contact/conductance/interface_conductance.hpp"

namespace parison::contact {
namespace {

const TableConductance table{
    {1e4, 1e5, 1e6}, {1e2, 1e4, 1e6, 1e8}, {900, 700, 600, 500, 4000, 2500, 1500, 800, 20000, 12000, 6000, 2000}};

void expect_derivatives(const ConductanceLaw& law, double pressure, double viscosity) {
  const auto value = conductance(law, pressure, viscosity);
  const double dp = 1e-5 * pressure, de = 1e-5 * viscosity;
  const double by_p =
      (conductance(law, pressure + dp, viscosity).h - conductance(law, pressure - dp, viscosity).h) / (2 * dp);
  const double by_eta =
      (conductance(law, pressure, viscosity + de).h - conductance(law, pressure, viscosity - de).h) / (2 * de);
  EXPECT_GT(value.dh_dp, 0);
  EXPECT_LT(value.dh_deta, 0);
  EXPECT_NEAR(value.dh_dp, by_p, 1e-6 * by_p);
  EXPECT_NEAR(value.dh_deta, by_eta, -1e-6 * by_eta);
}

TEST(Conductance, derivatives_agree_with_finite_differences_and_are_not_zero) {
  for (const double p : {2e4, 1.3e5, 7e5})
    for (const double eta : {3e2, 5e3, 2e7}) {
      expect_derivatives(PressureViscosityConductance{}, p, eta);
      expect_derivatives(PressureViscosityConductance{300, 9000, 1e5, 1e4, 0.7, 0.4}, p, eta);
      expect_derivatives(table, p, eta);
    }
}

TEST(Conductance, a_constant_does_not_depend_on_pressure_or_viscosity) {
  for (const double p : {-1.0, 0.0, 1e6}) {
    const auto value = conductance(ConstantConductance{5000}, p, 1e3);
    EXPECT_EQ(value.h, 5000);
    EXPECT_EQ(value.dh_dp, 0);
    EXPECT_EQ(value.dh_deta, 0);
  }
}

TEST(Conductance, the_pressure_law_runs_from_h0_without_pressure_to_h1_under_any) {
  const PressureViscosityConductance law;
  EXPECT_EQ(conductance(law, 0, 1e3).h, law.h0);
  EXPECT_EQ(conductance(law, -1e5, 1e3).h, law.h0);
  EXPECT_NEAR(conductance(law, 1e-3, 1e3).h, law.h0, 1e-3);
  EXPECT_NEAR(conductance(law, 1e15, 1e3).h, law.h1, 1e-4);
  EXPECT_EQ(conductance(law, 1e300, 1e-300).h, law.h1);
  EXPECT_DOUBLE_EQ(conductance(law, law.p_ref, law.eta_ref).h, 0.5 * (law.h0 + law.h1));
}

TEST(Conductance, rises_with_pressure_and_falls_with_viscosity) {
  for (const ConductanceLaw& law : {ConductanceLaw{PressureViscosityConductance{}}, ConductanceLaw{table}})
    for (double p = 1.1e4; p < 9e5; p *= 1.7)
      for (double eta = 1.1e2; eta < 5e7; eta *= 3) {
        EXPECT_GT(conductance(law, 1.05 * p, eta).h, conductance(law, p, eta).h);
        EXPECT_LT(conductance(law, p, 1.05 * eta).h, conductance(law, p, eta).h);
      }
}

TEST(Conductance, a_table_returns_its_entries_and_their_logarithmic_mean_place) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const auto value = conductance(table, table.pressure[i], table.viscosity[j]);
      EXPECT_NEAR(value.h, table.h[4 * i + j], 1e-9);
      EXPECT_FALSE(value.outside);
    }
  EXPECT_NEAR(conductance(table, std::sqrt(1e4 * 1e5), 1e3).h, (900 + 700 + 4000 + 2500) / 4.0, 1e-9);
}

TEST(Conductance, a_table_holds_its_ends_and_says_so) {
  const auto low = conductance(table, 0, 1e3), high = conductance(table, 1e9, 1e12);
  EXPECT_TRUE(low.outside);
  EXPECT_TRUE(high.outside);
  EXPECT_NEAR(low.h, 800, 1e-9);
  EXPECT_EQ(low.dh_dp, 0);
  EXPECT_LT(low.dh_deta, 0);
  EXPECT_EQ(high.h, 2000);
  EXPECT_EQ(high.dh_dp, 0);
  EXPECT_EQ(high.dh_deta, 0);
  EXPECT_FALSE(conductance(TableConductance{{1e5}, {1e3}, {1234}}, 1e5, 1e3).outside);
  EXPECT_EQ(conductance(TableConductance{{1e5}, {1e3}, {1234}}, 2e5, 1e2).h, 1234);
}

TEST(Conductance, without_its_power_of_the_pressure_the_law_is_the_same_at_any) {
  const PressureViscosityConductance law{300, 9000, 1e5, 1e4, 0, 0.4};
  const auto pressed = conductance(law, 3e5, 2e3);
  for (const double p : {0.0, 1.0, 1e8}) {
    const auto value = conductance(law, p, 2e3);
    EXPECT_EQ(value.h, pressed.h);
    EXPECT_EQ(value.dh_dp, 0);
    EXPECT_EQ(value.dh_deta, pressed.dh_deta);
  }
}

/// What the heat solver asks: all points of an interface at once.
TEST(Conductance, of_all_points_at_once_is_that_of_each) {
  std::vector<ConductanceLaw> laws = {ConstantConductance{5000}, table};
  for (const double a : {0.0, 0.7, 1.0})
    for (const double b : {0.0, 0.4}) laws.push_back(PressureViscosityConductance{300, 9000, 1e5, 1e4, a, b});
  std::vector<core::InterfacePoint> points;
  std::vector<double> viscosity;
  for (int law = 0; law < static_cast<int>(laws.size()); ++law)
    for (const double p : {-1e3, 0.0, 1e-300, 2e4, 1.3e5, 7e5, 1e300})
      for (const double eta : {1.0, 3e2, 5e3, 2e7, 1e12}) {
        points.emplace_back();
        points.back().law = law, points.back().pressure = p;
        viscosity.push_back(eta);
      }
  const auto count = static_cast<Eigen::Index>(points.size());
  const Eigen::ArrayXd log_viscosity = Eigen::Map<const Eigen::ArrayXd>(viscosity.data(), count).log();
  Eigen::ArrayXd h(count), derivative(count);
  core::Index outside = 0;
  const core::Index held = InterfaceConductance(laws, points)(log_viscosity, h, &derivative);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto value = conductance(laws[points[i].law], points[i].pressure, viscosity[i]);
    EXPECT_NEAR(h[i], value.h, 1e-11 * value.h)
        << "law " << points[i].law << " p " << points[i].pressure << " eta " << viscosity[i];
    EXPECT_NEAR(derivative[i], viscosity[i] * value.dh_deta, 1e-10 * value.h);
    outside += value.outside;
  }
  EXPECT_EQ(held, outside);
  EXPECT_GT(outside, 0);
}

}  // namespace
}  // namespace parison::contact
