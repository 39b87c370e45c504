#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/start_field.hpp"

namespace parison::forming {

/// What a body's temperatures at the start are by their place, in its own frame; empty where they are uniform or those
/// of another result. The scene must outlive it.
PlacedTemperature start_function(const Scene& scene, Index body);

/// Temperatures of a body at the nodes of its first mesh, K: uniform, with the skin of the glass, by a function of the
/// place, with its heat where the mesh is too coarse for it, or from another result, with the same heat in each
/// kilogram as there.
Eigen::VectorXd start_temperature(const Scene& scene, Index body, const core::Mesh& mesh);

}  // namespace parison::forming
