#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/mesh/cell_batch.hpp"
#include "core/mesh/element.hpp"

namespace parison::thermal {

using core::batch_size;
using core::BatchIndices;
using core::cell_shapes;
using core::CellShapes;
using core::PointValues;
using core::UnknownValues;
using core::VectorizedArray;

/// Quadratic shape functions at the points of edge_rule(3), [point][node].
using EdgeShapes = std::array<std::array<double, 3>, 3>;
const EdgeShapes& edge_shapes();

/// Value at a point of an edge from its three unknowns.
inline double interpolate(const Eigen::VectorXd& values, const core::Index* unknowns,
                          const std::array<double, 3>& shape) {
  return shape[0] * values[unknowns[0]] + shape[1] * values[unknowns[1]] + shape[2] * values[unknowns[2]];
}

/// The part of the heat equations of a batch of cells that does not depend on temperature, at the points of
/// triangle_rule(4). Zero in the lanes that hold no cell of their own.
struct CellBatch {
  PointValues aa, ab, bb;  ///< metric of conduction: volume times grad a . grad a, grad a . grad b, grad b . grad b, m
  PointValues mass;        ///< kg
  PointValues thin_wall;   ///< factor on the Rosseland conductivity
};
struct BodyView;
/// The batches of a body's cells.
std::vector<CellBatch> make_batches(const BodyView& body, core::Geometry geometry);

}  // namespace parison::thermal
