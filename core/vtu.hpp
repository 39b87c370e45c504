#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/mesh.hpp"

namespace parison::core {

/// Values at the nodes of a mesh: one a node, or core::dim a node for a vector (written with three).
struct NodalField {
  std::string name;
  Eigen::VectorXd values;
};
/// One value for all cells.
struct CellConstant {
  std::string name;
  double value;
};

struct VtuFields {
  double time = 0;                          ///< s, written as TimeValue
  Point displacement = Point::Zero();       ///< added to the nodes, m
  std::vector<NodalField> nodal;
  std::vector<CellConstant> cell;
};

/// Writes quadratic triangles to a .vtu file: binary, values in single precision.
void write_vtu(const std::string& path, const Mesh& mesh, const VtuFields& fields);

}  // namespace parison::core
