#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// Emission of an isothermal tube of glass to both sides, computed and by the radiative transfer equation along its
// rays.
#include <limits>

#include "thermal/radiation/exact_emission.hpp"

namespace parison::thermal::test {

inline constexpr double wall = 0.003, index_of_glass = 1.518;  ///< m

/// A tube in cold surroundings, which its inner face sees too.
inline IsothermalBody isothermal_tube(Model model, double inner_radius, double absorption) {
  const double outer_radius = inner_radius + wall, height = wall / 40;
  return {rectangle(divide(inner_radius, outer_radius, 40), {0, height}),
          Geometry::axisymmetric,
          {index_of_glass, 0, false, model, {{std::numeric_limits<double>::infinity(), absorption}}},
          {right, left},
          2 * M_PI * (inner_radius + outer_radius) * height};
}

/// Light out of both of its faces over that of black ones.
inline double tube_emissivity(Model model, double inner_radius, double absorption) {
  return isothermal_tube(model, inner_radius, absorption).emissivity();
}

/// The share of a black body's intensity that leaves at the end of a path between two reflections: `here` and `there`
/// are the reflectivities at its ends, `passed` its transmission.
inline double leaving(double here, double there, double passed) {
  const double from_there = there * (1 - passed) * (1 + passed * here) / (1 - here * there * passed * passed);
  return (1 - here) * (from_there * passed + 1 - passed);
}

/// Light that leaves a face of a radius at an angle b to the axis and p to the normal in the plane across it, for the
/// intensity of a black body 1.
inline double leaving_at(double radius, double b, double p, double inner, double outer, double absorption) {
  const double offset = radius * std::sin(p), far = std::sqrt(outer * outer - offset * offset);
  const double at_outer = fresnel_reflectivity(index_of_glass, std::sin(b) * far / outer);
  if (offset > inner) return leaving(at_outer, at_outer, std::exp(-absorption * 2 * far / std::sin(b)));
  const double near = std::sqrt(std::max(0.0, inner * inner - offset * offset));
  const double at_inner = fresnel_reflectivity(index_of_glass, std::sin(b) * near / inner);
  const double passed = std::exp(-absorption * (far - near) / std::sin(b));
  return radius == outer ? leaving(at_outer, at_inner, passed) : leaving(at_inner, at_outer, passed);
}

/// n^2 times the mean of that over the surfaces and the directions.
inline double exact_tube(double inner, double absorption) {
  const double outer = inner + wall;
  constexpr int parts = 800;
  double sum = 0;
  for (const double radius : {inner, outer})
    for (int i = 0; i < parts; ++i)
      for (int j = 0; j < parts; ++j) {
        const double p = M_PI / 2 * (i + 0.5) / parts, b = M_PI / 2 * (j + 0.5) / parts;
        sum += radius * std::pow(std::sin(b), 2) * std::cos(p) * leaving_at(radius, b, p, inner, outer, absorption);
      }
  return index_of_glass * index_of_glass * sum * 4 / M_PI * std::pow(M_PI / 2 / parts, 2) / (inner + outer);
}

}  // namespace parison::thermal::test
