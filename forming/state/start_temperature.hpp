#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Temperatures of a body at the nodes of its first mesh, K: uniform, with the skin of the glass, by a function of the
/// place, or from another result, with the same heat in each kilogram as there.
Eigen::VectorXd start_temperature(const Scene& scene, Index body, const core::Mesh& mesh);

}  // namespace parison::forming
