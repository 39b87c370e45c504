// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "forming/step/heat/thermal_interface.hpp"

namespace parison::forming {
namespace {

TEST(MortarDerivatives, h_follows_the_glass_temperature_through_the_viscosity_by_every_law) {
  Scene scene;
  scene.glass.flow = flow::Material{2400, {-2.309, 3922, 564.15, {}}, {}, 0};
  const contact::TableConductance table{
      {1e4, 1e5, 1e6}, {1e2, 1e4, 1e6, 1e9}, {900, 700, 600, 500, 4000, 2500, 1500, 800, 20000, 12000, 6000, 2000}};
  scene.tools.emplace_back();
  scene.interfaces = {{0, contact::PressureViscosityConductance{}, 5e-5},
                      {0, contact::PressureViscosityConductance{300, 9000, 1e5, 1e4, 0.7, 0.4}, 5e-5},
                      {0, table, 5e-5},
                      {0, contact::ConstantConductance{5000}, 5e-5}};
  long outside = 0;
  core::InterfacePoint point{};
  for (point.law = 0; point.law < 4; ++point.law)
    for (const double pressure : {2e4, 2e5, 8e5})
      for (const double T : {973.0, 1123.0, 1273.0, 1423.0}) {
        point.pressure = pressure;
        const auto h = [&](double at) { return point_conductance(scene, point, {at, 750}, outside).h; };
        const double derivative = point_conductance(scene, point, {T, 750}, outside).dh_dT;
        const double measured = (h(T + 0.01) - h(T - 0.01)) / 0.02;
        EXPECT_NEAR(derivative, measured, 1e-6 * std::abs(measured) + 1e-12)
            << point.law << " " << pressure << " " << T;
        if (point.law < 3) {
          EXPECT_GT(derivative, 0);  // hotter glass is softer and touches better
        } else {
          EXPECT_EQ(derivative, 0);
        }
      }
  EXPECT_EQ(outside, 0);
}

}  // namespace
}  // namespace parison::forming
