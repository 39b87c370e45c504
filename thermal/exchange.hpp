#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>
#include <vector>

#include "thermal/problem.hpp"

namespace parison::thermal {

struct HeatSystem;
struct Flows;
struct Linearisation;
struct StepMatrix;

/// Boundary edge that exchanges heat with its surroundings.
struct HeatEdge {
  std::array<Index, 3> unknowns;  ///< first, last, mid; in a problem of order 1 the first again, of weight nothing
  Index boundary_edge;  ///< counted through all bodies
  Index body;
  SurfaceExchange exchange;
  std::array<double, 3> area;  ///< at the points of edge_rule(3), m2
  std::array<std::array<double, 3>, 3> shape;  ///< weights of the unknowns there
};
/// Interface point with both sides' unknowns; the exchanges are those that the closed interface replaces.
struct HeatContact {
  std::array<Index, 6> unknowns;  ///< slave first, last, mid, then master; mids as in HeatEdge
  std::array<double, 3> slave_shape, master_shape;  ///< weights of the unknowns
  const core::InterfacePoint* point;
  Index pair;  ///< index into HeatSystem::pairs
  std::optional<SurfaceExchange> slave_air, master_air;
};
/// Slopes of the heat across an interface point with temperature, W/K.
struct ContactSlopes {
  double across;        ///< by the temperature difference: conductance times closed area
  double conductance;   ///< by the slave's temperature through the conductance alone
  double slave_air, master_air;  ///< of the exchanges that the closed interface replaces
};

/// Finds a body's edges that exchange heat with air; `first_boundary_edge` counts those of the bodies before it.
void add_edges(HeatSystem& system, Index body, Index first_boundary_edge);
/// Prepares the interface of the system's problem.
void add_contacts(HeatSystem& system);

/// Adds air exchange and interface to flows and, where given, to the power into each unknown.
void add_exchange(const HeatSystem& system, const Eigen::VectorXd& temperature, Flows& flows, Eigen::VectorXd* power);

/// Slopes of air exchange and interface at a temperature.
void linearise_exchange(const HeatSystem& system, const Eigen::VectorXd& temperature, Linearisation& result);
/// Adds step times what a change of the temperatures, K, does to the heat out by air exchange and interface.
void apply_exchange(const HeatSystem& system, const Linearisation& linearisation, double step,
                    const Eigen::VectorXd& change, Eigen::VectorXd& result);

/// Adds step times the symmetric, positive part of those slopes to the matrix.
void assemble_exchange(StepMatrix& matrix, const HeatSystem& system, const Linearisation& slopes, double step);

}  // namespace parison::thermal
