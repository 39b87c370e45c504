#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "core/mesh/point.hpp"

namespace parison::core {

/// A quadrature point of the virtual surface between two bodies: both bodies' temperatures are
/// interpolated by `shape` from the three nodes of the edge that faces the point.
struct InterfacePoint {
  Index slave_body, master_body;
  std::array<Index, 3> slave_nodes,
      master_nodes;  ///< first, last, mid of the edge, in the numbering of its body's mesh
  std::array<double, 3> slave_shape, master_shape;
  Point position;           ///< on the slave side, m
  double area;              ///< quadrature weight times measure, m2
  double gap;               ///< distance between the surfaces, m; negative where they overlap
  double contact_weight;    ///< 1 where closed, falling smoothly to 0 where the gap exceeds the transition gap
  double pressure;          ///< contact pressure interpolated from the slave nodes, Pa
  Index law;                ///< which named interface
  double opening = 0;       ///< of the gap of a contact beyond that at first touch, m
  double closing_rate = 0;  ///< at which pressure and softness of the skin close it, 1/s
};

/// Conductance of the interface and its derivative with respect to the slave side's temperature.
struct Conductance {
  double h;      ///< W/m2/K
  double dh_dT;  ///< W/m2/K2
};

}  // namespace parison::core
