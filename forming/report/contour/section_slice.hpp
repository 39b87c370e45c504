#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::forming {

/// Volume of a body beyond a coordinate along the axis, m3: above it where `up` is 1, below it where it is -1. Exact
/// for the quadratic edges of the mesh: by Green's theorem the volume is the integral of pi r^2 (planar: x times 1 m)
/// over the axial coordinate along the part of the outline that lies there.
double volume_beyond(const core::Mesh& mesh, core::Geometry geometry, double level, int up);

/// Where the outline crosses a coordinate along the axis: the other coordinate, rising, m.
std::vector<double> outline_crossings(const core::Mesh& mesh, double level);

}  // namespace parison::forming
