// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "forming/scene/scene_reading.hpp"

namespace parison::forming {
namespace {

void coarsen(MeshSpec& mesh, double factor) {
  if (mesh.size) *mesh.size *= factor;
  if (mesh.contact_size) *mesh.contact_size *= factor;
  if (!mesh.mapped) return;
  for (Index* divisions : {&mesh.mapped->along_first, &mesh.mapped->along_second})
    *divisions = std::max(Index{1}, static_cast<Index>(std::lround(*divisions / factor)));
}

}  // namespace

void coarsen(Scene& scene, double factor) {
  scene.accuracy = coarsened(scene.accuracy, factor);
  coarsen(scene.glass.mesh, factor);
  for (Tool& tool : scene.tools) coarsen(tool.mesh, factor);
}

}  // namespace parison::forming
