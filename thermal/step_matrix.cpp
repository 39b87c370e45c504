// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/step_matrix.hpp"

#include <algorithm>

#include "thermal/cell_kernels.hpp"
#include "thermal/elimination.hpp"

namespace parison::thermal {

namespace {

Index cell_unknowns(const HeatSystem& system) { return system.problem->order == 2 ? 6 : 3; }

std::vector<Index> list_topology(const HeatSystem& system) {
  std::vector<Index> topology;
  for (const auto& cell : system.cells)
    topology.insert(topology.end(), cell.begin(), cell.begin() + cell_unknowns(system));
  for (std::size_t b = 0; b < system.problem->bodies.size(); ++b)
    for (const core::BoundaryEdge& edge : system.problem->bodies[b].mesh->boundary)
      for (const Index unknown : edge_unknowns(system, static_cast<Index>(b), edge.nodes)) topology.push_back(unknown);
  return topology;
}

/// Cells, boundary edges and coupled edges, their unknowns by their rank.
core::Cliques list_cliques(const HeatSystem& system, const EdgeChain& chain, const std::vector<Index>& topology,
                           const std::vector<Coupling>& couplings, const std::vector<Index>& rank) {
  core::Cliques cliques;
  std::array<Index, 6> ranks;
  const auto add = [&](const Index* unknowns, Index count) {
    for (Index i = 0; i < count; ++i) ranks[i] = rank[unknowns[i]];
    cliques.add(ranks.data(), count);
  };
  const Index per_cell = cell_unknowns(system);
  const std::size_t in_cells = per_cell * system.cells.size();
  for (std::size_t k = 0; k < topology.size(); k += k < in_cells ? per_cell : 3)
    add(topology.data() + k, k < in_cells ? per_cell : 3);
  for (const Coupling& coupling : couplings) add(chain.unknowns(coupling).data(), 6);
  return cliques;
}

void analyse(StepMatrix& matrix, const HeatSystem& system, const EdgeChain& chain, std::vector<Index> topology) {
  matrix.order = elimination_order(system, matrix.couplings);
  std::vector<Index> rank(system.size());
  for (Index k = 0; k < system.size(); ++k) rank[matrix.order[k]] = k;
  const core::Cliques cliques = list_cliques(system, chain, topology, matrix.couplings, rank);
  matrix.assembly = core::make_assembly(system.size(), cliques, core::Triangle::upper);
  matrix.first_coupling = cliques.count() - static_cast<Index>(matrix.couplings.size());
  matrix.cholesky.analyse_ordered(matrix.assembly.matrix, matrix.order);
  matrix.topology = std::move(topology);
  matrix.analysed_couplings = matrix.couplings;
  matrix.factored_step = 0;
}

/// Which clique each segment of the interface has; false where one has none.
bool note_cliques(StepMatrix& matrix, const HeatSystem& system) {
  const std::vector<Coupling>& couplings = matrix.couplings;
  matrix.segment_clique.clear();
  for (const HeatSegment& segment : system.interface.segments) {
    const Coupling coupling = coupling_of(segment);
    const auto found = std::lower_bound(couplings.begin(), couplings.end(), coupling);
    if (found == couplings.end() || *found != coupling) return false;
    matrix.segment_clique.push_back(matrix.first_coupling + static_cast<Index>(found - couplings.begin()));
  }
  return true;
}

}  // namespace

void add_clique(StepMatrix& matrix, const HeatSystem& system, Index clique, Index count, const Index* unknowns,
                double* local) {
  if (!system.prescribed.empty())
    for (Index i = 0; i < count; ++i)
      if (system.is_prescribed[unknowns[i]])
        for (Index j = 0; j < count; ++j) local[i * count + j] = local[j * count + i] = 0;
  core::add_clique(matrix.assembly.matrix, matrix.assembly.scatter, clique, count, local);
}

void prepare(StepMatrix& matrix, const HeatSystem& system) {
  if (system.is_prescribed != matrix.is_prescribed) matrix.factored_step = 0;
  matrix.is_prescribed = system.is_prescribed;
  std::vector<Index> topology = list_topology(system);
  std::vector<Coupling>& couplings = matrix.couplings;
  const auto is_analysed = [&] { return topology == matrix.topology && couplings == matrix.analysed_couplings; };
  const bool lacks = !note_cliques(matrix, system);
  if (!lacks && is_analysed()) return;
  const EdgeChain chain(system);
  if (lacks || !chain.holds(couplings)) couplings = chain.widen(present_couplings(system));
  if (!is_analysed()) analyse(matrix, system, chain, std::move(topology));
  note_cliques(matrix, system);
}

bool factorise(StepMatrix& matrix, const HeatSystem& system, const Eigen::VectorXd& temperature, double step) {
  core::SymmetricMatrix& values = matrix.assembly.matrix;
  std::fill(values.value.begin(), values.value.end(), 0.0);
  assemble_cells(matrix, system, temperature, step);
  assemble_exchange(matrix, system, temperature, step);
  matrix.diagonal.resize(values.size);
  for (Index k = 0; k < values.size; ++k) {
    double& diagonal = values.value[values.column_start[k + 1] - 1];
    if (system.is_prescribed[matrix.order[k]]) diagonal = 1;
    matrix.diagonal[matrix.order[k]] = diagonal;
  }
  ++matrix.factorisations;
  const bool done = matrix.cholesky.factorise(values);
  matrix.factored_step = done ? step : 0;
  return done;
}

}  // namespace parison::thermal
