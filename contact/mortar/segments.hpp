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

/// A slave edge and what of the masters lies near it.
struct EdgeView {
  const RayEdge& slave;
  const std::vector<MasterEdge>& masters;
  const std::vector<Index>& near;  ///< into masters
  double range;                    ///< how far a master may lie along a ray, m
};

/// What a slave point sees.
struct VisibleEdge {
  Index edge;  ///< into EdgeView::masters
  Hit hit;
  bool alone;  ///< the ray meets no other edge near
};
/// The nearest edge, of all masters, that the slave point sees and that looks back at it.
std::optional<VisibleEdge> find_visible_master(const EdgeView& view, double s);

/// Node of the virtual surface, on a slave edge. The shape functions of both edges there follow
/// the two rules by themselves: at a node they are 1 for its own body's node.
struct InterfaceNode {
  double slave_s;
  int slave_node;  ///< 0, 1, 2 for first, last, mid; -1 where the node comes from a master
};
/// A node from the slave: slave temperature, pressure, viscosity and gap are its own; the master's temperature is
/// interpolated where its ray meets the master.
InterfaceNode node_from_slave(int node);
/// A node from a master: the master's temperature is its own; slave temperature, pressure and viscosity are
/// interpolated where a ray of the slave edge passes through it, and its gap is its distance along that ray. None where
/// no ray does.
std::optional<InterfaceNode> node_from_master(const EdgeView& view, const Point& node);
/// Replaces `nodes` by those of both kinds along a slave edge. Where two coincide, the one from the slave stays.
void find_interface_nodes(const EdgeView& view, std::vector<InterfaceNode>& nodes);

/// Stretch of a slave edge between neighbouring interface nodes, all of it facing one master edge.
struct Segment {
  InterfaceNode begin, end;
  Index edge;  ///< into EdgeView::masters
};
/// Replaces `segments` by those of a slave edge; stretches that face nothing are left out. Where one master's surface
/// comes before another's between two nodes, the segment is cut there.
void find_segments(const EdgeView& view, const std::vector<InterfaceNode>& nodes, std::vector<Segment>& segments);

}  // namespace parison::contact
