#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>

#include "core/mesh/mesh.hpp"

namespace parison::forming {

/// Values of a nodal field with `components` numbers per node at points, one row a point; outside the mesh those of the
/// nearest point in it.
Eigen::MatrixXd sample(const core::Mesh& mesh, const Eigen::VectorXd& field, core::Index components,
                       const std::vector<core::Point>& points);
/// The same for a scalar field at one point; much faster for one than the other for many.
double sample(const core::Mesh& mesh, const Eigen::VectorXd& field, const core::Point& point);

}  // namespace parison::forming
