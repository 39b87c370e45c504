#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"

namespace parison::tools {

/// What `command.txt` of a result folder says beyond the case: the words behind its options.
struct CaseCommand {
  std::string accuracy = "standard";
  std::vector<std::string> overrides;
};
CaseCommand read_command(const std::string& text);

/// The scene of a result folder, read again from the copy of its case, and what `parison check` says of it.
struct SceneOfRun {
  std::optional<forming::Scene> scene;
  std::string text;     ///< empty where the case could not be read
  std::string problem;  ///< why not, a sentence
};
SceneOfRun read_scene_of(const std::string& folder);

/// A text by which a changed case is told from the one before.
std::string stamp_of_case(const std::string& folder);

}  // namespace parison::tools
