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
#include "thermal/heat_balance.hpp"
#include "thermal/problem.hpp"
#include "thermal/properties.hpp"
#include "thermal/radiation/light.hpp"

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

/// Unknown whose temperature is prescribed.
struct PrescribedUnknown {
  Index unknown;
  const core::TimeFunction* temperature;  ///< K, of a body of the problem
  Index boundary;                         ///< counted through all bodies
};

/// Semi-discrete heat equations of a problem on its meshes, in enthalpy form (Eyres et al. 1946):
///   d/dt content(T) = power(t, T),
/// content the integral of density times enthalpy times shape function, power the conduction, exchange, interface and
/// source terms. The unknowns T are the nodal temperatures (order 2) or the vertex temperatures (order 1), K, body
/// after body. The system has everything that depends neither on time nor on temperature.
struct HeatSystem {
  const Problem* problem;
  std::vector<Index> first_unknown;   ///< of each body; the last entry is the number of unknowns
  std::vector<Index> first_boundary;  ///< of each body, in the count through all bodies; the last entry is their number
  std::vector<BodyLaws> bodies;
  std::vector<std::array<Index, 6>> cells;  ///< unknowns of each cell; in a problem of order 1 only the first three
  std::vector<BatchIndices<6>> batches;     ///< the same for all bodies' batches of cells
  Eigen::VectorXd source;                   ///< power of the volume source into each unknown at a source factor of 1, W
  Eigen::VectorXd body_source;              ///< the same for each body, W
  std::vector<HeatEdge> edges;
  HeatInterface interface;
  std::vector<std::pair<Index, Index>> pairs;  ///< slave and master body of each pair of bodies in contact
  std::shared_ptr<const Enclosure> enclosure;  ///< null: surfaces do not see each other
  std::vector<Light> light;                    ///< of the bodies that have it
  std::vector<PrescribedUnknown> prescribed;
  std::vector<char> is_prescribed;  ///< by unknown

  Index size() const { return first_unknown.back(); }
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

/// Heat flows that the balance accumulates, W.
struct Flows {
  Eigen::VectorXd to_air, from_source;  ///< by body
  Eigen::VectorXd light_to_air;         ///< by body: the part of `to_air` that is light of a model with bands
  Eigen::VectorXd across, received;     ///< by pair: out of the slave's nodes, into the master's nodes
  Eigen::VectorXd radiated;             ///< by pair: the part of `across` that is light
  Eigen::VectorXd exchanged;            ///< to_air by boundary, counted through all bodies
  Eigen::VectorXd from_enclosure;       ///< by body: light from other surfaces, by which `to_air` is less
};
/// Terms of the heat equations at a time and temperatures.
struct Response {
  Eigen::VectorXd content;  ///< by unknown: integral of density times enthalpy times shape function, J; or its rate, W
  Eigen::VectorXd power;    ///< heat into each unknown by conduction, exchange, interface and source, W
  Flows flows;
};

/// Content and power at a time, s, and temperatures of the unknowns, K.
Response evaluate(const HeatSystem& system, double time, const Eigen::VectorXd& temperature);
/// Rate of the content, W, for a given rate of the temperatures, K/s, and power.
Response evaluate(const HeatSystem& system, double time, const Eigen::VectorXd& temperature,
                  const Eigen::VectorXd& rate);
/// The flows alone, without the loop over the cells.
Flows evaluate_flows(const HeatSystem& system, double time, const Eigen::VectorXd& temperature);

/// Sets the prescribed unknowns, K, to their values at a time; false where none changes.
bool impose_prescribed(const HeatSystem& system, double time, Eigen::VectorXd& temperature);
/// Sets the prescribed unknowns' rates, K/s, to those at a time.
void impose_prescribed_rate(const HeatSystem& system, double time, Eigen::VectorXd& rate);

/// A balance with the system's bodies and pairs and all entries zero.
HeatBalance zero_balance(const HeatSystem& system);
/// Accumulates flows that lasted `duration` seconds.
void accumulate(HeatBalance& balance, const Flows& flows, double duration);
/// Accumulates heat, J, that entered through a prescribed unknown.
void accumulate_prescribed(HeatBalance& balance, const HeatSystem& system, const PrescribedUnknown& at, double heat);
/// Takes the content change of a balance that has nothing else as heat through the prescribed boundaries: that of each
/// body as through its first one.
void accumulate_imposed(HeatBalance& balance, const HeatSystem& system);
/// Accumulates the change between two contents of the unknowns, J.
void accumulate_content(HeatBalance& balance, const HeatSystem& system, const Eigen::VectorXd& before,
                        const Eigen::VectorXd& after);

/// Unknowns of the nodes of a boundary edge, ordered as in HeatEdge.
std::array<Index, 3> edge_unknowns(const HeatSystem& system, Index body, const std::array<Index, 3>& nodes);
/// Body that an unknown belongs to.
Index body_of(const HeatSystem& system, Index unknown);
/// The unknowns of all bodies in one vector from the nodal temperatures of each body, and back, K.
Eigen::VectorXd join(const HeatSystem& system, const std::vector<Eigen::VectorXd>& temperature);
std::vector<Eigen::VectorXd> split(const HeatSystem& system, const Eigen::VectorXd& joined);

}  // namespace parison::thermal
