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
inline constexpr Index lanes = 4;
using Lanes = Eigen::Array<double, lanes, 1>;

/// The same numbers as the processor works on them, four at once where it has AVX2: lane by lane the same operations,
/// so the same bits.
typedef double Pack __attribute__((vector_size(32), aligned(16), may_alias));
inline const Pack& packed_lanes(const Lanes& x) {
  return *reinterpret_cast<const Pack*>(x.data());
}
inline Pack& packed_lanes(Lanes& x) {
  return *reinterpret_cast<Pack*>(x.data());
}

/// Quadrature points of a cell: triangle_rule(4).
inline constexpr int cell_points = 6;

/// The mapped quadrature points of the cells, batch by batch.
struct CellGeometry {
  struct AtPoint {
    AtPoint() {}                                           // left unset: all of it is written once
    std::array<std::array<Lanes, core::dim>, 6> gradient;  ///< of the shape functions, 1/m
    std::array<Lanes, core::dim> position;                 ///< m
    Lanes volume;                                          ///< m3
    Lanes hoop;                                            ///< 1/r, or 0
  };
  Index cells = 0;
  std::vector<AtPoint> point;  ///< batches x cell_points

  Index batches() const { return (cells + lanes - 1) / lanes; }
  /// Cell in a lane of a batch.
  Index cell(Index batch, Index lane) const { return std::min(batch * lanes + lane, cells - 1); }
  const AtPoint& at(Index batch, int q) const { return point[std::size_t(batch) * cell_points + q]; }
  Point position(Index cell, int q) const {
    const AtPoint& here = at(cell / lanes, q);
    return {here.position[0][cell % lanes], here.position[1][cell % lanes]};
  }
};

CellGeometry cell_geometry(const core::Mesh& mesh, core::Geometry geometry);

/// Integral of the velocity over the volume of a mesh, m4/s.
Point integral(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& velocity);

/// Values of the six quadratic shape functions at each quadrature point.
const std::array<std::array<double, 6>, cell_points>& shapes_at_points();

/// Velocities at the six nodes of the cells of a batch, m/s.
using BatchVelocity = std::array<std::array<Lanes, core::dim>, 6>;
BatchVelocity batch_velocity(const core::Mesh& mesh, const CellGeometry& geometry, Index batch,
                             const Eigen::VectorXd& velocity);

/// D:D at quadrature point q, 1/s2.
Lanes squared_rate(const CellGeometry::AtPoint& at, int q, const BatchVelocity& velocity);

}  // namespace parison::flow
