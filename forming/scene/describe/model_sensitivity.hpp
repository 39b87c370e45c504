#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// What container glass has where a scene names none of it, as the bundled jar: N/m, the emissivity, W/m2/K of the air.
struct ContainerGlass {
  double surface_tension = 0.315, emissivity = 0.89, air = 20;
  thermal::Radiation radiation{1.518, 150, true};
};

/// A part of the model, and what a scene's results would change without it, or with it where the scene leaves it out.
struct PartSensitivity {
  const char* name;
  bool in_scene;
  const char* number_name;  ///< of the number that carries the estimate
  double number;            ///< of this scene
  double thickness,
      heat;  ///< mean change of the wall thickness or shape, change of the heat into tools: shares, 1 at the most
  bool in_the_model = true;  ///< no case can have the others
};

/// For every part that the scene has the bodies for. Changes measured on the bundled jar grow in proportion to a
/// number: the strain of a stress in hot glass, heat between half-spaces, a Biot number and the time. Tools on both
/// sides of a wall hold it as the bundled tumbler's; glass that nothing forms changes its shape no more than it flows.
/// Good to a factor of five or so.
std::vector<PartSensitivity> model_sensitivity(const Scene& scene);

/// The same for the terminal, with a warning for each part left out that matters at the accuracy asked for.
std::string describe_sensitivity(const Scene& scene);

}  // namespace parison::forming
