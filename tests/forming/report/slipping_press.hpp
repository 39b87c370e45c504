#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "../scene_text.hpp"

namespace parison::forming {

/// The disc pressed at 10 mm/s to half its height between plates without friction or heat.
inline const std::string slipping_press = [] {
  std::string text = replaced("heat_capacity = \"1300 J/kg/K\"\nconductivity = \"1.3 W/m/K\"\n", "");
  text = text.substr(0, text.find("[material.iron]")) + text.substr(text.find("[glass]"));
  text = text.substr(0, text.find("[[interface]]")) + R"([[stage]]
name = "press"
duration = "0.5 s"
tools = ["plate", "plunger"]
motion.plunger = { offset = [["0 s", "10 mm"], ["0.5 s", "5 mm"]] }
)";
  for (const char* gone : {"material = \"iron\"\ntemperature = \"400 degC\"\n",
                           "material = \"iron\"\ntemperature = \"400 degC\"\n", "temperature = \"1000 degC\"\n"})
    text = replaced(gone, "", text);
  text = replaced("friction = \"stick\"", "friction = \"slip\"", text);
  return replaced(
      "(0, 0) (15, 0) mm", "(0, 0) (60, 0) mm",
      replaced("(15, 20) (0, 20) mm", "(60, 20) (0, 20) mm",
               replaced("(30, 0) (0, 0) mm", "(60, 0) (0, 0) mm", replaced("(30, -10) mm", "(60, -10) mm", text))));
}();

}  // namespace parison::forming
