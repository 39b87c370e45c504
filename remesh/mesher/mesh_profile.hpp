#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/mesh/profile.hpp"

namespace parison::remesh {

/// Edge lengths for a body meshed from its profile.
struct ProfileSizes {
  double size;                        ///< largest edge, m
  double contact_size;                ///< edge on the fine boundaries, m
  double growth;                      ///< of the edge per metre of distance from the fine boundaries
  std::vector<bool> fine_boundaries;  ///< one for each of the profile's boundaries
};

/// Quadratic mesh of a body, its boundary nodes on the exact lines and arcs. Throws core::RunError with the
/// mesher's sentence where the outline cannot be meshed.
core::Mesh mesh_profile(const core::Profile& profile, const ProfileSizes& sizes);

/// Mapped mesh of a body with exactly four boundaries, the first of them boundary 0 and the others as the outline is
/// walked: Coons map of the exact outline, each quadrilateral cut into two triangles along its shorter diagonal.
/// `along` counts the divisions of the first and second boundary, `ratio` is their last division over the first in the
/// direction of the boundary; the opposite boundaries follow.
core::Mesh mesh_mapped(const core::Profile& profile, core::Index along_first, core::Index along_second,
                       double ratio_first, double ratio_second);

}  // namespace parison::remesh
