#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh.hpp"

namespace parison::remesh {

/// int N_i T dV over the new mesh, T the old nodal field: exact overlay of the old and new triangles (cells clipped by
/// their chords, old boundary cells widened outward so that nothing is left out); each common part is integrated exactly
/// where both cells are straight.
Eigen::VectorXd overlay_load(const core::Mesh& from, const core::Mesh& to, core::Geometry geometry,
                             const Eigen::VectorXd& nodal);

}  // namespace parison::remesh
