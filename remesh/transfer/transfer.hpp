#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <functional>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::remesh {

/// Positions of the nodes of a new mesh in the old mesh.
struct Transfer {
  std::vector<core::Index> cell;          ///< old cell of each new node
  std::vector<std::array<double, 2>> at;  ///< reference coordinates in that cell, inside or on the border
};
Transfer make_transfer(const core::Mesh& from, const core::Mesh& to);

/// Value of an old nodal field at the new nodes.
Eigen::VectorXd interpolate(const core::Mesh& from, const Transfer& transfer, const Eigen::VectorXd& nodal);

/// A projected field before its content is restored.
struct Carried {
  Eigen::VectorXd value;      ///< at the nodes
  Eigen::VectorXd low, high;  ///< bounds of each value, within the old nodal extremes
  double lowest, highest;     ///< old nodal extremes
};

/// L2 projection of the old field onto the quadratic functions of the new mesh. Each value is limited to the range of
/// the old cell it lies in, widened by half of that range on both sides. At the nodes of the new mesh in `is_given`,
/// empty for none, the value is that of `given` and no other; the rest is projected beside them.
Carried project(const core::Mesh& from, const core::Mesh& to, core::Geometry geometry, const Transfer& transfer,
                const Eigen::VectorXd& nodal, std::vector<bool> is_given = {}, const Eigen::VectorXd& given = {});

/// The conserved quantity of a field as a function of its nodal values.
using Content = std::function<double(const Eigen::VectorXd&)>;

/// The nodal field with the wanted content that is closest to the projected one: all values change by the same amount,
/// as far as their bounds allow.
Eigen::VectorXd restore_content(const Carried& carried, const Content& content, double target);

/// Projection and restored content in one, for a field whose volume mean is conserved.
Eigen::VectorXd transfer_conserving(const core::Mesh& from, const core::Mesh& to, core::Geometry geometry,
                                    const Transfer& transfer, const Eigen::VectorXd& nodal);

/// Volume mean of a nodal field.
double mean(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& nodal);

}  // namespace parison::remesh
