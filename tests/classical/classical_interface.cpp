// SPDX-License-Identifier: GPL-3.0-or-later
#include "classical/classical_interface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/mesh/element.hpp"

namespace parison::classical {

namespace {

using contact::Index;
using contact::Point;
using contact::SurfaceEdge;

struct SlaveNode {
  const SurfaceEdge* edge;  ///< one of those that share it
  int corner;               ///< its place in the edge: first, last, mid
  double area = 0;          ///< int N dA over all its edges, m2
};

std::map<Index, SlaveNode> lump_areas(const contact::Surface& slave, core::Geometry geometry) {
  std::map<Index, SlaveNode> nodes;
  for (const auto& edge : slave.edges)
    for (int i = 0; i < 3; ++i) {
      auto& node = nodes[edge.nodes[i]];
      node.edge = &edge;
      node.corner = i;
      for (const auto& at : core::edge_rule(5))
        node.area += at.weight * core::edge_shape(at.s)[i] * contact::derivative(edge, at.s).norm() *
                     core::depth(geometry, contact::position(edge, at.s));
    }
  return nodes;
}

/// Parameter of the point of an edge nearest to x: Newton from the chord's, kept on the edge.
double nearest_parameter(const SurfaceEdge& edge, const Point& x) {
  const Point chord = edge.x[1] - edge.x[0];
  double s = std::clamp((x - edge.x[0]).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
  for (int i = 0; i < 20; ++i) {
    const Point along = contact::derivative(edge, s);
    s = std::clamp(s + (x - contact::position(edge, s)).dot(along) / along.squaredNorm(), 0.0, 1.0);
  }
  return s;
}

}  // namespace

std::vector<core::InterfacePoint> classical_interface(const contact::Surface& slave, const contact::Surface& master,
                                                      core::Geometry geometry) {
  std::vector<core::InterfacePoint> points;
  for (const auto& [index, node] : lump_areas(slave, geometry)) {
    if (node.area <= 0) continue;  // the vertex on the axis
    core::InterfacePoint point{};
    point.slave_body = slave.body;
    point.master_body = master.body;
    point.slave_nodes = node.edge->nodes;
    point.slave_shape[node.corner] = 1;
    point.position = node.edge->x[node.corner];
    point.area = node.area;
    point.contact_weight = 1;
    point.gap = std::numeric_limits<double>::infinity();
    for (const auto& edge : master.edges) {
      const double s = nearest_parameter(edge, point.position);
      const double distance = (contact::position(edge, s) - point.position).norm();
      if (distance >= point.gap) continue;
      point.gap = distance;
      point.master_nodes = edge.nodes;
      point.master_shape = core::edge_shape(s);
    }
    points.push_back(point);
  }
  return points;
}

}  // namespace parison::classical
