#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <functional>
#include <vector>

#include "contact/solid/tool_surface.hpp"
#include "core/solid/hex_mesh.hpp"
#include "forming/flow/material.hpp"

namespace parison::flow {

using core::HexFace;
using core::HexMesh;
using core::Index;
using core::SymmetryPlane;
using core::Vector3;

/// Gas that presses on faces of the glass.
struct FacePressure {
  std::vector<HexFace> faces;
  double pressure = 0;  ///< gauge, Pa
};

/// A tool that moves without turning.
struct SolidTool {
  const contact::ToolSurface* surface;
  Vector3 offset = Vector3::Zero();    ///< of the tool from its surface as given, at the start of the step, m
  Vector3 velocity = Vector3::Zero();  ///< m/s
  Friction friction;
};

/// Gauss points along a side of a face.
inline constexpr int points_along = 3;
/// Points of a cell at which glass remembers its stress: those of core::hex_rule(points_along, points_along).
inline constexpr int memory_points = points_along * points_along * points_along;
/// Entries of a symmetric tensor: xx, yy, zz, yz, xz, xy.
inline constexpr int tensor_entries = 6;

/// A step of glass that remembers its stress, at each point of each cell.
struct SolidMemory {
  Eigen::VectorXd viscosity;       ///< secant of the step, Pa.s
  Eigen::VectorXd stress;          ///< deviator that the stress before leaves, tensor_entries for each point, Pa
  Eigen::VectorXd expansion_rate;  ///< 1/s
  double bulk = 0;                 ///< bulk modulus times the step, Pa.s
  double bedding = 0;              ///< pressure of a tool over the depth to which the glass rests in it, Pa/m
  double drag = 0;                 ///< on the glass, of each volume over its velocity, N.s/m4
};

/// Creeping flow of glass in space (Stokes): div(2 eta (D(v) - e/3 I)) - grad p + rho g = 0, div v = e, without
/// inertia.
struct SolidProblem {
  const Material* material;
  std::function<double(const Vector3&)> viscosity;  ///< Pa.s at a position; none: the material's by temperature
  const SolidMemory* memory = nullptr;              ///< in place of viscosity and incompressibility; null: none
  double gravity = 0;  ///< acceleration along the axis, m/s2: negative where it acts downwards
  std::vector<SymmetryPlane> planes;
  std::vector<Index> fixed;                  ///< nodes that move with a given velocity
  Vector3 fixed_velocity = Vector3::Zero();  ///< m/s
  std::vector<FacePressure> pressures;
  std::vector<HexFace> open_faces;     ///< with surface tension
  std::vector<HexFace> contact_faces;  ///< that may touch a tool
  std::vector<SolidTool> tools;
};

/// The square of the shear rate, 2 D:D, 1/s2, of a velocity with this gradient, 1/s.
inline double squared_shear_rate(const Eigen::Matrix3d& gradient) {
  return 0.5 * (gradient + gradient.transpose()).squaredNorm();
}

/// Points of each contact face: a Gauss rule of so many along either coordinate. The edge of contact lies between
/// points.
inline constexpr int contact_points_along = 4, contact_points_per_face = contact_points_along * contact_points_along;

/// Contact at a point of a face: index face * contact_points_per_face + point of core::map_hex_face.
struct SolidContact {
  Index tool = -1;      ///< the nearest; -1: none in reach
  double gap = 0;       ///< m, negative inside the tool
  double pressure = 0;  ///< on the glass, beyond that of the gas, Pa; negative only where a tool grips
  bool touches = false;
  bool released = false;  ///< pulled at the end of the step
};

/// Glass as a body in space at a moment.
struct SolidGlass {
  HexMesh mesh;
  Eigen::VectorXd temperature;            ///< at each node, K
  Eigen::VectorXd cell_mass;              ///< kg
  Eigen::VectorXd velocity;               ///< of the last step, 3 for each node, m/s; empty: none yet
  Eigen::VectorXd velocity_before;        ///< of the step before that, m/s; empty: none yet
  double last_step = 0, step_before = 0;  ///< their lengths, s; 0: none yet
  Eigen::VectorXd pressure;  ///< of the last step, Pa: 4 for each cell, of {1, x-1/2, y-1/2, z-1/2} in its cube
  std::vector<SolidContact> contact;  ///< of SolidProblem::contact_faces; empty: none yet
};

}  // namespace parison::flow
