#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/case/case_error.hpp"
#include "forming/scene/scene.hpp"
#include "scene_parts.hpp"
#include "test_folder.hpp"

namespace parison::forming {

/// A small complete scene: a disc of glass on a plate, a plunger above it.
inline const std::string small_scene = R"(case = "small"
geometry = "axisymmetric"
[material.soft]
density = "2400 kg/m3"
heat_capacity = "1300 J/kg/K"
conductivity = "1.3 W/m/K"
viscosity = { law = "constant", value = "1e4 Pa.s" }
)" + iron + R"([glass]
material = "soft"
temperature = "1000 degC"
boundary = [
  { name = "surface", path = "(0, 0) (20, 0) (20, 10) (0, 10) mm", condition = "contact" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" },
]
[[tool]]
name = "plate"
material = "iron"
temperature = "400 degC"
friction = "stick"
boundary = [
  { name = "top", path = "(30, 0) (0, 0) mm", condition = "contact" },
  { name = "axis", path = "(0, -10) mm", condition = "symmetry" },
  { name = "rest", path = "(30, -10) mm", condition = "insulated" },
]
[[tool]]
name = "plunger"
material = "iron"
temperature = "400 degC"
friction = "slip"
position = "10 mm"
boundary = [
  { name = "face", path = "(0, 0) (15, 0) mm", condition = "contact" },
  { name = "rest", path = "(15, 20) (0, 20) mm", condition = "insulated" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" },
]
[[interface]]
tools = ["plate", "plunger"]
law = "constant"
h = "2000 W/m2/K"
[[stage]]
name = "rest"
duration = "1 s"
tools = ["plate"]
[[stage]]
name = "press"
duration = "2 s"
gravity = "-9.81 m/s2"
tools = ["plate", "plunger"]
motion.plunger = { force = "-5 N", speed_limit = "10 mm/s" }
pressure.surface = "0.1 bar"
[[probe]]
name = "centre"
body = "glass"
point = "(0, 5) mm"
)";

/// The small scene with one part of text replaced.
inline std::string replaced(const std::string& from, const std::string& to, const std::string& text = small_scene) {
  const auto at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return at == text.npos ? text : text.substr(0, at) + to + text.substr(at + from.size());
}

/// Writes a case into a folder of the running test.
inline std::string write_scene(const std::string& text) {
  const auto folder = tests::folder_of_test("scene");
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "case.toml") << text;
  return folder.string();
}

inline Scene scene_of(const std::string& text, const std::string& accuracy = "draft") {
  return read_scene(write_scene(text), accuracy);
}

/// What the reading of a scene complains about: "line: key: ...", or nothing.
inline std::string complaint_about(const std::string& text) {
  const auto folder = write_scene(text);
  try {
    read_scene(folder, "draft");
  } catch (const core::CaseError& error) {
    const std::string message = error.what();
    const auto file = folder + "/case.toml:";
    return message.rfind(file, 0) == 0 ? message.substr(file.size()) : message;
  }
  return "";
}

/// Line on which a part of text starts.
inline int line_of(const std::string& part, const std::string& text = small_scene) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(text.find(part)), '\n'));
}

}  // namespace parison::forming
