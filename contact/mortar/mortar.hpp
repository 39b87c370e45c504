#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "contact/mortar/surface.hpp"
#include "core/mesh/interface_point.hpp"

namespace parison::contact {

/// A body that the slave may touch, and what the slave's nodes know about it.
struct Master {
  Surface surface;
  Eigen::VectorXd gap;    ///< of the slave mesh's nodes to the exact profile, m; +infinity where out of reach
  double transition_gap;  ///< gap over which the contact opens, m, positive; less than the reach
  Index law;              ///< handed on to the interface points
};

/// 1 for gap <= 0, 1 - u^3 (10 - 15 u + 6 u^2) with u = gap / width, 0 for gap >= width: two continuous derivatives,
/// and gaps below a fiftieth of the width change it by less than 1e-4.
double contact_weight(double gap, double width);

/// The virtual surface between the slave and all its masters: each slave edge cut at the
/// projections of both meshes' nodes, with Gauss points on each segment. Open stretches are left out. Every slave point
/// faces the nearest master only, so where masters overlap their union counts and no area counts twice.
/// The gap is linear between interface nodes: a node from the slave has its own, one from the master its distance from
/// the slave. On an edge that is closed at both ends it counts from the smooth surface that a convex slave's edges
/// belong to, so chords do not open.
/// `pressure` belongs to the nodes of the slave's mesh, Pa.
std::vector<core::InterfacePoint> build_interface(const Surface& slave, const Eigen::VectorXd& pressure,
                                                  const std::vector<Master>& masters, core::Geometry geometry);

}  // namespace parison::contact
