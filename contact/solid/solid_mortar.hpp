#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <functional>
#include <vector>

#include "core/solid/quad_face.hpp"
#include "core/solid/solid_interface.hpp"

namespace parison::contact {

/// The faces of a body that may touch.
struct SolidSurface {
  core::Index body;                          ///< its index in the heat problem
  const std::vector<core::Vector3>* nodes;   ///< m
  const std::vector<core::QuadFace>* faces;  ///< all of the body's
  std::vector<core::Index> touching;         ///< those that take part
};
/// All faces of some boundaries, by boundary_id; an empty list takes all.
SolidSurface solid_surface(core::Index body, const std::vector<core::Vector3>& nodes,
                           const std::vector<core::QuadFace>& faces, const std::vector<core::Index>& boundaries = {});

/// What the flow knows about a place of the slave against one master.
struct ContactState {
  double gap;                            ///< to the exact tool, m; negative inside; +infinity for no contact
  double pressure;                       ///< Pa
  double opening = 0, closing_rate = 0;  ///< as in core::SolidInterfacePoint
};
/// At (a, b) of a slave face, an index into all faces of the slave.
using ContactAt = std::function<ContactState(core::Index slave_face, const std::array<double, 2>& place)>;

/// A body that the slave may touch.
struct SolidMaster {
  SolidSurface surface;
  core::Index law;         ///< copied to the points
  double transition_gap;   ///< at which the contact weight has fallen to 0, m
  ContactAt contact = {};  ///< none: the gap is that between the meshes, the pressure zero
};

struct SolidMortarOptions {
  double reach = 2e-3;  ///< faces farther apart, m, do not meet
  int degree = 4;       ///< of the rule on each triangle of a segment, up to 6
};

/// Quadrature points of the virtual surface between a slave and all its masters, in space. Each pair of faces that
/// look at each other is cut in the mean plane of the slave's face: the master's outline clips the slave's, the
/// segment is divided into triangles, and each point is taken to both faces along the plane's normal. So flat faces
/// with straight edges exchange exactly what the meshes say, whichever is coarser. Where the slave's edges are bent its
/// points together have the face's exact area. Triangles in which the contact weight changes are split twice. A place
/// of the slave is paired with the nearest master only.
core::SolidInterface build_interface(const SolidSurface& slave, const std::vector<SolidMaster>& masters,
                                     const SolidMortarOptions& options = {});

}  // namespace parison::contact
