#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later

namespace parison::forming {

/// A gob of glass, 10 mm radius and 10 mm high, pressed by a plunger into a pot of 12 mm radius: full at 6.944 mm.
inline constexpr const char* pot = R"(# A gob pressed in a pot.
case = "pot"
geometry = "axisymmetric"
air = { temperature = "50 degC", h = "20 W/m2/K", ambient = "50 degC" }
output.interval = "0.2 s"
[[stage]]
name = "press"
duration = "0.4 s"
gravity = "-9.81 m/s2"
tools = ["pot", "plunger"]
motion.plunger = { force = "-3 kN", speed_limit = "50 mm/s" }
[material.glass]
density = "2400 kg/m3"
heat_capacity = "1300 J/kg/K"
conductivity = "3 W/m/K"
viscosity = { law = "vft", A = -2.309, B = "3922 K", T0 = "291 degC" }
emissivity = 0.89
[material.iron]
density = "7200 kg/m3"
heat_capacity = "490 J/kg/K"
conductivity = "46 W/m/K"
[[interface]]
tools = ["pot", "plunger"]
law = "pressure-viscosity"
h0 = "500 W/m2/K"
h1 = "20000 W/m2/K"
p_ref = "0.2 MPa"
eta_ref = "1e3 Pa.s"
a = 1
b = 0.25
[glass]
material = "glass"
temperature = "1100 degC"
piece = [
  { name = "surface", condition = "contact", path = "(0, 0) (10, 0) (10, 10) (0, 10) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" } ]
[[tool]]
name = "pot"
material = "iron"
temperature = "480 degC"
friction = "stick"
piece = [
  { name = "inner", condition = "contact", path = "(12, 20) (12, 0) (0, 0) mm" },
  { name = "axis", condition = "symmetry", path = "(0, -8) mm" },
  { name = "outer", condition = "insulated", path = "(20, -8) (20, 20) (12, 20) mm" } ]
[[tool]]
name = "plunger"
material = "iron"
temperature = "480 degC"
friction = { law = "navier", coefficient = "1e5 Pa.s/m" }
piece = [
  { name = "face", condition = "contact", path = "(0, 10) (12, 10) mm" },
  { name = "outer", condition = "insulated", path = "(12, 20) (0, 20) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 10) mm" } ]
[numerics]
tool_contact_size = "1 mm"
skin_size = "0.6 mm"
motion_tolerance = "0.02 mm"
)";

}  // namespace parison::forming
