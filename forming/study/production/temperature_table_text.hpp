#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <string>

#include "core/mesh/mesh.hpp"

namespace parison::forming {

/// Nodal temperatures of a body, K, as a table of the form that a case reads: r_mm,z_mm,T_degC over a grid of some 400
/// places around the body. Bilinear between these it is the field by least squares; places beyond the body continue it
/// smoothly.
std::string temperature_table_text(const core::Mesh& mesh, const Eigen::VectorXd& temperature);

}  // namespace parison::forming
