#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "forming/flow/air/trapped_air.hpp"
#include "forming/flow/material.hpp"

namespace parison::flow {

using core::Index;
using core::Point;

/// Condition on a boundary of the glass.
struct BoundaryCondition {
  enum class Kind { free, symmetry, fixed } kind = Kind::free;
  double pressure = 0;                          ///< gauge pressure of the gas on a free boundary, Pa
  std::function<Point(const Point&)> velocity;  ///< of a fixed boundary at a position, m/s; none: zero
};

/// Motion of a tool during the step: its velocity is given, or an unknown where its force is given.
struct ToolMotion {
  Friction friction;
  double velocity = 0;          ///< along the axis, m/s; ignored where a force is given
  std::optional<double> force;  ///< along +axis on the glass, N
  double speed_limit = 0;       ///< of a tool driven by force, m/s
};

/// A glass node that may touch a tool of velocity V (Signorini's condition on velocities): n.(v - V) >= rate, with
/// equality and a compressive force while the candidate is active, without force while it is not.
struct ContactCandidate {
  Index node;
  Index tool;                               ///< index into Problem::tools
  Point normal;                             ///< unit, from the tool into the glass
  double rate;                              ///< minus the gap over the time step, m/s
  bool tied = false;                        ///< always active, in tension as well (grip)
  double contact_fraction = 1;              ///< share of the step in which the node touches the tool and friction acts
  Point approach_velocity = Point::Zero();  ///< relative to the tool until the node lands, m/s
  double recovery = 0;                      ///< part of the rate that takes a penetrated node out of the tool, m/s
};

/// A symmetric tensor in the section: rr, zz, hoop, rz; in planar scenes xx, yy, normal to the section, xy.
using SectionTensor = std::array<double, 4>;

/// Glass with a memory over one step: its deviatoric stress at the end is `stress` + 2 `viscosity` dev D, with D the
/// mean rate of deformation, and div v = `expansion_rate` + (`pressure` - p)/`bulk`. Points: cells x cell_points.
struct StressMemory {
  std::vector<double> viscosity;       ///< secant of the step, at each point, Pa.s
  double bulk;                         ///< bulk modulus times the step, Pa.s
  std::vector<SectionTensor> stress;   ///< deviator that the stress before leaves, at each point, Pa
  Eigen::VectorXd pressure;            ///< at the start, at each vertex, Pa
  std::vector<double> expansion_rate;  ///< at each point, 1/s
};

/// Quasi-static creeping flow (Stokes): div(2 eta (D(v) - e/3 I)) - grad p + rho g + f = 0, div v = dilatation_rate +
/// e, with D the symmetric gradient, e the expansion rate, no inertia.
struct Problem {
  const core::Mesh* mesh;
  core::Geometry geometry;
  const Material* material;
  const Eigen::VectorXd* temperature;             ///< per node, K
  std::function<double(const Point&)> viscosity;  ///< Pa.s at a position; none: the material's
  std::function<Point(const Point&)> force;       ///< body force f at a position, N/m3; none: zero
  const StressMemory* memory = nullptr;           ///< in place of viscosity and expansion rate; null: none
  std::vector<bool> frozen;                       ///< per cell: solidified, with a raised viscosity; empty: no cell
  double gravity = 0;                             ///< along the axis, m/s2
  double dilatation_rate = 0;  ///< prescribed div v everywhere, 1/s: offsets the volume error of finite time steps
  /// div v by the change of density at each quadrature point (cells x cell_points), 1/s; empty: none. Unlike the one
  /// above it is physical: what hinders it makes stress.
  std::vector<double> expansion_rate;
  bool with_dilatation_mode = false;                   ///< whether Equilibrium::dilatation_mode is wanted
  std::vector<BoundaryCondition> boundary_conditions;  ///< one for each mesh boundary
  std::vector<ToolMotion> tools;
  std::vector<ContactCandidate> candidates;
  std::optional<TrappedAir> air;  ///< in sealed cavities; none: each is vented
};

inline Point node_velocity(const Eigen::VectorXd& velocity, Index node) {
  return velocity.segment<core::dim>(core::dim * node);
}

}  // namespace parison::flow
