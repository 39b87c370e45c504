#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/linear/cholesky.hpp"
#include "core/mesh/element.hpp"
#include "thermal/cells/cell_batch.hpp"
#include "thermal/exchange.hpp"
#include "thermal/problem.hpp"
#include "thermal/properties.hpp"
#include "thermal/radiation/light.hpp"
#include "thermal/unknowns.hpp"

namespace parison::thermal {

/// Laws and cells of one body.
struct BodyLaws {
  Enthalpy enthalpy;
  Conductivity conductivity;
  Index first_cell, last_cell;  ///< range of HeatSystem::cells
  Index first_batch;            ///< of its batches in HeatSystem::batches
  std::shared_ptr<const std::vector<CellBatch>> cells;

  Index batch_count() const { return static_cast<Index>(cells->size()); }
};

/// Semi-discrete heat equations of a problem on its meshes, in enthalpy form (Eyres et al. 1946):
///   d/dt content(T) = power(t, T),
/// content the integral of density times enthalpy times shape function, power the conduction, exchange, interface and
/// source terms. The unknowns T are the nodal temperatures. The system has everything that depends neither on time nor
/// on temperature.
struct HeatSystem : HeatUnknowns {
  const Problem* problem;
  std::vector<BodyLaws> bodies;
  std::vector<std::array<Index, 6>> cells;  ///< unknowns of each cell
  std::vector<BatchIndices<6>> batches;     ///< the same for all bodies' batches of cells
  std::vector<HeatEdge> edges;
  HeatInterface interface;
  std::shared_ptr<const Enclosure> enclosure;  ///< null: surfaces do not see each other
  std::vector<Light> light;                    ///< of the bodies that have it
};
/// Geometry factors of a body's cells and the data they were computed from, for reuse while the mesh does not move, and
/// what its light keeps from mesh to mesh.
struct KeptCells {
  std::vector<core::Point> nodes, mass_nodes;
  std::vector<std::array<Index, 6>> cells;
  double density = 0;
  core::Geometry geometry;
  std::shared_ptr<const std::vector<CellBatch>> batches;
  std::shared_ptr<KeptLight> light;
  KeptTraces<TracedViews> views;  ///< of the enclosure of all bodies, with the first body
  Eigen::VectorXd mass_temperature;
};
/// Prepares the equations of a problem, which must outlive them. `kept`, by body, reuses what has not changed since the
/// last call; null computes all anew.
HeatSystem make_heat_system(const Problem& problem, std::vector<KeptCells>* kept = nullptr);
/// Why there are no equations to solve, a sentence; empty where there are.
inline std::string why_not_solvable(const HeatSystem& system) {
  return system.enclosure ? system.enclosure->traced->failure : std::string();
}
/// Where light was traced last for a system that was made with these.
TracedPlaces traced_places(const std::vector<KeptCells>& kept);

/// Content and power at a time, s, and temperatures of the unknowns, K.
Response evaluate(const HeatSystem& system, double time, const Eigen::VectorXd& temperature);
/// Rate of the content, W, for a given rate of the temperatures, K/s, and power.
Response evaluate(const HeatSystem& system, double time, const Eigen::VectorXd& temperature,
                  const Eigen::VectorXd& rate);
/// The flows alone, without the loop over the cells.
Flows evaluate_flows(const HeatSystem& system, double time, const Eigen::VectorXd& temperature);

/// Sets the prescribed unknowns' rates, K/s, to those at a time.
void impose_prescribed_rate(const HeatSystem& system, double time, Eigen::VectorXd& rate);

/// Unknowns of the nodes of a boundary edge, ordered as in HeatEdge.
std::array<Index, 3> edge_unknowns(const HeatSystem& system, Index body, const std::array<Index, 3>& nodes);
}  // namespace parison::thermal
