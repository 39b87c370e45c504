#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_parts.hpp"

namespace parison::forming {

/// A gob of glass, 10 mm radius and 10 mm high, pressed by a plunger into a pot of 12 mm radius: full at 6.944 mm.
inline const std::string pot = R"(# A gob pressed in a pot.
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
)" + container_glass("3 W/m/K") +
                               "emissivity = 0.89\n" + iron + pressed_contact(R"("pot", "plunger")") + R"([glass]
material = "glass"
temperature = "1100 degC"
boundary = [
  { name = "surface", condition = "contact", path = "(0, 0) (10, 0) (10, 10) (0, 10) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" } ]
[[tool]]
name = "pot"
material = "iron"
temperature = "480 degC"
friction = "stick"
boundary = [
  { name = "inner", condition = "contact", path = "(12, 20) (12, 0) (0, 0) mm" },
  { name = "axis", condition = "symmetry", path = "(0, -8) mm" },
  { name = "outer", condition = "insulated", path = "(20, -8) (20, 20) (12, 20) mm" } ]
[[tool]]
name = "plunger"
material = "iron"
temperature = "480 degC"
friction = { law = "navier", coefficient = "1e5 Pa.s/m" }
boundary = [
  { name = "face", condition = "contact", path = "(0, 10) (12, 10) mm" },
  { name = "outer", condition = "insulated", path = "(12, 20) (0, 20) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 10) mm" } ]
[numerics]
tool_contact_size = "1 mm"
skin_size = "0.6 mm"
motion_tolerance = "0.02 mm"
)";

}  // namespace parison::forming
