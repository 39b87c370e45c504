#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <vector>

#include "contact/mortar/projection.hpp"

namespace parison::contact {

/// An edge of one of the masters.
struct MasterEdge {
  SurfaceEdge edge;
  Index master;
};

/// A slave edge and the master edges near it.
struct EdgeView {
  const RayEdge& slave;
  const std::vector<MasterEdge>& masters;
  const std::vector<Index>& near;  ///< indices into `masters`
  double range;                    ///< largest distance of a master along a ray, m
};

/// The master edge that is visible from a slave point.
struct VisibleEdge {
  Index edge;  ///< index into EdgeView::masters
  Hit hit;
  bool alone;  ///< the ray meets no other edge in EdgeView::near
};
/// The nearest master edge on the ray from s whose outward normal opposes the ray.
std::optional<VisibleEdge> find_visible_master(const EdgeView& view, double s);

/// Node of the virtual surface on a slave edge: the projection of a node of either mesh (Gregoire et al. 2007). At the
/// projection of a mesh's node that mesh's shape function is 1, so its fields there are the nodal values.
struct InterfaceNode {
  double slave_s;
  int slave_node;  ///< 0, 1, 2 for first, last, mid; -1 where the node comes from a master
};
/// A node of the slave: it has its own temperature, pressure, viscosity and gap; the master's temperature is
/// interpolated where its ray meets the master.
InterfaceNode node_from_slave(int node);
/// The projection of a master's node: it has the master's nodal temperature; temperature, pressure and viscosity of the
/// slave are interpolated at the slave point whose ray passes through the node, and the gap is the distance along that
/// ray. None where no ray of the edge passes through the node.
std::optional<InterfaceNode> node_from_master(const EdgeView& view, const Point& node);
/// Replaces `nodes` by the nodes of both kinds along a slave edge, in order. Of two that coincide the one from the
/// slave is kept.
void find_interface_nodes(const EdgeView& view, std::vector<InterfaceNode>& nodes);

/// Part of a slave edge between neighbouring interface nodes from which one master edge is visible.
struct Segment {
  InterfaceNode begin, end;
  Index edge;  ///< index into EdgeView::masters
};
/// Replaces `segments` by those of a slave edge; parts from which no master is visible are left out. Where another
/// master's surface becomes the nearest one between two nodes, the segment is cut there.
void find_segments(const EdgeView& view, const std::vector<InterfaceNode>& nodes, std::vector<Segment>& segments);

}  // namespace parison::contact
