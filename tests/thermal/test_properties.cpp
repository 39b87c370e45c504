// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "thermal/properties.hpp"

namespace parison::thermal {
namespace {

Material glass() {
  return {2400, {{300, 800, 1400}, {800, 1200, 1350}}, core::constant(1.3), Radiation{1.518, 150, true}};
}

TEST(Properties, rosseland_conductivity_lies_in_the_published_band) {
  // Genzel 1952: 46.5 W/m/K in clear and 8.1 in absorbing glass at 1200 degC.
  Material clear = glass(), absorbing = glass();
  clear.radiation->absorption = 47;
  absorbing.radiation->absorption = 267;
  EXPECT_NEAR(conductivity(clear, 1473.15) - 1.3, 46.5, 1.5);
  EXPECT_NEAR(conductivity(absorbing, 1473.15) - 1.3, 8.1, 0.3);
}

TEST(Properties, conductivity_without_radiation_is_the_phonon_part) {
  Material opaque = glass();
  opaque.radiation.reset();
  EXPECT_EQ(conductivity(opaque, 1473), 1.3);
  EXPECT_EQ(conductivity(glass(), -5), 1.3);
}

TEST(Properties, thin_wall_factor_reproduces_the_slab_between_black_walls) {
  // q = sigma (T1^4 - T2^4)/(1 + 3 kappa w/4) for nearly equal temperatures.
  for (const double w : {1e-5, 1e-3, 1e-1}) {
    Material material = glass();
    material.conductivity = core::constant(0);
    material.radiation->refractive_index = 1;
    const double T = 1300, dT = 1e-3;
    const double flux = conductivity(material, T, thin_wall_factor(*material.radiation, w)) * dT / w;
    const double exact = stefan_boltzmann * (std::pow(T + dT / 2, 4) - std::pow(T - dT / 2, 4)) / (1 + 0.75 * 150 * w);
    EXPECT_NEAR(flux / exact, 1, 1e-6);
  }
  EXPECT_EQ(thin_wall_factor({1.5, 150, false}, 1e-3), 1);
}

TEST(Properties, enthalpy_is_the_integral_of_the_heat_capacity) {
  const core::Table table = glass().heat_capacity;
  const Enthalpy enthalpy(table);
  EXPECT_NEAR(enthalpy(content_reference).h, 0, 1e-9);
  for (const double T : {100.0, 299.0, 301.0, 650.0, 799.0, 801.0, 1399.0, 1900.0}) {
    const double eps = 1e-3;
    EXPECT_NEAR((enthalpy(T + eps).h - enthalpy(T - eps).h) / (2 * eps), table(T), 1e-3);
    EXPECT_NEAR(enthalpy(T).c, table(T), 1e-12 * table(T));
    EXPECT_NEAR(enthalpy(T).h, table.integral(T) - table.integral(content_reference), 1e-6);
  }
  EXPECT_NEAR(Enthalpy(core::constant(1300))(373.15).h, 130000, 1e-9);
  EXPECT_TRUE(std::isnan(enthalpy(std::nan("")).h));
}

/// The temperatures at the points of four cells, 450 to 1600 K, and thin-wall factors.
struct CellPoints {
  PointValues temperature, thin_wall;
  CellPoints() {
    for (int q = 0; q < 6; ++q)
      for (int cell = 0; cell < 4; ++cell) {
        temperature[q][cell] = 450 + 50.0 * (4 * q + cell);
        thin_wall[q][cell] = 0.3 + 0.02 * (4 * q + cell);
      }
  }
};

TEST(Properties, arrays_have_the_bits_of_each_temperature) {
  const CellPoints at;
  PointValues k, h, c;
  const Material material = glass();
  for (const core::Table& capacity : {material.heat_capacity, core::constant(1300)}) {
    const Conductivity conductivity(material);
    const Enthalpy enthalpy(capacity);
    conductivity.set_values(at.temperature, at.thin_wall, k);
    enthalpy.set_enthalpies(at.temperature, h);
    enthalpy.set_capacities(at.temperature, c);
    for (int q = 0; q < 6; ++q)
      for (int cell = 0; cell < 4; ++cell) {
        const double T = at.temperature[q][cell];
        EXPECT_EQ(k[q][cell], conductivity(T, at.thin_wall[q][cell]));
        EXPECT_EQ(h[q][cell], enthalpy(T).h);
        EXPECT_EQ(c[q][cell], enthalpy(T).c);
      }
  }
}

TEST(Properties, derivatives_of_the_conductivity_agree_with_finite_differences_and_are_not_zero) {
  const CellPoints at;
  Material material = glass();
  for (const core::Table& phonon : {core::constant(1.3), core::Table{{300, 2000}, {0.9, 1.8}}}) {
    material.conductivity = phonon;
    const Conductivity conductivity(material);
    PointValues derivative;
    conductivity.set_derivatives(at.temperature, at.thin_wall, derivative);
    for (int q = 0; q < 6; ++q)
      for (int cell = 0; cell < 4; ++cell) {
        const double T = at.temperature[q][cell], factor = at.thin_wall[q][cell], step = 1e-2;
        const double by_difference = (conductivity(T + step, factor) - conductivity(T - step, factor)) / (2 * step);
        EXPECT_GT(by_difference, 1e-4);
        EXPECT_NEAR(derivative[q][cell] / by_difference, 1, 1e-7);
      }
  }
}

TEST(Properties, surface_flux_has_its_derivative_and_vanishes_at_equilibrium) {
  const ExchangeCoefficients exchange{20, 320, 0.89, 320};
  EXPECT_NEAR(surface_flux(exchange, 320).q, 0, 1e-9);
  for (const double T : {300.0, 900.0, 1423.0}) {
    const double eps = 1e-2;
    const double derivative = (surface_flux(exchange, T + eps).q - surface_flux(exchange, T - eps).q) / (2 * eps);
    EXPECT_NEAR(surface_flux(exchange, T).dq_dT / derivative, 1, 1e-8);
    EXPECT_GT(derivative, 20);
  }
  EXPECT_NEAR(surface_flux({0, 0, 1, 0}, 1000).q, 56703.74419, 1e-4);
}

}  // namespace
}  // namespace parison::thermal
