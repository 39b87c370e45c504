#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "core/linear/cholesky.hpp"
#include "core/mesh/element.hpp"
#include "thermal/cells/cell_batch.hpp"
#include "thermal/exchange.hpp"
#include "thermal/heat_balance.hpp"
#include "thermal/problem.hpp"
#include "thermal/properties.hpp"

namespace parison::thermal {

struct BodyLaws {
  Enthalpy enthalpy;
  Conductivity conductivity;
  Index first_cell, last_cell;  ///< range of HeatSystem::cells
  Index first_batch;            ///< its cells in HeatSystem::groups, from there on
  std::shared_ptr<const std::vector<CellBatch>> cells;

  Index batch_count() const { return static_cast<Index>(cells->size()); }
};

/// A heat problem with the meshes where they are: everything but the temperature. The unknowns are the
/// temperatures of the nodes, or of the vertices in a problem of order 1, of body after body.
struct HeatSystem {
  const Problem* problem;
  std::vector<Index> first_unknown;  ///< of each body; the last entry is the number of unknowns
  std::vector<BodyLaws> bodies;
  std::vector<std::array<Index, 6>> cells;  ///< their unknowns; the first three alone in a problem of order 1
  std::vector<BatchIndices<6>> batches;     ///< the same batch by batch
  Eigen::VectorXd source;                   ///< of volume into each unknown, W
  Eigen::VectorXd body_source;              ///< of volume in each body, W
  std::vector<HeatEdge> edges;
  HeatInterface interface;
  std::vector<std::pair<Index, Index>> pairs;        ///< slave and master body
  std::vector<std::pair<Index, double>> prescribed;  ///< unknown and its temperature, K
  std::vector<char> is_prescribed;

  Index size() const { return first_unknown.back(); }
};
/// Cells of a body whose mesh stands still, and what they were made of.
struct KeptCells {
  std::vector<core::Point> nodes, mass_nodes;
  std::vector<std::array<Index, 6>> cells;
  double density = 0;
  core::Geometry geometry;
  std::shared_ptr<const std::vector<CellBatch>> batches;
};
/// `kept`, by body, spares what has not changed since the last call with it.
HeatSystem make_heat_system(const Problem& problem, std::vector<KeptCells>* kept = nullptr);

/// Heat flows of the balance's entries, W: to air by body, from source by body, and by pair what the interface takes
/// from the slave's nodes and what it gives to the master's.
struct Flows {
  Eigen::VectorXd to_air, from_source, across, received;
};
/// What the equations say at a temperature.
struct Response {
  Eigen::VectorXd content;  ///< integral of density times enthalpy times shape function, J; or its rate, W
  Eigen::VectorXd power;    ///< heat into each unknown by conduction, exchange, interface and source, W
  Flows flows;
};

/// Content and power at the given temperatures.
Response evaluate(const HeatSystem& system, const Eigen::VectorXd& temperature);
/// The same with the rate of the content for a given rate of temperature, K/s.
Response evaluate(const HeatSystem& system, const Eigen::VectorXd& temperature, const Eigen::VectorXd& rate);
/// Flows alone: no loop over the cells.
Flows evaluate_flows(const HeatSystem& system, const Eigen::VectorXd& temperature);

/// Balance with its bodies and pairs named and every entry zero.
HeatBalance zero_balance(const HeatSystem& system);
/// Accumulates flows that lasted `duration` seconds.
void accumulate(HeatBalance& balance, const Flows& flows, double duration);
/// Accumulates the content change between two vectors of nodal content.
void accumulate_content(HeatBalance& balance, const HeatSystem& system, const Eigen::VectorXd& before,
                        const Eigen::VectorXd& after);

/// Unknowns of the nodes of a boundary edge, as HeatEdge names them.
std::array<Index, 3> edge_unknowns(const HeatSystem& system, Index body, const std::array<Index, 3>& nodes);
/// Body that an unknown belongs to.
Index body_of(const HeatSystem& system, Index unknown);
/// One vector of the unknowns of all bodies from their nodal temperatures, and back.
Eigen::VectorXd join(const HeatSystem& system, const std::vector<Eigen::VectorXd>& temperature);
std::vector<Eigen::VectorXd> split(const HeatSystem& system, const Eigen::VectorXd& joined);

}  // namespace parison::thermal
