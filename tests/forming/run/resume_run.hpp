#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// A case of two stages in a folder, and whether two runs have left the same results.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "../pot_scene.hpp"
#include "../scene_text.hpp"
#include "core/io/files.hpp"
#include "core/io/manifest.hpp"
#include "forming/run/run.hpp"

namespace parison::forming {

namespace fs = std::filesystem;

/// The pot, with remeshes in mid-stage, and a second stage without the plunger.
inline std::string two_stages() {
  std::string text = pot + "quality_floor = 0.6\n";
  text = replaced("output.interval = \"0.2 s\"", "output.interval = \"0.02 s\"\noutput.checkpoint_steps = 3", text);
  text = replaced("duration = \"0.4 s\"", "duration = \"0.1 s\"", text);
  return replaced(
      "[material.glass]",
      "[[stage]]\nname = \"rest\"\nduration = \"0.1 s\"\ngravity = \"-9.81 m/s2\"\ntools = [\"pot\"]\n[material.glass]",
      text);
}

class Resume : public ::testing::Test {
 protected:
  const fs::path folder = tests::absent_folder();
  Scene scene;

  void SetUp() override {
    fs::create_directories(folder);
    fs::permissions(folder, fs::perms::all);
    core::write_text(folder / "case.toml", two_stages());
    scene = read_scene(folder.string(), "draft");
  }
  void TearDown() override { fs::remove_all(folder); }
  std::string in(const std::string& name) const { return (folder / name).string(); }
};

/// Every file of a result folder by its name; the summary without what the clock says, checkpoints left out.
inline std::map<std::string, std::string> results(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder);
    if (!entry.is_regular_file() || entry.path().extension() == ".h5" || entry.path().filename() == core::manifest_name)
      continue;
    files[name] = core::read_text(entry.path());
    if (name == "summary.json")
      files[name] = std::regex_replace(
          files[name],
          std::regex("\"(wall_seconds|cpu_seconds|seconds|flow|heat|radiation|contact|remesh|output)\": [^\n]*\n"), "");
  }
  return files;
}

inline void expect_same_results(const std::string& folder, const std::string& reference) {
  const auto a = results(folder), b = results(reference);
  std::set<std::string> names;
  for (const auto* files : {&a, &b})
    for (const auto& [name, text] : *files) names.insert(name);
  EXPECT_GT(names.size(), 12u);
  for (const auto& name : names) EXPECT_TRUE(a.count(name) && b.count(name) && a.at(name) == b.at(name)) << name;
}

/// Asks to stop once, after `steps` steps from now.
inline StopRequest stop_after(int steps) {
  return [steps]() mutable { return --steps == 0; };
}

}  // namespace parison::forming
