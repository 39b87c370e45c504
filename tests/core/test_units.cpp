// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/case/units.hpp"

namespace parison::core {
namespace {

struct Pair {
  const char* text;
  Dimension dimension;
  double si;
};

TEST(Units, quantities_become_si) {
  const Pair pairs[] = {{"1150 degC", dimension::temperature, 1423.15},
                        {"-20 degC", dimension::temperature, 253.15},
                        {"300 K", dimension::temperature, 300},
                        {"40 K", dimension::temperature_difference, 40},
                        {"2.5 mm", dimension::length, 2.5e-3},
                        {"-3 um", dimension::length, -3e-6},
                        {"0.35 bar", dimension::pressure, 0.35e5},
                        {"20 mbar", dimension::pressure, 2000},
                        {"0.2 MPa", dimension::pressure, 2e5},
                        {"8 kN", dimension::force, 8000},
                        {"150 mm/s", dimension::speed, 0.15},
                        {"9.81 m/s2", dimension::acceleration, 9.81},
                        {"9.81 m.s^-2", dimension::acceleration, 9.81},
                        {"1.3 W/m/K", dimension::conductivity, 1.3},
                        {"1300 J/kg/K", dimension::heat_capacity, 1300},
                        {"1.3 kJ/kg/K", dimension::heat_capacity, 1300},
                        {"5000 W/m2/K", dimension::conductance, 5000},
                        {"0.5 W/cm2/K", dimension::conductance, 5000},
                        {"2.4 g/cm3", dimension::density, 2400},
                        {"1e4 Pa.s", dimension::viscosity, 1e4},
                        {"1e4 Pa*s", dimension::viscosity, 1e4},
                        {"10 P", dimension::viscosity, 1},
                        {"10 dPa s", dimension::viscosity, 1},
                        {"1e6 Pa.s/m", dimension::friction, 1e6},
                        {"150 1/m", dimension::inverse_length, 150},
                        {"1.5 1/cm", dimension::inverse_length, 150},
                        {"0.3 N/m", dimension::surface_tension, 0.3},
                        {"91.5 cm3", dimension::volume, 91.5e-6},
                        {"91.5 ml", dimension::volume, 91.5e-6},
                        {"12 ms", dimension::time, 0.012},
                        {"2 min", dimension::time, 120},
                        {"30 deg", dimension::none, M_PI / 6},
                        {"20 %", dimension::none, 0.2},
                        {"  0.5  ", dimension::none, 0.5}};
  for (const auto& [text, dimension, si] : pairs) {
    const auto parsed = parse_quantity(text, dimension);
    EXPECT_EQ(parsed.problem, "") << text;
    EXPECT_NEAR(parsed.value, si, 1e-14 * std::abs(si)) << text;
  }
}

TEST(Units, another_dimension_is_named_along_with_the_allowed_one) {
  EXPECT_EQ(parse_quantity("5 mm", dimension::pressure).problem,
            "\"5 mm\" is a length, allowed is a pressure such as \"0.35 bar\"");
  EXPECT_EQ(parse_quantity("5", dimension::time).problem,
            "\"5\" is a plain number, allowed is a time such as \"0.9 s\"");
  EXPECT_EQ(parse_quantity("5 kg.m", dimension::length).problem,
            "\"5 kg.m\" is a quantity in kg m, allowed is a length such as \"2.5 mm\"");
}

TEST(Units, a_heat_on_an_area_is_not_called_a_surface_tension) {
  EXPECT_EQ(parse_quantity("100 kJ/m2", dimension::heat_per_area).value, 1e5);
  EXPECT_EQ(parse_quantity("100 kJ", dimension::heat_per_area).problem,
            "\"100 kJ\" is an energy, allowed is a heat on an area such as \"100 kJ/m2\"");
  EXPECT_EQ(parse_quantity("3 K", dimension::surface_tension).problem,
            "\"3 K\" is a temperature difference, allowed is a surface tension such as \"0.3 N/m\"");
}

TEST(Units, a_scale_temperature_is_no_difference) {
  EXPECT_EQ(parse_quantity("40 degC", dimension::temperature_difference).problem,
            "\"40 degC\" is a temperature on a scale, allowed is a temperature difference such as \"40 K\"");
  EXPECT_NE(parse_quantity("5 W/m2/degC", dimension::conductance).problem, "");
}

TEST(Units, what_is_no_quantity_is_refused) {
  for (const char* text : {"", "mm", "abc", "nan mm", "inf mm", "1e999 mm", "5 furlong", "5 mm2x", "5 m/", "5 /s",
                           "5 m^", "5 m99", "5 mmm"})
    EXPECT_NE(parse_quantity(text, dimension::length).problem, "") << text;
  EXPECT_EQ(parse_quantity("5 furlong", dimension::length).problem,
            "\"5 furlong\" has the unknown unit \"furlong\", allowed is a length such as \"2.5 mm\"");
}

TEST(Units, a_quantity_beyond_all_glass_and_machines_is_refused_with_its_unit) {
  EXPECT_EQ(parse_quantity("1e12 mm", dimension::length).problem,
            "\"1e12 mm\" is too large, allowed is a length such as \"2.5 mm\" of up to 1e+06 m");
  EXPECT_EQ(parse_quantity("-1e300 kg/m3", dimension::density).problem,
            "\"-1e300 kg/m3\" is too large, allowed is a density such as \"2400 kg/m3\" of up to 1e+09 kg m^-3");
  EXPECT_EQ(parse_quantity("1e200 degC", dimension::temperature).problem,
            "\"1e200 degC\" is too large, allowed is a temperature such as \"1150 degC\" of up to 100000 K");
  for (const char* text : {"1e999 mm", "1e-999 mm"})
    EXPECT_EQ(parse_quantity(text, dimension::length).problem,
              '"' + std::string(text) +
                  "\" starts with a number that is too large or too near to zero, allowed is a "
                  "length such as \"2.5 mm\"");
}

}  // namespace
}  // namespace parison::core
