// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/time/step_matrix.hpp"

#include <algorithm>
#include <numeric>

#include "core/linear/elimination_order.hpp"
#include "core/linear/sparse_matrix.hpp"
#include "core/process/work_times.hpp"
#include "thermal/cells/cell_kernels.hpp"

namespace parison::thermal {

Linearisation linearise(const HeatSystem& system, double time, const Eigen::VectorXd& temperature) {
  Linearisation result;
  linearise_cells(system, temperature, result.batches);
  linearise_exchange(system, time, temperature, result);
  const core::WorkTimer timer(&core::WorkTimes::radiation);
  for (const Light& light : system.light) result.light.push_back(linearise_light(light, system, temperature));
  if (system.enclosure) result.enclosure = linearise_enclosure(system, temperature);
  return result;
}

Eigen::VectorXd apply(const HeatSystem& system, const Linearisation& linearisation, double step,
                      const Eigen::VectorXd& change) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(system.size());
  apply_cells(system, linearisation.batches, step, change, result);
  apply_exchange(system, linearisation, step, change, result);
  const core::WorkTimer timer(&core::WorkTimes::radiation);
  for (std::size_t i = 0; i < system.light.size(); ++i)
    apply_light(system.light[i], system, linearisation.light[i], step, change, result);
  if (system.enclosure) apply_enclosure(system, linearisation.enclosure, step, change, result);
  return result;
}

namespace {

std::vector<Index> list_topology(const HeatSystem& system) {
  std::vector<Index> topology;
  for (const auto& cell : system.cells) topology.insert(topology.end(), cell.begin(), cell.end());
  for (std::size_t b = 0; b < system.problem->bodies.size(); ++b)
    for (const core::BoundaryEdge& edge : system.problem->bodies[b].mesh->boundary_edges())
      for (const Index unknown : edge_unknowns(system, static_cast<Index>(b), edge.nodes)) topology.push_back(unknown);
  return topology;
}

/// Cliques of cells, boundary edges and coupled edges, their unknowns given by their rank in the elimination order.
core::Cliques list_cliques(const HeatSystem& system, const EdgeChain& chain, const std::vector<Index>& topology,
                           const std::vector<Coupling>& couplings, const std::vector<Index>& rank) {
  core::Cliques cliques;
  std::array<Index, 6> ranks;
  const auto add = [&](const Index* unknowns, Index count) {
    for (Index i = 0; i < count; ++i) ranks[i] = rank[unknowns[i]];
    cliques.add(ranks.data(), count);
  };
  constexpr Index per_cell = 6;
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

/// Finds the clique of each segment of the interface; false where the couplings lack one.
bool update_cliques(StepMatrix& matrix, const HeatSystem& system) {
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

void add_edge(StepMatrix& matrix, const HeatSystem& system, Index edge, const std::array<Index, 3>& unknowns,
              const std::array<double, 3>& factor, const EdgeShapes& shape) {
  std::array<double, 9> local{};
  for (int q = 0; q < 3; ++q)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j) local[i * 3 + j] += factor[q] * shape[q][i] * shape[q][j];
  add_clique(matrix, system, static_cast<Index>(system.cells.size()) + edge, 3, unknowns.data(), local.data());
}

void prepare(StepMatrix& matrix, const HeatSystem& system) {
  if (system.is_prescribed != matrix.is_prescribed) matrix.factored_step = 0;
  matrix.is_prescribed = system.is_prescribed;
  std::vector<Index> topology = list_topology(system);
  std::vector<Coupling>& couplings = matrix.couplings;
  const auto is_analysed = [&] { return topology == matrix.topology && couplings == matrix.analysed_couplings; };
  const bool lacks = !update_cliques(matrix, system);
  if (!lacks && is_analysed()) return;
  const EdgeChain chain(system);
  if (lacks || !chain.holds(couplings)) couplings = chain.widen(present_couplings(system));
  if (!is_analysed()) analyse(matrix, system, chain, std::move(topology));
  update_cliques(matrix, system);
}

bool factorise(StepMatrix& matrix, const HeatSystem& system, double time, const Eigen::VectorXd& temperature,
               double step) {
  core::SymmetricMatrix& values = matrix.assembly.matrix;
  std::fill(values.value.begin(), values.value.end(), 0.0);
  assemble_cells(matrix, system, temperature, step);
  assemble_exchange(matrix, system, time, temperature, step);
  for (const Light& light : system.light) assemble_light(matrix, light, system, temperature, step);
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

namespace {

/// Unknowns of the vertices, numbered in sequence.
struct Vertices {
  std::vector<Index> unknown;
  std::vector<Index> number;  ///< by unknown, -1 for a mid-side node
};

Vertices list_vertices(const HeatSystem& system) {
  Vertices vertices{{}, std::vector<Index>(system.size(), -1)};
  for (std::size_t b = 0; b < system.problem->bodies.size(); ++b)
    for (Index v = 0; v < system.problem->bodies[b].mesh->vertex_count(); ++v) {
      vertices.number[system.first_unknown[b] + v] = static_cast<Index>(vertices.unknown.size());
      vertices.unknown.push_back(system.first_unknown[b] + v);
    }
  return vertices;
}

/// Position of each vertex in the elimination order.
std::vector<Index> rank_vertices(const HeatSystem& system, const Vertices& vertices,
                                 const std::vector<Coupling>& couplings) {
  std::vector<std::array<Index, 2>> edges;
  edges.reserve(3 * system.cells.size() + 4 * couplings.size());
  const auto add = [&](Index a, Index b) { edges.push_back({vertices.number[a], vertices.number[b]}); };
  for (const auto& cell : system.cells)
    for (int i = 0; i < 3; ++i) add(cell[i], cell[(i + 1) % 3]);
  for (const Coupling& coupling : couplings)
    for (const int slave : {0, 1})
      for (const int master : {2, 3}) add(coupling[slave], coupling[master]);
  const auto count = static_cast<Index>(vertices.unknown.size());
  const std::vector<Index> order = core::minimum_degree_order(count, edges);
  std::vector<Index> rank(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) rank[order[k]] = static_cast<Index>(k);
  return rank;
}

}  // namespace

std::vector<Index> elimination_order(const HeatSystem& system, const std::vector<Coupling>& couplings) {
  const Vertices vertices = list_vertices(system);
  const std::vector<Index> rank = rank_vertices(system, vertices, couplings);
  const Index count = static_cast<Index>(rank.size());
  // Each unknown is grouped with a vertex: a vertex with itself, a mid-side node with the vertex it precedes.
  std::vector<Index> with(system.size(), count);
  for (Index v = 0; v < count; ++v) with[vertices.unknown[v]] = rank[v];
  for (const auto& cell : system.cells)
    for (int i = 0; i < 3; ++i) with[cell[3 + i]] = std::min(with[cell[i]], with[cell[(i + 1) % 3]]);
  std::vector<Index> end(count + 1, 0), order(system.size());
  for (const Index w : with) ++end[w + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Index> next(end.begin(), end.end() - 1);
  for (Index u = 0; u < system.size(); ++u) order[vertices.number[u] < 0 ? next[with[u]]++ : end[with[u] + 1] - 1] = u;
  return order;
}

}  // namespace parison::thermal
