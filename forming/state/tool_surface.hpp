#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Temperatures of a tool at one moment, K; the surface is that of its contact boundaries.
struct ToolTemperatures {
  double mean;                ///< over the volume
  double surface_mean;        ///< over the area
  double surface_max;         ///< of its nodes
  Point surface_max_at;       ///< in the tool's own frame, m
  double surface_area_above;  ///< hotter than a limit, m2
};

/// The hottest node of the contact boundaries; temperature NaN without heat or without such a boundary.
struct HottestPoint {
  double temperature;  ///< K
  Point at;            ///< in the frame of the case, m
};
HottestPoint hottest_surface_point(const ToolState& tool);

/// The weights with which nodal temperatures of a tool become means. A tool keeps its mesh, so they are made once.
class ToolSurface {
 public:
  ToolSurface(const core::Mesh& mesh, core::Geometry geometry);

  /// All NaN, the area 0, where the tool carries no heat.
  ToolTemperatures temperatures(const ToolState& tool, double limit) const;

 private:
  /// Half an edge of a contact boundary, straight, with its area, m2.
  struct HalfEdge {
    Index first, last;
    double area;
  };

  Eigen::VectorXd volume_;  ///< of each node, m3
  Eigen::VectorXd area_;    ///< of each node, of contact boundaries, m2
  std::vector<HalfEdge> halves_;
};

}  // namespace parison::forming
