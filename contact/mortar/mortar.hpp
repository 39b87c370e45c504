#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <functional>
#include <vector>

#include "contact/mortar/surface.hpp"
#include "core/mesh/interface_point.hpp"

namespace parison::contact {

/// A body that the slave may touch, with the slave's gaps to it.
struct Master {
  Surface surface;
  Eigen::VectorXd gap;    ///< from each node of the slave's mesh to the exact profile, m; +infinity out of reach
  double transition_gap;  ///< gap at which the contact weight has fallen to 0, m; positive, less than the reach
  Index law;              ///< copied to the interface points
  /// Gap of any point to the exact profile, m; +infinity out of reach. Without it the gap between two slave nodes is
  /// known only by the master's mesh.
  std::function<double(const Point&)> gap_at{};
  /// Which nodes of the slave's mesh are held by this body; empty where that is not known.
  std::vector<bool> touching{};
};

/// Share of the contact at a point: 1 for gap <= 0, 1 - u^3 (10 - 15 u + 6 u^2) with u = gap / width, 0 for gap >=
/// width. It has two continuous derivatives; gaps below a fiftieth of the width lower it by less than 1e-4.
double contact_weight(double gap, double width);

/// Quadrature points of the virtual surface between the slave and all its masters (interface element of S. Gregoire,
/// J. Cesar de Sa, P. Moreau, D. Lochegnies, Comput. Struct. 85 (2007) 1194-1205). Each slave edge is divided into
/// segments at the projections of the nodes of both meshes, as in segment-based mortar methods (C. Bernardi, Y. Maday,
/// A. T. Patera 1994; B. Yang, T. A. Laursen, X. Meng, Int. J. Numer. Meth. Engng 62 (2005) 1183-1225), and every
/// segment has Gauss points. There is no multiplier: a conductance couples the two temperatures at each point. Points
/// without contact are left out. A slave point is paired with the nearest master only, so no area counts twice where
/// masters overlap. The gap is linear between interface nodes: a node from the slave has its own gap, any other that of
/// `gap_at` or else its distance to the master along the ray. Where the contact weight changes, segments are halved
/// until the gap in their middle is the mean of their ends to half a per cent of the transition gap. On an edge in
/// contact at both ends the gap is measured from the smooth convex surface that the edge approximates, so that chords
/// of a curved surface do not count as open. Where `touching` is known, the edge at the end of a contact has the gap of
/// a surface that leaves the tool without a kink (ContactEnd). `pressure` has one value for each node of the slave's
/// mesh, Pa.
std::vector<core::InterfacePoint> build_interface(const Surface& slave, const Eigen::VectorXd& pressure,
                                                  const std::vector<Master>& masters, core::Geometry geometry);

}  // namespace parison::contact
