#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "core/mesh.hpp"

namespace parison::remesh {

/// Where the nodes of a new mesh lie in the old one.
struct Transfer {
  std::vector<core::Index> cell;          ///< old cell of each new node
  std::vector<std::array<double, 2>> at;  ///< its reference coordinates there, inside or on the border
};
Transfer make_transfer(const core::Mesh& from, const core::Mesh& to);

/// Value of an old nodal field at the new nodes.
Eigen::VectorXd interpolate(const core::Mesh& from, const Transfer& transfer, const Eigen::VectorXd& nodal);

/// The same with the volume mean kept to round-off and no value beyond the old nodal extremes; of order 2, or 1: linear
/// between the vertices of the new mesh.
Eigen::VectorXd transfer_conserving(const core::Mesh& from, const core::Mesh& to, core::Geometry geometry,
                                    const Transfer& transfer, const Eigen::VectorXd& nodal, int order = 2);

/// Volume mean of a nodal field.
double mean(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& nodal);

}  // namespace parison::remesh
