// SPDX-License-Identifier: GPL-3.0-or-later
// Residual stress of plates against the converged numbers of a one-dimensional finite-volume solution, whose surface
// values are good to 0.3 %.
#include <cstdio>

#include "cooling_body.hpp"
#include "figure.hpp"

namespace parison::cooling {
namespace {

constexpr double kelvin = 273.15;

struct Plate {
  const char* name;
  double thickness, start;  // m, degC
  double h, rate;           // W/m2/K into air, or K/s of the surface
  double surface, middle;   // MPa
  Index rows;
};

void heat_by_air(const Plate& plate, CoolingBody& body) {
  body.heat = {2500, core::constant(1330), {{kelvin, kelvin + 1000}, {0.975, 0.975 + 0.858}}, {}, {}};
  body.exchange[core::find_boundary(body.mesh, "top")] = thermal::SurfaceExchange{plate.h, kelvin + 20, 0, 300};
}

void heat_at_a_rate(const Plate& plate, CoolingBody& body) {
  body.heat = {2500, core::constant(1100), core::constant(1.3), {}, {}};
  body.heat_tolerance = 1e-3;
  body.prescribed[core::find_boundary(body.mesh, "top")] =
      core::TimeFunction(core::Table{{0, (plate.start - 20) / plate.rate}, {kelvin + plate.start, kelvin + 20}});
}

void compare(const Plate& plate, double change) {
  CoolingBody body(reference_law(), half_plate(plate.thickness, plate.rows), core::Geometry::axisymmetric,
                   plate.start + kelvin);
  hold_symmetry(body);
  if (plate.h > 0) {
    heat_by_air(plate, body);
    body.cool(7.5 * 2500 * 1330 * plate.thickness / 2 / plate.h, change, 1e-3);
  } else {
    heat_at_a_rate(plate, body);
    body.cool((plate.start - 20) / plate.rate, change, 0.1);
    body.cool(body.time + 10 * std::pow(plate.thickness / 2, 2) / 4.727e-7, change, 0.1);
  }
  const double surface = body.stress({0, plate.thickness / 2}, 2), middle = body.stress({0, 0}, 2);
  std::printf("%s: surface %.4f MPa, middle %.4f MPa, %d steps\n", plate.name, surface, middle, body.steps);
  tests::Figure off_surface(std::string(plate.name) + ": surface stress off by");
  off_surface.add(std::abs(surface / plate.surface - 1));
  off_surface.at_most(5e-3);
  tests::Figure off_middle(std::string(plate.name) + ": stress in the middle off by");
  off_middle.add(std::abs(middle / plate.middle - 1));
  off_middle.at_most(2e-3);
}

TEST(Plates, quenched) {
  compare({"plate of 6.1 mm quenched from 650 degC", 6.1e-3, 650, 280, 0, -124.8, 56.3, 12}, 5);
}
TEST(Plates, cooled_in_still_air) {
  compare({"plate of 3 mm in still air", 3e-3, 600, 20, 0, -5.14, 2.64, 12}, 2.5);
}
TEST(Plates, cooled_by_a_fan) {
  compare({"plate of 3 mm under a fan", 3e-3, 600, 60, 0, -10.41, 5.88, 12}, 2.5);
}
TEST(Plates, annealed_slowly) {
  compare({"plate of 6 mm at 5 K/min", 6e-3, 600, 0, 5.0 / 60, -0.857, 0.428, 12}, 2.5);
}
TEST(Plates, annealed_faster) {
  compare({"plate of 6 mm at 30 K/min", 6e-3, 600, 0, 0.5, -5.11, 2.54, 12}, 2.5);
}

}  // namespace
}  // namespace parison::cooling
