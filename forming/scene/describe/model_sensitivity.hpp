#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Values of container glass, as in the bundled jar, for parts that a scene neglects: N/m, the emissivity, W/m2/K.
struct ContainerGlass {
  double surface_tension = 0.315, emissivity = 0.89, air = 20;
  thermal::Radiation radiation{1.518, 150, true};
};

/// A part of the model, and how the results of a scene would change without it, or with it where the scene neglects it.
struct PartSensitivity {
  const char* name;
  bool in_scene;
  const char* number_name;  ///< of the number that scales the estimate
  double number;            ///< of this scene
  double thickness,
      heat;  ///< mean change of the wall thickness or shape, change of the heat into tools: shares, 1 at the most
  bool in_the_model = true;  ///< false: the program cannot compute it
};

/// For every part that applies to the bodies of the scene. The change measured on the bundled jar is scaled by the
/// ratio of one number: the strain that a stress causes in hot glass, the heat between half-spaces, or a Biot number
/// and the time. A wall with tools on both sides changes less, by a factor measured on the bundled tumbler; glass that
/// nothing forms changes its shape no more than it flows. Within a factor of five on the bundled cases and off by any
/// factor on others, so that only studies list these estimates beside what they measure.
std::vector<PartSensitivity> model_sensitivity(const Scene& scene);

/// The parts and their numbers for the terminal, with a warning where inertia may matter, which no run can measure.
std::string describe_sensitivity(const Scene& scene);

}  // namespace parison::forming
