#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
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
  Index boundary_edge;            ///< counted through all bodies
  Index body;
  SurfaceExchange exchange;
  std::array<double, 3> area;                  ///< at the points of edge_rule(3), m2
  std::array<std::array<double, 3>, 3> shape;  ///< weights of the unknowns there
};
/// Run of interface points with the same unknowns: a slave edge and a master edge that face each other.
struct HeatSegment {
  std::array<Index, 6> unknowns;  ///< slave first, last, mid, then master; mids as in HeatEdge
  Index first_point, last_point;
  Index slave_body, master_body;
  Index pair;  ///< index into HeatSystem::pairs
};
/// What one side of each point would give the air if its surface were free: linear T + quartic |T|^3 T - constant.
struct CoveredExchange {
  Eigen::ArrayXd linear, quartic, constant;  ///< W/K, W/K4, W

  /// At one point.
  double heat(Index i, double T) const { return (linear[i] + quartic[i] * T * T * std::abs(T)) * T - constant[i]; }
  Eigen::ArrayXd derivative(const Eigen::ArrayXd& T) const { return linear + 4 * quartic * T.square() * T.abs(); }
};
/// The closed interface: its points in arrays, segment after segment.
struct HeatInterface {
  std::vector<HeatSegment> segments;
  Eigen::Matrix<double, 6, Eigen::Dynamic> shape;  ///< weights of the unknowns, a column for each point
  Eigen::ArrayXd area;                             ///< of which is closed, m2
  CoveredExchange slave_air, master_air;           ///< the exchanges that the closed interface replaces
};
/// Slopes of the heat at the interface's points with temperature, W/K.
struct ContactDerivatives {
  Eigen::ArrayXd across;                 ///< by the temperature difference: conductance times closed area
  Eigen::ArrayXd conductance;            ///< by the slave's temperature through the conductance alone
  Eigen::ArrayXd slave_air, master_air;  ///< of the exchanges that the closed interface replaces
};

/// Temperatures of both sides at the interface's points, K.
struct SideTemperatures {
  Eigen::ArrayXd slave, master;
};
SideTemperatures side_temperatures(const HeatInterface& interface, const Eigen::VectorXd& temperature);

/// Finds a body's edges that exchange heat with air; `first_boundary_edge` counts those of the bodies before it.
void add_edges(HeatSystem& system, Index body, Index first_boundary_edge);
/// Prepares the interface of the system's problem.
void add_interface(HeatSystem& system);

/// Adds air exchange and interface to flows and, where given, to the power into each unknown.
void add_exchange(const HeatSystem& system, const Eigen::VectorXd& temperature, Flows& flows, Eigen::VectorXd* power);

/// Slopes of air exchange and interface at a temperature.
void linearise_exchange(const HeatSystem& system, const Eigen::VectorXd& temperature, Linearisation& result);
/// Adds step times what a change of the temperatures, K, does to the heat out by air exchange and interface.
void apply_exchange(const HeatSystem& system, const Linearisation& linearisation, double step,
                    const Eigen::VectorXd& change, Eigen::VectorXd& result);

/// Adds step times the symmetric, positive part of the slopes at a temperature to the matrix.
void assemble_exchange(StepMatrix& matrix, const HeatSystem& system, const Eigen::VectorXd& temperature, double step);

}  // namespace parison::thermal
