#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/bodies.hpp"

namespace parison::thermal::test {

/// With k and c both proportional to 1 + slope (T - base), the integral of that factor obeys the linear heat equation:
/// an exact solution with both properties varying by a factor of four.
struct Varying {
  static constexpr double base = 1000, slope = 1e-3, amplitude = 900, side = 0.01, k0 = 30, c0 = 600, density = 7800;
  Material material{density,
                    {{200, 3000}, {c0 * factor(200), c0* factor(3000)}},
                    {{200, 3000}, {k0 * factor(200), k0* factor(3000)}},
                    {}};

  static double factor(double T) { return 1 + slope * (T - base); }
  static double exact(const Point& x, double t) {
    const double decay = std::exp(-2 * std::pow(M_PI / side, 2) * k0 / (density * c0) * t);
    const double theta = amplitude * std::sin(M_PI * x[0] / side) * std::sin(M_PI * x[1] / side) * decay;
    return base + (std::sqrt(1 + 2 * slope * theta) - 1) / slope;
  }
  Problem problem(const core::Mesh& mesh) const {
    Problem made{core::Geometry::planar, {body(mesh, material)}, {}, {}};
    for (auto& given : made.bodies[0].prescribed) given = base;
    return made;
  }
};

}  // namespace parison::thermal::test
