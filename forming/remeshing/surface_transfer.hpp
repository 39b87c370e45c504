#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::forming {

/// Carries fields of the surface that may touch tools from a mesh to another one of the same glass, along the surface:
/// one number for each node, zero inside. No value leaves the range of the old ones along the edges of its node. The
/// new mesh must outlive this object.
class SurfaceTransfer {
 public:
  SurfaceTransfer(const core::Mesh& old, const core::Mesh& mesh, core::Geometry geometry);

  /// A nodal field of the old mesh on the new one by L2 projection, with its integral, within the range of the nodes
  /// along each edge, as far as the bounds allow: what a tool takes up is an integral over the surface. By
  /// interpolation the heat to tools changed by up to half a per cent where pressure or temperature vary within an
  /// edge.
  Eigen::VectorXd project(const Eigen::VectorXd& field) const;
  /// A quadratic field at the nearest point of the old surface: for one whose smallest values count most.
  Eigen::VectorXd interpolate(const Eigen::VectorXd& field) const;

 private:
  /// Quadrature point of a new edge and the nearest point of the old surface.
  struct Sample {
    std::size_t edge, old_edge;
    double old_s;
    std::array<double, 3> shape;  ///< quadratic shape functions of the new edge
    double area;                  ///< m2
  };

  /// Of a field of the new mesh along the surface, its unit times m2.
  double integral(const Eigen::VectorXd& field) const;

  const core::Mesh& mesh_;
  core::Geometry geometry_;
  std::vector<core::BoundaryEdge> old_edges_, edges_;
  std::vector<Sample> samples_;
};

}  // namespace parison::forming
