#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <string>

namespace parison::forming {

// Parts of case files that several scenes are put together from.

inline const std::string iron = R"([material.iron]
density = "7200 kg/m3"
heat_capacity = "490 J/kg/K"
conductivity = "46 W/m/K"
)";

/// A glass that stiffens as it cools; more lines of its table may follow.
inline std::string container_glass(const std::string& conductivity) {
  return fmt::format(R"([material.glass]
density = "2400 kg/m3"
heat_capacity = "1300 J/kg/K"
conductivity = "{}"
viscosity = {{ law = "vft", A = -2.309, B = "3922 K", T0 = "291 degC" }}
)",
                     conductivity);
}

/// A ring of stiff glass, from 6 to 8 mm radius and 10 mm high, on z = 0; its boundaries are bottom, outer, top, inner.
inline const std::string ring_of_glass = R"([material.stiff]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e5 Pa.s" }
[glass]
material = "stiff"
mesh = { mapped = [4, 10] }
boundary = [
  { name = "bottom", condition = "contact", path = "(6, 0) (8, 0) mm" },
  { name = "outer", condition = "contact", path = "(8, 10) mm" },
  { name = "top", condition = "contact", path = "(6, 10) mm" },
  { name = "inner", condition = "contact", path = "(6, 0) mm" } ]
)";

/// A conductance that grows with the pressure and falls with the viscosity, between glass and tools.
inline std::string pressed_contact(const std::string& tools) {
  return fmt::format(R"([[interface]]
tools = [{}]
law = "pressure-viscosity"
h0 = "500 W/m2/K"
h1 = "20000 W/m2/K"
p_ref = "0.2 MPa"
eta_ref = "1e3 Pa.s"
a = 1
b = 0.25
)",
                     tools);
}

/// A disc of glass, 20 mm radius, that a plate and a plunger above it touch; `height` in mm, `glass` and `tool` are
/// further lines of their tables.
inline std::string disc_between_plates(int height, const std::string& glass, const std::string& tool) {
  return fmt::format(R"([glass]
{1}boundary = [
  {{ name = "bottom", condition = "contact", path = "(0, 0) (20, 0) mm" }},
  {{ name = "rim", condition = "air", path = "(20, {0}) mm" }},
  {{ name = "top", condition = "contact", path = "(0, {0}) mm" }},
  {{ name = "axis", condition = "symmetry", path = "(0, 0) mm" }} ]
[[tool]]
name = "plate"
{2}boundary = [
  {{ name = "face", condition = "contact", path = "(60, 0) (0, 0) mm" }},
  {{ name = "axis", condition = "symmetry", path = "(0, -10) mm" }},
  {{ name = "rest", condition = "insulated", path = "(60, -10) mm" }} ]
[[tool]]
name = "plunger"
{2}boundary = [
  {{ name = "face", condition = "contact", path = "(0, {0}) (60, {0}) mm" }},
  {{ name = "rest", condition = "insulated", path = "(60, {3}) (0, {3}) mm" }},
  {{ name = "axis", condition = "symmetry", path = "(0, {0}) mm" }} ]
)",
                     height, glass, tool, height + 10);
}

}  // namespace parison::forming
