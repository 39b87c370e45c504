#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "contact/surface.hpp"
#include "core/interface.hpp"

namespace parison::contact {

/// What the slave's nodes know about one master, indexed like the slave's mesh.
struct SlaveState {
  Eigen::VectorXd gap;       ///< distance to the master's exact profile, m; +infinity where out of reach
  Eigen::VectorXd pressure;  ///< contact pressure, Pa
};

struct InterfaceOptions {
  core::Geometry geometry;
  double handover_width;  ///< gap over which the contact opens, m, positive
  Index law;              ///< handed on to the interface points
};

/// 1 for gap <= 0, 1 - u^3 (10 - 15 u + 6 u^2) with u = gap / width, 0 for gap >= width: two continuous derivatives,
/// and gaps below a fiftieth of the width change it by less than 1e-4.
double closure(double gap, double width);

/// The virtual surface between two bodies (physics.md, section 4): each slave edge cut at the projections of both
/// meshes' nodes, with Gauss points on each segment. Open stretches are left out; no slave area counts twice.
/// The gap is linear between a slave edge's three nodes; next to a node out of reach it follows the distance between
/// the meshes instead.
std::vector<core::InterfacePoint> build_interface(const Surface& slave, const Surface& master, const SlaveState& state,
                                                  const InterfaceOptions& options);

}  // namespace parison::contact
