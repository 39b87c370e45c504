#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::flow {

using core::Index;
using core::Point;

/// Cells that are computed side by side, each in a lane; the last batch is filled up with repetitions of the last cell.
inline constexpr Index batch_size = 4;
using BatchArray = Eigen::Array<double, batch_size, 1>;

/// The same numbers as the processor works on them, four at once where it has AVX2: lane by lane the same operations,
/// so the same bits.
typedef double VectorizedArray __attribute__((vector_size(32), aligned(16), may_alias));
inline const VectorizedArray& vectorized(const BatchArray& x) {
  return *reinterpret_cast<const VectorizedArray*>(x.data());
}
inline VectorizedArray& vectorized(BatchArray& x) {
  return *reinterpret_cast<VectorizedArray*>(x.data());
}

/// Quadrature points of a cell: triangle_rule(4).
inline constexpr int cell_points = 6;

/// The mapped quadrature points of the cells, batch by batch.
struct CellGeometry {
  struct AtPoint {
    AtPoint() {}                                                // left unset: all of it is written once
    std::array<std::array<BatchArray, core::dim>, 6> gradient;  ///< of the shape functions, 1/m
    std::array<BatchArray, core::dim> position;                 ///< m
    BatchArray volume;                                          ///< m3
    BatchArray hoop;                                            ///< 1/r, or 0
  };
  Index cells = 0;
  std::vector<AtPoint> point;  ///< batches x cell_points

  Index batches() const { return (cells + batch_size - 1) / batch_size; }
  /// Cell in a lane of a batch.
  Index cell(Index batch, Index lane) const { return std::min(batch * batch_size + lane, cells - 1); }
  const AtPoint& at(Index batch, int q) const { return point[std::size_t(batch) * cell_points + q]; }
  Point position(Index cell, int q) const {
    const AtPoint& here = at(cell / batch_size, q);
    return {here.position[0][cell % batch_size], here.position[1][cell % batch_size]};
  }
};

CellGeometry cell_geometry(const core::Mesh& mesh, core::Geometry geometry);

/// Integral of the velocity over the volume of a mesh, m4/s.
Point integral(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& velocity);

/// Values of the six quadratic shape functions at each quadrature point.
const std::array<std::array<double, 6>, cell_points>& shapes_at_points();

/// Velocities at the six nodes of the cells of a batch, m/s.
using BatchVelocity = std::array<std::array<BatchArray, core::dim>, 6>;
BatchVelocity batch_velocity(const core::Mesh& mesh, const CellGeometry& geometry, Index batch,
                             const Eigen::VectorXd& velocity);

/// D:D at quadrature point q, 1/s2.
BatchArray squared_rate(const CellGeometry::AtPoint& at, int q, const BatchVelocity& velocity);

}  // namespace parison::flow
