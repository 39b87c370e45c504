#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <optional>
#include <vector>

#include "core/mesh/interface_point.hpp"
#include "core/mesh/mesh.hpp"
#include "thermal/properties.hpp"

namespace parison::thermal {

using core::Index;

/// One body in a heat problem; everything pointed to outlives the problem. The mass of a material point is that of
/// `mass_mesh` and stays while `mesh` moves, so heat content does not change by motion.
struct BodyView {
  const core::Mesh* mesh;       ///< present positions: conduction and surfaces
  const core::Mesh* mass_mesh;  ///< positions in which the mass was last distributed; same topology
  double density;               ///< of mass_mesh, kg/m3
  const Material* material;
  std::vector<std::optional<SurfaceExchange>> exchange;  ///< one per boundary of the mesh; empty: none anywhere
  std::vector<std::optional<double>> prescribed;         ///< given temperature per boundary, K; empty: none anywhere
  const Eigen::VectorXd* wall_thickness = nullptr;       ///< per node, m; null: no thin-wall limit
  const std::vector<double>* source = nullptr;  ///< W at each point of triangle_rule(4), cell by cell; null: none
};

/// Whether its walls limit the radiation inside.
inline bool has_thin_wall(const BodyView& body) {
  return body.wall_thickness && body.material->radiation;
}

/// Conductances, W/m2/K, of an interface's points at the slave's temperatures there, K, and, where asked for, their
/// derivatives with respect to those.
using InterfaceLaw = std::function<void(const std::vector<core::InterfacePoint>& points,
                                        const Eigen::ArrayXd& temperature, Eigen::ArrayXd& h, Eigen::ArrayXd* dh_dT)>;

/// Heat in all bodies. Where the interface is closed, its conductance replaces both sides' own exchange.
struct Problem {
  core::Geometry geometry;
  std::vector<BodyView> bodies;
  std::vector<core::InterfacePoint> interface;  ///< slave_body and master_body index `bodies`
  InterfaceLaw law;
  int order = 2;  ///< of the temperature in a cell: 2, or 1: the temperature of a mid-side node is the mean of its ends
};

/// Heat content of a body relative to `content_reference`, J; temperature in K at the nodes.
double heat_content(const BodyView& body, core::Geometry geometry, const Eigen::VectorXd& temperature);

}  // namespace parison::thermal
