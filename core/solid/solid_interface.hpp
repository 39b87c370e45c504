#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "core/solid/hex_mesh.hpp"

namespace parison::core {

/// A face of one body that may meet a face of another: indices of bodies, and of faces in the list of each body.
struct FacePair {
  Index slave_body, slave_face, master_body, master_face;
  std::array<Index, 4> key() const { return {slave_body, slave_face, master_body, master_face}; }
};

/// A quadrature point of the virtual surface between two bodies in space.
struct SolidInterfacePoint {
  Index pair;                                       ///< index into SolidInterface::pairs
  std::array<double, 9> slave_shape, master_shape;  ///< weights of the nodes of the faces
  std::array<double, 2> slave_place;                ///< (a, b) of the slave's face
  Vector3 position;                                 ///< on the slave, m
  double area;                                      ///< quadrature weight times measure of the slave, m2
  double gap;                                       ///< m; negative where the bodies overlap
  double contact_weight;                            ///< 1 where closed, falling smoothly to 0
  double pressure;                                  ///< of the contact, Pa
  Index law;                                        ///< which named interface
  double opening = 0;                               ///< of the gap of a contact beyond that at first touch, m
  double closing_rate = 0;                          ///< at which pressure and softness of the skin close it, 1/s
};

/// The virtual surface between a slave and its masters. The points of a pair stand together, in the order of the pairs;
/// pairs that are near but not in contact have none.
struct SolidInterface {
  std::vector<FacePair> pairs;
  std::vector<SolidInterfacePoint> points;
};

}  // namespace parison::core
