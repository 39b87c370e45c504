#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/wall_thickness.hpp"

namespace parison::remesh {

/// Thickness of the body at the surface nodes where it is a film between tools, m; infinite elsewhere. Both sides of a
/// film touch a tool (`contact`, one flag for each node; a symmetry boundary represents its mirror image), and their
/// outward normals are opposite to within 18 degrees, which excludes glass that tapers off at a tool.
Eigen::VectorXd film_thickness(const core::Mesh& mesh, const remesh::Wall& wall, const std::vector<bool>& contact);

/// The same between different tools: `contact_tool` is the tool that each node touches, -1 for none. Glass in a slot of
/// a single tool is no film, because nothing presses it thinner.
Eigen::VectorXd film_between_tools(const core::Mesh& mesh, const remesh::Wall& wall,
                                   const std::vector<Index>& contact_tool);

/// Edge length in a film, m: a quarter of its thickness up to 10/3 of the smallest thickness; above that the number of
/// elements across falls in inverse proportion to the thickness. Films thinner than `min_thickness` have the edge
/// length of that thickness.
double film_size(double thickness, double min_thickness);

}  // namespace parison::remesh
