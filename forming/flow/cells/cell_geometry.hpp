#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/mesh/cell_batch.hpp"

namespace parison::flow {

using core::Index;
using core::Point;

using core::batch_size;
using core::cell_points;
using core::VectorizedArray;

/// The mapped quadrature points of the cells, batch by batch.
struct CellGeometry {
  struct AtPoint {
    AtPoint() {}                                                     // left unset: all of it is written once
    std::array<std::array<VectorizedArray, core::dim>, 6> gradient;  ///< of the shape functions, 1/m, [node][component]
    std::array<VectorizedArray, core::dim> position;                 ///< m
    VectorizedArray volume;                                          ///< quadrature weight times the measure, m3
    VectorizedArray hoop;                                            ///< 1/r, or 0 in planar scenes
  };
  Index cells = 0;
  std::vector<AtPoint> point;  ///< batches x cell_points

  Index batches() const { return core::batch_count(cells); }
  /// Cell in a lane of a batch.
  Index cell(Index batch, int lane) const { return core::cell_in_lane(cells, batch, lane); }
  const AtPoint& at(Index batch, int q) const { return point[std::size_t(batch) * cell_points + q]; }
  Point position(Index cell, int q) const {
    const AtPoint& here = at(cell / batch_size, q);
    return {here.position[0][cell % batch_size], here.position[1][cell % batch_size]};
  }
};

CellGeometry cell_geometry(const core::Mesh& mesh, core::Geometry geometry);

/// Integral of the velocity over the volume of a mesh, m4/s.
Point integral(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& velocity);

/// Velocities at the six nodes of the cells of a batch, m/s.
core::NodeVectors batch_velocity(const core::Mesh& mesh, Index batch, const Eigen::VectorXd& velocity);

/// D:D at quadrature point q, 1/s2, D the rate of deformation.
void set_squared_rate(const CellGeometry::AtPoint& at, int q, const core::NodeVectors& velocity,
                      VectorizedArray& squared);

}  // namespace parison::flow
