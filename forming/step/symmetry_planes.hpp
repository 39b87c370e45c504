#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.hpp"

namespace parison::forming {

/// How far the furthest node of the glass lies beyond a plane of symmetry of its own, m; the axis is none.
double depth_beyond_symmetry_planes(core::Geometry geometry, const core::Mesh& mesh);

}  // namespace parison::forming
