#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <vector>

#include "thermal/problem.hpp"

namespace parison::thermal {

struct HeatSystem;
struct Flows;
struct Linearisation;
struct StepMatrix;

/// Exchange of a boundary; null for none.
inline const SurfaceExchange* exchange_of(const std::vector<std::optional<SurfaceExchange>>& exchange, Index id) {
  return id < static_cast<Index>(exchange.size()) && exchange[id] ? &*exchange[id] : nullptr;
}
/// Exchange of all boundaries of a problem's bodies at a time, s; zero where a boundary has none. `first_boundary` as
/// in HeatUnknowns.
template <typename Bodies>
std::vector<ExchangeCoefficients> exchange_at(const Bodies& bodies, const std::vector<Index>& first_boundary,
                                              double time) {
  std::vector<ExchangeCoefficients> result;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (Index id = 0; id < first_boundary[b + 1] - first_boundary[b]; ++id) {
      const SurfaceExchange* exchange = exchange_of(bodies[b].exchange, id);
      result.push_back(exchange ? coefficients_at(*exchange, time) : ExchangeCoefficients{});
    }
  return result;
}

/// Boundary edge that exchanges heat with its surroundings.
struct HeatEdge {
  std::array<Index, 3> unknowns;  ///< of first, last and mid node
  Index boundary_edge;            ///< counted through all bodies
  Index boundary;                 ///< counted through all bodies
  Index body;
  std::array<double, 3> area;                  ///< at the points of edge_rule(3), m2
  std::array<std::array<double, 3>, 3> shape;  ///< weights of the unknowns there, [point][unknown]
};
/// Consecutive interface points between one slave edge and one master edge, which share their unknowns.
struct HeatSegment {
  std::array<Index, 6> unknowns;  ///< slave first, last, mid, then master; mids as in HeatEdge
  Index first_point, last_point;  ///< range of interface points, without the last
  Index slave_body, master_body;
  Index slave_boundary, master_boundary;  ///< counted through all bodies
  Index pair;                             ///< index into HeatSystem::pairs
};
/// The interface in contact: arrays over its points, segment after segment.
struct HeatInterface {
  std::vector<HeatSegment> segments;
  Eigen::Matrix<double, 6, Eigen::Dynamic> shape;  ///< weights of the segment's unknowns, one column for each point
  Eigen::ArrayXd area;                             ///< area in contact, m2
};
/// Derivatives of the heat flows at the interface points with respect to temperature, W/K.
struct ContactDerivatives {
  Eigen::ArrayXd across;                 ///< with respect to the temperature difference: conductance times area
  Eigen::ArrayXd conductance;            ///< with respect to the slave's temperature through the conductance alone
  Eigen::ArrayXd slave_air, master_air;  ///< of the exchange with the air that the contact replaces
};

/// Temperatures of both sides at the interface points, K.
struct SideTemperatures {
  Eigen::ArrayXd slave, master;
};
SideTemperatures side_temperatures(const HeatInterface& interface, const Eigen::VectorXd& temperature);

/// The boundary edge of each mid-side node, -1 elsewhere.
std::vector<Index> edges_of_mid_nodes(const core::Mesh& mesh);
/// Adds a body's edges that exchange heat with the air; `first_boundary_edge` counts those of the bodies before it.
void add_edges(HeatSystem& system, Index body, Index first_boundary_edge);
/// Prepares the interface of the system's problem.
void add_interface(HeatSystem& system);

/// Adds the exchange with the air and across the interface at a time, s, and temperatures, K, to the flows and, unless
/// null, to the power into each unknown, W.
void add_exchange(const HeatSystem& system, double time, const Eigen::VectorXd& temperature, Flows& flows,
                  Eigen::VectorXd* power);

/// Sets the derivatives of that exchange with respect to temperature.
void linearise_exchange(const HeatSystem& system, double time, const Eigen::VectorXd& temperature,
                        Linearisation& result);
/// Adds to `result`, J, the step, s, times the change of the heat flowing out by this exchange when the temperatures
/// change by `change`, K.
void apply_exchange(const HeatSystem& system, const Linearisation& linearisation, double step,
                    const Eigen::VectorXd& change, Eigen::VectorXd& result);

/// Adds the step times the symmetric positive part of these derivatives at a time and temperatures to the matrix.
void assemble_exchange(StepMatrix& matrix, const HeatSystem& system, double time, const Eigen::VectorXd& temperature,
                       double step);

}  // namespace parison::thermal
