#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "core/element.hpp"

namespace parison::thermal {

/// Shape functions at the points of triangle_rule(4) and edge_rule(3), [point][node].
using CellShapes = std::array<std::array<double, 6>, 6>;
using EdgeShapes = std::array<std::array<double, 3>, 3>;
const CellShapes& cell_shapes();
const EdgeShapes& edge_shapes();

/// Value at a point of an edge from its three unknowns.
inline double interpolate(const Eigen::VectorXd& values, const core::Index* unknowns,
                          const std::array<double, 3>& shape) {
  return shape[0] * values[unknowns[0]] + shape[1] * values[unknowns[1]] + shape[2] * values[unknowns[2]];
}

}  // namespace parison::thermal
