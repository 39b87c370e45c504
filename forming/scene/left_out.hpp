#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// A part of the model, and what a scene's results would change without it, or with it where the scene leaves it out.
struct PartEstimate {
  const char* name;
  bool in_scene;
  const char* number_name;   ///< of the dimensionless number that carries the estimate over from the jar
  double number;             ///< of this scene
  double thickness, heat;    ///< mean change of the wall thickness, change of the heat into tools: shares, 1 at the most
};

/// For every part that the scene has the bodies for. The changes measured on the bundled jar grow in proportion to the number;
/// where the scene names no constant of a part, that of container glass serves.
std::vector<PartEstimate> estimate_parts(const Scene& scene);

/// The same for the terminal, with a warning for each part left out that matters at the accuracy asked for.
std::string describe_parts(const Scene& scene);

}  // namespace parison::forming
