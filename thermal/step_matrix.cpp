// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/step_matrix.hpp"

#include <algorithm>

#include "thermal/elimination.hpp"
#include "thermal/linearise.hpp"
#include "thermal/shapes.hpp"

namespace parison::thermal {

namespace {

ContactKey clique_key(const HeatSegment& segment) {
  return {segment.unknowns[0], segment.unknowns[1], segment.unknowns[3], segment.unknowns[4]};
}

/// Whether the pattern has the clique of every segment; notes them.
bool find_cliques(StepMatrix& matrix, const std::vector<HeatSegment>& segments) {
  matrix.segment_clique.clear();
  for (const HeatSegment& segment : segments) {
    const auto found = matrix.contact_clique.find(clique_key(segment));
    if (found == matrix.contact_clique.end()) return false;
    matrix.segment_clique.push_back(found->second);
  }
  return true;
}

Index cell_unknowns(const HeatSystem& system) { return system.problem->order == 2 ? 6 : 3; }

std::vector<Index> list_topology(const HeatSystem& system) {
  std::vector<Index> topology;
  for (const HeatCell& cell : system.cells)
    topology.insert(topology.end(), cell.unknowns.begin(), cell.unknowns.begin() + cell_unknowns(system));
  for (std::size_t b = 0; b < system.problem->bodies.size(); ++b)
    for (const core::BoundaryEdge& edge : system.problem->bodies[b].mesh->boundary)
      for (const Index unknown : edge_unknowns(system, static_cast<Index>(b), edge.nodes)) topology.push_back(unknown);
  return topology;
}

template <int N>
void add_cells(StepMatrix& matrix, const HeatSystem& system, const Linearisation& slopes, double step) {
  const auto& [value, slope_a, slope_b, value_back, slope_a_back, slope_b_back] = cell_shapes<N>();
  for (Index c = 0; c < static_cast<Index>(system.cells.size()); ++c) {
    const HeatCell& cell = system.cells[c];
    const PointArray conduction = step * slopes.cells[c].conductivity;
    const PointArray aa = conduction * cell.aa, ab = conduction * cell.ab, bb = conduction * cell.bb;
    const Eigen::Matrix<double, 6, N> stored = slopes.cells[c].capacity.matrix().asDiagonal() * value;
    const Eigen::Matrix<double, 6, N> flow_a = aa.matrix().asDiagonal() * slope_a + ab.matrix().asDiagonal() * slope_b;
    const Eigen::Matrix<double, 6, N> flow_b = ab.matrix().asDiagonal() * slope_a + bb.matrix().asDiagonal() * slope_b;
    std::array<double, N * N> local;
    Eigen::Map<Eigen::Matrix<double, N, N>>(local.data()) =
        value_back * stored + slope_a_back * flow_a + slope_b_back * flow_b;
    add_clique(matrix, system, c, N, cell.unknowns.data(), local.data());
  }
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
  std::vector<Index> topology = list_topology(system);
  const auto& segments = system.interface.segments;
  std::vector<Index> contacts;
  for (const HeatSegment& segment : segments)
    contacts.insert(contacts.end(), segment.unknowns.begin(), segment.unknowns.end());
  if (system.is_prescribed != matrix.is_prescribed) matrix.factored_step = 0;
  matrix.is_prescribed = system.is_prescribed;
  if (topology == matrix.topology && contacts == matrix.contact_topology) return;
  core::Cliques cliques;
  const Index per_cell = cell_unknowns(system);
  const std::size_t in_cells = per_cell * system.cells.size();
  for (std::size_t k = 0; k < topology.size(); k += k < in_cells ? per_cell : 3)
    cliques.add(topology.data() + k, k < in_cells ? per_cell : 3);
  matrix.contact_clique.clear();
  for (const HeatSegment& segment : segments)
    if (matrix.contact_clique.emplace(clique_key(segment), cliques.count()).second)
      cliques.add(segment.unknowns.data(), 6);
  find_cliques(matrix, segments);
  matrix.assembly = core::make_assembly(system.size(), cliques);
  matrix.cholesky.analyse(matrix.assembly.matrix, elimination_order(system, segments));
  matrix.topology = std::move(topology);
  matrix.contact_topology = std::move(contacts);
  matrix.factored_step = 0;
}

bool factorise(StepMatrix& matrix, const HeatSystem& system, const Eigen::VectorXd& temperature, double step) {
  core::SymmetricMatrix& values = matrix.assembly.matrix;
  std::fill(values.value.begin(), values.value.end(), 0.0);
  const Linearisation slopes = linearise(system, temperature);
  (system.problem->order == 2 ? add_cells<6> : add_cells<3>)(matrix, system, slopes, step);
  assemble_exchange(matrix, system, slopes, step);
  for (const auto& [unknown, value] : system.prescribed) values.value[values.column_start[unknown]] = 1;
  matrix.diagonal.resize(values.size);
  for (Index i = 0; i < values.size; ++i) matrix.diagonal[i] = values.value[values.column_start[i]];
  ++matrix.factorisations;
  const bool done = matrix.cholesky.factorise(values);
  matrix.factored_step = done ? step : 0;
  return done;
}

}  // namespace parison::thermal
