#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/wall_thickness.hpp"

namespace parison::remesh {

/// Thickness of the body at the surface nodes where it is a film between tools, m; infinite elsewhere. Both sides touch
/// (`contact`, per node; a symmetry boundary stands for its mirror image) and run parallel to within some degrees:
/// glass that tapers off where it meets a tool at a narrow angle is no film.
Eigen::VectorXd film_thickness(const core::Mesh& mesh, const remesh::Wall& wall,
                               const std::vector<bool>& symmetry_boundaries, const std::vector<bool>& contact);

/// Edge length in a film, m: four across up to a millimetre, above that fewer in proportion; no smaller than in a film
/// of the thickness `min_thickness`.
double film_size(double thickness, double thinnest);

}  // namespace parison::remesh
