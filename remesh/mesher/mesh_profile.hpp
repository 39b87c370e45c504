#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/mesh/profile.hpp"
#include "remesh/sizing/size_field.hpp"

namespace parison::remesh {

/// Edge lengths for a body meshed from its profile.
struct ProfileSizes {
  double size;                           ///< largest edge, m
  double contact_size;                   ///< edge on the fine boundaries, m
  double growth;                         ///< increase of the edge per metre of distance from the fine boundaries
  std::vector<bool> fine_boundaries;     ///< one flag for each boundary of the profile
  std::vector<SizeSource> sources = {};  ///< wishes for smaller edges anywhere
  bool has_skin = false;                 ///< a thermal skin under its surface, in which the first cells are thinner
};

/// Quadratic mesh of a body, its boundary nodes on the exact lines and arcs. Throws core::RunError with the
/// mesher's sentence where the outline cannot be meshed.
core::Mesh mesh_profile(const core::Profile& profile, const ProfileSizes& sizes);

/// Mapped mesh of a body with exactly four boundaries: boundary 0 and the following ones in the direction of the
/// outline. A Coons patch (S. A. Coons 1967; W. J. Gordon, C. A. Hall, Numer. Math. 21 (1973) 109-129) of the exact
/// outline gives quadrilaterals, each cut into two triangles along its shorter diagonal. `along` is the number of
/// divisions of the first and the second boundary, `ratio` the length of the last division over that of the first; the
/// opposite boundaries have the same divisions. Throws std::invalid_argument for another number of boundaries.
core::Mesh mesh_mapped(const core::Profile& profile, core::Index along_first, core::Index along_second,
                       double ratio_first, double ratio_second);

}  // namespace parison::remesh
