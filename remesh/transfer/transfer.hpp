#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <functional>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::remesh {

/// Where the nodes of a new mesh lie in the old one.
struct Transfer {
  std::vector<core::Index> cell;          ///< old cell of each new node
  std::vector<std::array<double, 2>> at;  ///< its reference coordinates there, inside or on the border
};
Transfer make_transfer(const core::Mesh& from, const core::Mesh& to);

/// Value of an old nodal field at the new nodes.
Eigen::VectorXd interpolate(const core::Mesh& from, const Transfer& transfer, const Eigen::VectorXd& nodal);

/// A field carried over, before its content is restored.
struct Carried {
  Eigen::VectorXd value;      ///< at the nodes, or where the order is 1 at the vertices
  Eigen::VectorXd low, high;  ///< range that each value keeps: nowhere beyond the old nodal extremes
  double lowest, highest;     ///< old nodal extremes
};

/// The old field's best approximation in the mean square by quadratic functions (order 2), or linear ones between the
/// vertices (1), each value held within the range of the old cell it lies in.
Carried project(const core::Mesh& from, const core::Mesh& to, core::Geometry geometry, const Transfer& transfer,
                const Eigen::VectorXd& nodal, int order);

/// What of a field is to be kept, as a function of its nodal values.
using Content = std::function<double(const Eigen::VectorXd&)>;

/// The nodal field next to the carried one that has the wanted content: all values move by the same amount, as far as
/// their ranges let them.
Eigen::VectorXd restore_content(const core::Mesh& to, const Carried& carried, const Content& content, double target);

/// Both, with the volume mean kept.
Eigen::VectorXd transfer_conserving(const core::Mesh& from, const core::Mesh& to, core::Geometry geometry,
                                    const Transfer& transfer, const Eigen::VectorXd& nodal, int order = 2);

/// Volume mean of a nodal field.
double mean(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& nodal);

}  // namespace parison::remesh
