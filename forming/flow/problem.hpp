#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "forming/flow/material.hpp"

namespace parison::flow {

using core::Index;
using core::Point;

/// What holds or loads a part of the glass boundary.
struct BoundaryCondition {
  enum class Kind { free, symmetry, fixed } kind = Kind::free;
  double pressure = 0;                          ///< over-pressure on free boundaries, Pa
  std::function<Point(const Point&)> velocity;  ///< at which a fixed boundary moves, m/s; none: it stands still
};

/// How a tool moves during the step.
struct ToolMotion {
  Friction friction;
  double velocity = 0;          ///< along the axis, m/s; ignored when force-driven
  std::optional<double> force;  ///< N along +axis: the velocity becomes an unknown
  double speed_limit = 0;       ///< m/s, of a force-driven tool
};

/// A glass node near a tool: n.(v - V) >= rate, with equality and a compressive reaction while active.
struct ContactCandidate {
  Index node;
  Index tool;                   ///< index into Problem::tools
  Point normal;                 ///< unit, from the tool into the glass
  double rate;                  ///< m/s: minus the gap over the step
  bool tied = false;            ///< holds in tension and sideways as well (grip)
  double contact_fraction = 1;  ///< of the step in which the node touches the tool: friction acts no longer than that
  Point approach_velocity = Point::Zero();  ///< velocity relative to the tool until it lands, m/s
};

/// One quasi-static flow problem: div(2 eta D(v)) - grad p + rho g = 0, div v = 0.
struct Problem {
  const core::Mesh* mesh;
  core::Geometry geometry;
  const Material* material;
  const Eigen::VectorXd* temperature;             ///< per node, K
  std::function<double(const Point&)> viscosity;  ///< Pa.s, in place of the material's where given
  std::function<Point(const Point&)> force;       ///< on the glass beside its weight, N/m3, where given
  std::vector<bool> frozen;                       ///< cells whose glass flows no more; empty where none
  double gravity = 0;                             ///< along the axis, m/s2
  double volume_rate = 0;  ///< div v everywhere, 1/s: takes back what the finite steps do to the volume
  /// By how much that rate is to change, 1/s, now that the velocities are known, and with them the dilatation: the
  /// velocities that change the volume everywhere at 1/s, leave the contacts closed and put no force on driven tools.
  /// By a little of them the motion is corrected; forces and pressures are those without any.
  std::function<double(const Eigen::VectorXd& velocity, const Eigen::VectorXd& dilatation_mode)> volume_correction;
  std::vector<BoundaryCondition> boundary_conditions;  ///< one for each mesh boundary
  std::vector<ToolMotion> tools;
  std::vector<ContactCandidate> candidates;
};

/// Corners of tools make the rate singular; what counts for a step is what a share of the volume sees.
inline constexpr double high_rate_fraction = 0.02;

struct Solution {
  bool converged = false;
  std::string reason;
  int iterations = 0;  ///< of the contact set, refinements included
  int factorisations = 0;
  int contact_changes = 0;            ///< contacts that an iteration closed or opened
  int locked = 0;                     ///< contacts that pull but stay closed, as they were released too often
  Eigen::VectorXd velocity;           ///< m/s, two per node
  Eigen::VectorXd pressure;           ///< Pa, per vertex
  Eigen::VectorXd contact_pressure;   ///< Pa, per node, 0 where nothing presses
  std::vector<bool> active;           ///< per candidate
  std::vector<double> tool_velocity;  ///< along the axis, m/s
  std::vector<double> tool_force;     ///< of the tool on the glass along the axis, N
  std::vector<double> dissipation;    ///< W at each quadrature point: cells x triangle_rule(4)
  double friction_power = 0;          ///< that the glass loses by sliding along tools, W
  double impact_power = 0;            ///< that it loses by coming to rest on tools before the step is over, W
  double correction_power = 0;        ///< that leading volume and penetrated nodes back takes, W
  Eigen::VectorXd dilatation_mode;  ///< m/s, two per node: see Problem::volume_correction; empty where it was not found
  std::vector<bool> exposed;  ///< per boundary edge: not wholly pressed, so that air and surface tension act on it
  double mean_rate = 0;       ///< root mean square of the rate of deformation over the volume, 1/s
  double high_rate = 0;       ///< rate of deformation sqrt(2 D:D) exceeded in `high_rate_fraction` of the volume, 1/s
};

inline Point node_velocity(const Eigen::VectorXd& velocity, Index node) {
  return velocity.segment<core::dim>(core::dim * node);
}

}  // namespace parison::flow
