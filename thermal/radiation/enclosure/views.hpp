#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "thermal/radiation/rays/light_resolution.hpp"
#include "thermal/radiation/rays/section.hpp"

namespace parison::thermal {

/// Edge of the section that bounds the air; seen from the air the body is behind it.
struct ViewEdge {
  SectionEdge points;  ///< the air on the left
  Index patch;         ///< -1: counts as surroundings
  double area;         ///< open to the air, m2; from an edge without any no light starts
};

/// Exchange areas of diffuse surfaces, A_i F_ij with the view factors F_ij, m2.
struct Views {
  Eigen::MatrixXd between;  ///< patches; symmetric
  Eigen::VectorXd open;     ///< of each with the surroundings
  Eigen::VectorXd lost;     ///< area of each whose rays began in the air and ended behind a surface; no view has it
};

/// Traces `rays` rays from each patch, straight through the air until they meet an edge. Rays that begin inside a body,
/// where bodies touch or overlap, are left out. One that begins in the air and ends behind a surface is lost: the
/// outline there is open, crosses itself or runs the wrong way round.
Views trace_views(const std::vector<ViewEdge>& edges, Geometry geometry, Index patches, int rays, RayPart part = {});

/// Views that are reciprocal and whose rows have the areas as sums, to round-off: between_ij d_i d_j, open_i d_i with
/// factors d near 1 (symmetric scaling, R. Sinkhorn, Ann. Math. Stat. 35 (1964) 876-879). A patch that sees less than
/// its area for any factors sees itself for the rest, as one in a slot does.
Views closed(Views views, const Eigen::ArrayXd& area);

}  // namespace parison::thermal
