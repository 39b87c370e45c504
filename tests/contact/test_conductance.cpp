// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/conductance/conductance.hpp"
#include "contact/conductance/interface_conductance.hpp"

namespace parison::contact {
namespace {

const TableConductance table{
    {1e4, 1e5, 1e6}, {1e2, 1e4, 1e6, 1e8}, {900, 700, 600, 500, 4000, 2500, 1500, 800, 20000, 12000, 6000, 2000}};

void expect_derivatives(const ConductanceLaw& law, double pressure, double viscosity) {
  const auto value = conductance(law, pressure, viscosity);
  const double de = 1e-5 * viscosity;
  const double by_eta =
      (conductance(law, pressure, viscosity + de).h - conductance(law, pressure, viscosity - de).h) / (2 * de);
  EXPECT_LT(value.dh_deta, 0);
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
    EXPECT_EQ(value.dh_deta, 0);
  }
}

TEST(Conductance, the_pressure_law_tends_to_h0_without_pressure_and_to_h1_under_a_high_one) {
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

TEST(Conductance, a_table_returns_its_entries_and_interpolates_between_logarithms) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const auto value = conductance(table, table.pressure[i], table.viscosity[j]);
      EXPECT_NEAR(value.h, table.h[4 * i + j], 1e-9);
      EXPECT_FALSE(value.clamped);
    }
  EXPECT_NEAR(conductance(table, std::sqrt(1e4 * 1e5), 1e3).h, (900 + 700 + 4000 + 2500) / 4.0, 1e-9);
}

TEST(Conductance, a_table_is_constant_beyond_its_ends_and_says_so) {
  const auto low = conductance(table, 0, 1e3), high = conductance(table, 1e9, 1e12);
  EXPECT_TRUE(low.clamped);
  EXPECT_TRUE(high.clamped);
  EXPECT_NEAR(low.h, 800, 1e-9);
  EXPECT_LT(low.dh_deta, 0);
  EXPECT_EQ(high.h, 2000);
  EXPECT_EQ(high.dh_deta, 0);
  EXPECT_FALSE(conductance(TableConductance{{1e5}, {1e3}, {1234}}, 1e5, 1e3).clamped);
  EXPECT_EQ(conductance(TableConductance{{1e5}, {1e3}, {1234}}, 2e5, 1e2).h, 1234);
}

TEST(Conductance, with_exponent_zero_the_law_does_not_depend_on_the_pressure) {
  const PressureViscosityConductance law{300, 9000, 1e5, 1e4, 0, 0.4};
  const auto in_contact = conductance(law, 3e5, 2e3);
  for (const double p : {0.0, 1.0, 1e8}) {
    const auto value = conductance(law, p, 2e3);
    EXPECT_EQ(value.h, in_contact.h);
    EXPECT_EQ(value.dh_deta, in_contact.dh_deta);
  }
}

/// Points with every law, pressure and viscosity, as the heat solver passes them.
struct ManyPoints {
  std::vector<ConductanceLaw> laws = {ConstantConductance{5000}, table};
  std::vector<core::InterfacePoint> points;
  std::vector<double> viscosity;

  ManyPoints() {
    for (const double a : {0.0, 0.7, 1.0})
      for (const double b : {0.0, 0.4}) laws.push_back(PressureViscosityConductance{300, 9000, 1e5, 1e4, a, b});
    for (int law = 0; law < static_cast<int>(laws.size()); ++law)
      for (const double p : {-1e3, 0.0, 1e-300, 2e4, 1.3e5, 7e5, 1e300})
        for (const double eta : {1.0, 3e2, 5e3, 2e7, 1e12}) {
          points.emplace_back();
          points.back().law = law, points.back().pressure = p;
          viscosity.push_back(eta);
        }
  }
  Eigen::ArrayXd log_viscosity() const {
    return Eigen::Map<const Eigen::ArrayXd>(viscosity.data(), static_cast<Eigen::Index>(viscosity.size())).log();
  }
};

TEST(Conductance, of_an_array_of_points_is_that_of_each_point) {
  const ManyPoints many;
  const Eigen::ArrayXd log_viscosity = many.log_viscosity();
  Eigen::ArrayXd h(log_viscosity.size()), derivative(log_viscosity.size());
  const core::Index clamped = InterfaceConductance(many.laws, many.points)(log_viscosity, h, &derivative);
  core::Index expected = 0;
  for (Eigen::Index i = 0; i < h.size(); ++i) {
    const auto& point = many.points[i];
    const auto value = conductance(many.laws[point.law], point.pressure, many.viscosity[i]);
    EXPECT_NEAR(h[i], value.h, 1e-14 * value.h)
        << "law " << point.law << " p " << point.pressure << " eta " << many.viscosity[i];
    EXPECT_NEAR(derivative[i], many.viscosity[i] * value.dh_deta, 1e-13 * value.h);
    expected += value.clamped;
  }
  EXPECT_EQ(clamped, expected);
  EXPECT_GT(clamped, 0);
}

/// Arrays of one to twenty points begin and end anywhere in Eigen's packets.
TEST(Conductance, a_point_has_the_same_bits_alone_and_anywhere_in_an_array) {
  const ManyPoints many;
  const Eigen::ArrayXd log_viscosity = many.log_viscosity();
  for (std::size_t first = 0; first < many.points.size(); first += 3)
    for (std::size_t last = first + 1; last <= std::min(first + 20, many.points.size()); ++last) {
      const std::vector<core::InterfacePoint> points(many.points.begin() + first, many.points.begin() + last);
      const Eigen::ArrayXd own = log_viscosity.segment(first, last - first);
      Eigen::ArrayXd h(own.size()), h_again(own.size()), derivative(own.size());
      InterfaceConductance(many.laws, points)(own, h, nullptr);
      InterfaceConductance(many.laws, points)(own, h_again, &derivative);
      EXPECT_TRUE((h == h_again).all());
      for (Eigen::Index i = 0; i < h.size(); ++i) {
        const auto* law = std::get_if<PressureViscosityConductance>(&many.laws[points[i].law]);
        if (!law) continue;
        const double part = law->pressure_part(std::max(points[i].pressure, 0.0));
        EXPECT_EQ(h[i], law->from_logarithms(part, own[i]));
        const core::Dual<double> with_derivative = law->from_logarithms<core::Dual<double>>({part, 0}, {own[i], 1});
        EXPECT_EQ(h[i], with_derivative.value);
        EXPECT_EQ(derivative[i], with_derivative.derivative);
      }
    }
}

}  // namespace
}  // namespace parison::contact
