#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::cooling {

/// Values at the points of triangle_rule(4), `components` each, carried to the nodes: at a vertex by the quadratic
/// function nearest to those of the cells around it and of their neighbours (O. C. Zienkiewicz, J. Z. Zhu, Int. J.
/// Numer. Meth. Engng 33 (1992) 1331-1364), at a mid-side node by those of its ends. The values are the straight parts
/// in each cell, as those of stress are: a quadratic course through a wall comes back exactly. `vertices`: flags of
/// those that are wanted, the others and the nodes beside them get zero; empty: all.
Eigen::VectorXd to_nodes(const core::Mesh& mesh, const Eigen::VectorXd& at_points, core::Index components,
                         const std::vector<bool>& vertices = {});

}  // namespace parison::cooling
