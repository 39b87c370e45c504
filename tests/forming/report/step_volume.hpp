#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmsh.h>

#include <string>

namespace parison::forming {

/// The volume of the solids in a STEP file, m3.
inline double volume_of_step(const std::string& path) {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::vectorpair found;
  gmsh::model::occ::importShapes(path, found, true, "step");
  double sum = 0;
  for (const auto& [dimension, tag] : found) {
    double volume = 0;
    if (dimension == 3) gmsh::model::occ::getMass(3, tag, volume);
    sum += volume;
  }
  gmsh::finalize();
  return 1e-9 * sum;
}

}  // namespace parison::forming
