// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "core/case/case_error.hpp"
#include "figure.hpp"
#include "forming/study/law/law_fit.hpp"

namespace parison::contact {
namespace {

using namespace law_constant;

const PressureViscosityConductance truth{640, 15000, 0.2e6, 2.5e3, 0.8, 0.3};

/// Measurements of the law on a grid of pressures and viscosities, from far below x = 1 to far above.
std::vector<LawMeasurement> measured(const PressureViscosityConductance& law, int pressures = 12, int viscosities = 5) {
  std::vector<LawMeasurement> data;
  for (int i = 0; i < pressures; ++i)
    for (int j = 0; j < viscosities; ++j) {
      const double p = 1e2 * std::pow(1e6, double(i) / (pressures - 1)),
                   eta = 1e2 * std::pow(1e4, double(j) / (viscosities - 1));
      data.push_back({p, eta, conductance(law, p, eta).h, 1});
    }
  return data;
}

std::vector<LawMeasurement> with_scatter(std::vector<LawMeasurement> data, double fraction, std::mt19937& random) {
  std::normal_distribution<double> normal;
  for (auto& row : data) row.value *= 1 + fraction * normal(random);
  return data;
}

/// p_ref held at the true value, as the command does unless told otherwise.
LawFitOptions p_ref_fixed() {
  LawFitOptions options;
  options.fixed.p_ref = truth.p_ref;
  options.is_fixed[p_ref] = true;
  return options;
}

bool mentions(const LawFit& fit, const std::string& words) {
  for (const auto& warning : fit.warnings)
    if (warning.find(words) != warning.npos) return true;
  return false;
}

TEST(FitLaw, the_derivatives_agree_with_finite_differences_and_are_not_zero) {
  const auto derivatives = law_derivatives(truth, 9e4, 4e3);
  for (int constant = 0; constant < law_constants; ++constant) {
    const double step = 1e-6;
    auto more = truth, less = truth;
    const bool exponent = constant >= a;
    for (auto [law, d] : {std::pair{&more, step}, {&less, -step}}) {
      auto& value = constant_of(*law, constant);
      value = exponent ? value + d : value * std::exp(d);
    }
    const double by_difference = (conductance(more, 9e4, 4e3).h - conductance(less, 9e4, 4e3).h) / (2 * step);
    EXPECT_NEAR(derivatives[constant], by_difference, 1e-6 * std::abs(by_difference)) << law_constant_names[constant];
    EXPECT_NE(derivatives[constant], 0);
  }
}

TEST(FitLaw, exact_measurements_give_the_constants_back) {
  const auto fit = fit_law(measured(truth), p_ref_fixed());
  for (int constant = 0; constant < law_constants; ++constant)
    EXPECT_NEAR(fit.constants[constant].value / constant_of(truth, constant), 1, 1e-6) << law_constant_names[constant];
  EXPECT_TRUE(fit.warnings.empty());
  EXPECT_EQ(fit.freedom, 60 - 5);
}

TEST(FitLaw, a_heat_flux_history_gives_the_same_constants_as_the_conductance) {
  auto data = measured(truth);
  for (std::size_t i = 0; i < data.size(); ++i) {
    data[i].drive = 700 - 9.0 * static_cast<double>(i);
    data[i].value *= data[i].drive;
  }
  const auto fit = fit_law(data, p_ref_fixed());
  for (int constant = 0; constant < law_constants; ++constant)
    EXPECT_NEAR(fit.constants[constant].value / constant_of(truth, constant), 1, 1e-6) << law_constant_names[constant];
}

TEST(FitLaw, the_intervals_hold_the_true_constants_in_95_of_100_repeated_measurements) {
  constexpr int draws = 500;
  std::mt19937 random(7);
  const auto exact = measured(truth);
  auto options = p_ref_fixed();
  options.relative = true;
  std::array<int, law_constants> inside{};
  for (int draw = 0; draw < draws; ++draw) {
    const auto fit = fit_law(with_scatter(exact, 0.06, random), options);
    for (const int constant : {h0, h1, eta_ref, a, b}) {
      const auto& found = fit.constants[constant];
      inside[constant] += found.low <= constant_of(truth, constant) && constant_of(truth, constant) <= found.high;
    }
  }
  tests::Figure off("fitted law, 500 draws: fraction of 95 % intervals that hold the true constant, off 0.95 by");
  for (const int constant : {h0, h1, eta_ref, a, b}) off.add(std::abs(inside[constant] / double(draws) - 0.95));
  off.at_most(0.03);  // 3 standard deviations of 500 draws
}

TEST(FitLaw, few_measurements_widen_the_intervals_by_students_t) {
  // With h0 alone free the law is linear in it: s/sqrt(n) times t of 3 degrees of freedom, on the logarithmic scale.
  auto options = p_ref_fixed();
  options.fixed = truth;
  options.is_fixed = {false, true, true, true, true, true};
  std::vector<LawMeasurement> data;
  for (const double value : {630.0, 650.0, 660.0, 620.0}) data.push_back({0, 1e3, value, 1});
  const auto fit = fit_law(data, options);
  const double sd = std::sqrt((100.0 + 100 + 400 + 400) / 3);
  EXPECT_NEAR(fit.constants[h0].value, 640, 1e-6);
  EXPECT_NEAR(fit.scatter, sd, 1e-9);
  EXPECT_NEAR(fit.constants[h0].high, 640 * std::exp(3.182446 * sd / 2 / 640), 1e-4);
}

TEST(FitLaw, p_ref_and_eta_ref_are_one_constant_and_cannot_both_be_free) {
  std::mt19937 random(3);
  const auto data = with_scatter(measured(truth), 0.02, random);
  const auto both = fit_law(data, {});
  EXPECT_FALSE(both.constants[p_ref].known);
  EXPECT_FALSE(both.constants[eta_ref].known);
  EXPECT_TRUE(both.constants[a].known && both.constants[b].known && both.constants[h0].known &&
              both.constants[h1].known);
  EXPECT_TRUE(mentions(both, "p_ref is not identifiable"));

  // Held at any value, the other one moves along and the law stays the same.
  auto other = p_ref_fixed();
  other.fixed.p_ref = 5e4;
  const auto here = fit_law(data, p_ref_fixed()), there = fit_law(data, other);
  EXPECT_GT(std::abs(there.law.eta_ref / here.law.eta_ref - 1), 0.5);
  for (const auto& row : data)
    EXPECT_NEAR(
        conductance(here.law, row.pressure, row.viscosity).h / conductance(there.law, row.pressure, row.viscosity).h, 1,
        1e-5);
}

TEST(FitLaw, constants_that_the_data_do_not_reach_are_named) {
  auto data = measured(truth);
  for (auto& row : data) {  // far below x = 1: the law is h0 + h1 C p^a eta^-b, and h1 and C are one constant
    row.pressure *= 3e-6;
    row.value = conductance(truth, row.pressure, row.viscosity).h;
  }
  std::mt19937 random(5);
  const auto fit = fit_law(with_scatter(data, 0.01, random), p_ref_fixed());
  EXPECT_TRUE(fit.constants[h0].known);
  EXPECT_FALSE(fit.constants[h1].known);
  EXPECT_TRUE(mentions(fit, "h1 is not identifiable"));
}

TEST(FitLaw, an_exponent_that_comes_out_negative_is_held_at_zero_with_a_warning) {
  const PressureViscosityConductance thickens{640, 15000, 0.2e6, 2.5e3, 0.8, -0.1};
  auto options = p_ref_fixed();
  const auto fit = fit_law(measured(thickens), options);
  EXPECT_EQ(fit.law.b, 0);
  EXPECT_TRUE(fit.constants[b].fixed);
  EXPECT_TRUE(mentions(fit, "b came out below zero"));
  EXPECT_FALSE(fit.constants[p_ref].fixed);  // it alone places x = 1 now
  EXPECT_NEAR(fit.law.a, 0.8, 0.1);
}

TEST(FitLaw, too_few_rows_are_refused_with_their_number) {
  auto data = measured(truth);
  data.resize(5);
  try {
    fit_law(data, p_ref_fixed());
    FAIL();
  } catch (const core::CaseError& error) {
    EXPECT_STREQ(error.what(),
                 "--law: 5 rows were found, allowed are at least 6 for 5 free constants (fewer with --fix NAME=VALUE)");
  }
}

/// What the reading of a CSV text complains about, without the file's name.
std::string complaint_about(const std::string& text, bool with_viscosity = false) {
  const auto path = (std::filesystem::path(testing::TempDir()) / "parison_law_data.csv").string();
  std::ofstream(path) << text;
  std::function<double(double)> viscosity;
  if (with_viscosity) viscosity = [](double temperature) { return 1e6 / temperature; };
  try {
    read_law_data(path, viscosity);
  } catch (const core::CaseError& error) {
    const std::string message = error.what();
    return message.rfind(path + ":", 0) == 0 ? message.substr(path.size() + 1) : message;
  }
  return "";
}

TEST(LawData, units_stand_in_the_heading) {
  const auto path = (std::filesystem::path(testing::TempDir()) / "parison_law_units.csv").string();
  std::ofstream(path) << "p_kPa,eta_kPa.s,h_kW/m2/K\n200, 1, 3.5\n\n50,20,0.75\r\n";
  const auto data = read_law_data(path, {});
  ASSERT_EQ(data.size(), 2u);
  EXPECT_DOUBLE_EQ(data[0].pressure, 2e5);
  EXPECT_DOUBLE_EQ(data[0].viscosity, 1e3);
  EXPECT_DOUBLE_EQ(data[0].value, 3500);
  EXPECT_DOUBLE_EQ(data[1].value, 750);
  EXPECT_EQ(data[1].drive, 1);
}

TEST(LawData, a_heat_flux_comes_with_both_temperatures_and_the_glass_gives_the_viscosity) {
  const auto path = (std::filesystem::path(testing::TempDir()) / "parison_law_flux.csv").string();
  std::ofstream(path) << "t_s,q_MW/m2,p_bar,T_glass_degC,T_tool_degC\n0.1,1.5,2,1000,500\n";
  const auto data = read_law_data(path, [](double temperature) { return 2 * temperature; });
  ASSERT_EQ(data.size(), 1u);
  EXPECT_DOUBLE_EQ(data[0].value, 1.5e6);
  EXPECT_DOUBLE_EQ(data[0].drive, 500);
  EXPECT_DOUBLE_EQ(data[0].viscosity, 2 * 1273.15);
}

TEST(LawData, mistakes_are_refused_with_row_and_column) {
  const std::string heading = "p_kPa,eta_Pa.s,h_W/m2/K\n";
  EXPECT_EQ(
      complaint_about(heading + "200,1e3,3500\n100,abc,2000\n"),
      "3: column \"eta\": \"abc Pa.s\" does not start with a number, allowed is a viscosity such as \"1e4 Pa.s\"");
  EXPECT_EQ(complaint_about(heading + "200,1e3\n"), "2: 2 cells were found, allowed are 3 as in the heading");
  EXPECT_EQ(complaint_about(heading + "200,,3500\n").rfind("2: column \"eta\":", 0), 0u);
  EXPECT_EQ(complaint_about(heading + "nan,1e3,3500\n").rfind("2: column \"p\":", 0), 0u);
  EXPECT_EQ(complaint_about(heading + "200,-1e3,3500\n"),
            "2: column \"eta\": \"-1e3 Pa.s\" was found, allowed are values above zero");
  EXPECT_EQ(complaint_about(heading + "-2,1e3,3500\n"),
            "2: column \"p\": \"-2 kPa\" was found, allowed are values from zero");
  EXPECT_EQ(complaint_about("p_kPa,eta_mm,h_W/m2/K\n1,1,1\n"),
            "1: column \"eta_mm\": \"1 mm\" is a length, allowed is a viscosity such as \"1e4 Pa.s\"");
  EXPECT_EQ(complaint_about("p_kPa,etaa_Pa.s,h_W/m2/K\n1,1,1\n")
                .rfind("1: column \"etaa_Pa.s\": an unknown heading (did you mean \"eta\"?)", 0),
            0u);
  EXPECT_EQ(complaint_about("p_kPa,p_Pa,h_W/m2/K\n1,1,1\n"),
            "1: column \"p_Pa\": \"p\" was found twice, allowed is once");
  EXPECT_EQ(complaint_about("p_kPa,h_W/m2/K\n1,1\n").rfind("1: the column eta is missing", 0), 0u);
  EXPECT_EQ(complaint_about("eta_Pa.s,h_W/m2/K\n1,1\n"), "1: the column p is missing");
  EXPECT_EQ(complaint_about("p_kPa,eta_Pa.s,q_W/m2\n1,1,1\n", true),
            "1: a heat flux q also needs the columns T_glass and T_tool");
  EXPECT_EQ(complaint_about(heading).rfind("1: no rows were found", 0), 0u);
  EXPECT_NE(
      complaint_about("p_bar,q_kW/m2,T_glass_degC,T_tool_degC\n1,1,900,500\n").find("has a viscosity before --law"),
      std::string::npos);
  EXPECT_EQ(complaint_about("p_bar,q_kW/m2,T_glass_degC,T_tool_degC\n1,1,900,500\n", true), "");
  EXPECT_THROW(read_law_data("no/such/file.csv", {}), core::CaseError);
}

}  // namespace
}  // namespace parison::contact
