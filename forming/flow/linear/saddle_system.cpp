// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/linear/saddle_system.hpp"

#include <algorithm>

#include "core/linear/elimination_order.hpp"

namespace parison::flow {

using core::dim;

namespace {

/// For each vertex the position in the elimination order after which its pressure is eliminated. The pivot of a
/// pressure nearly vanishes before a velocity that it acts on has been eliminated, and those at the boundary may all be
/// constrained, so it waits for the first interior node around.
std::vector<Index> pressure_places(const core::Mesh& mesh, const std::vector<Index>& place) {
  std::vector<bool> inside(mesh.nodes.size(), true);
  for (const auto& edge : mesh.boundary_edges())
    for (const Index node : edge.nodes) inside[node] = false;
  const Index last = mesh.node_count() - 1;
  std::vector<Index> first(mesh.vertex_count(), last);
  for (const auto& cell : mesh.cells())
    for (int v = 0; v < 3; ++v)
      for (const Index node : cell)
        if (inside[node]) first[cell[v]] = std::min(first[cell[v]], place[node]);
  for (Index v = 0; v < mesh.vertex_count(); ++v) first[v] = std::max(first[v], place[v]);
  return first;
}

/// For each node the least number of cells between it and the middle of a boundary edge. It depends on the topology
/// alone, as the elimination order has to: a run that is taken up again has moved nodes.
std::vector<Index> layers_from_boundary(const core::Mesh& mesh) {
  std::vector<Index> layer(mesh.node_count(), mesh.node_count());
  for (const auto& edge : mesh.boundary_edges()) layer[edge.nodes[2]] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& cell : mesh.cells()) {
      Index least = mesh.node_count();
      for (const Index node : cell) least = std::min(least, layer[node]);
      for (const Index node : cell)
        if (layer[node] > least + 1) layer[node] = least + 1, changed = true;
    }
  }
  return layer;
}

}  // namespace

std::vector<Index> elimination_order(const core::Mesh& mesh) {
  // The order is that of the nodes: all unknowns of a node couple with the same others.
  std::vector<std::array<Index, 2>> edges;
  edges.reserve(15 * mesh.cells().size());
  for (const auto& cell : mesh.cells())
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < i; ++j) edges.push_back({cell[i], cell[j]});
  const std::vector<Index> nodes = core::minimum_fill_order(layers_from_boundary(mesh), edges);
  std::vector<Index> place(mesh.node_count());
  for (Index k = 0; k < mesh.node_count(); ++k) place[nodes[k]] = k;
  const std::vector<Index> pressure_place = pressure_places(mesh, place);
  std::vector<std::vector<Index>> pressures(mesh.node_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) pressures[pressure_place[v]].push_back(dim * mesh.node_count() + v);
  std::vector<Index> order;
  for (Index k = 0; k < mesh.node_count(); ++k) {
    for (int a = 0; a < dim; ++a) order.push_back(dim * nodes[k] + a);
    order.insert(order.end(), pressures[k].begin(), pressures[k].end());
  }
  return order;
}

SaddleSystem::SaddleSystem(const core::Mesh& mesh) : vertices_(mesh.vertex_count()) {
  const auto order = elimination_order(mesh);
  std::vector<Index> rank(order.size());
  for (std::size_t k = 0; k < rank.size(); ++k) rank[order[k]] = static_cast<Index>(k);
  core::Cliques cliques;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    auto unknowns = unknowns_of(mesh, c);
    for (Index& unknown : unknowns) unknown = rank[unknown];
    cliques.add(unknowns.data(), cell_unknowns);
  }
  assembly_ = core::make_assembly(static_cast<Index>(rank.size()), cliques, core::Triangle::upper);
  linear_.analyse_ordered(assembly_.matrix, order);
  diagonal_.resize(size());
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto unknowns = unknowns_of(mesh, c);
    const Index* position = assembly_.scatter.position.data() + assembly_.scatter.offset[c];
    for (int k = 0; k < cell_unknowns; ++k) diagonal_[unknowns[k]] = position[packed(k, k)];
  }
}

void SaddleSystem::add_constrained_cell(const std::array<Index, 6>& nodes, Index cell, CellMatrix local) {
  for (int i = 0; i < 6; ++i) {
    const NodeConstraint* constraint = base_.find(nodes[i]);
    if (!constraint) continue;
    local.middleCols<dim>(dim * i) = (local.middleCols<dim>(dim * i) * constraint->basis).eval();
    local.middleRows<dim>(dim * i) = (constraint->basis.transpose() * local.middleRows<dim>(dim * i)).eval();
    for (int a = 0; a < dim; ++a) {
      if (!constraint->fixed[a]) continue;
      const double diagonal = local(dim * i + a, dim * i + a);
      local.row(dim * i + a).setZero();
      local.col(dim * i + a).setZero();
      local(dim * i + a, dim * i + a) = diagonal;
    }
  }
  core::add_clique(assembly_.matrix, assembly_.scatter, cell, cell_unknowns, local.data());
}

void SaddleSystem::add_cell(const VectorizedArray* entries, Index cell) {
  const Index* position = assembly_.scatter.position.data() + assembly_.scatter.offset[cell];
  for (int k = 0; k < cell_entries; ++k) assembly_.matrix.value[position[k]] += entries[k][cell % batch_size];
}

bool SaddleSystem::factorise(const core::Mesh& mesh, const CellMatrices& cells, const Constraints& base) {
  base_ = base;
  auto& matrix = assembly_.matrix;
  std::fill(matrix.value.begin(), matrix.value.end(), 0.0);
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto& nodes = mesh.cells()[c];
    if (std::none_of(nodes.begin(), nodes.end(), [&](Index n) { return base_.find(n); }))
      add_cell(cells.batch(c / batch_size), c);
    else
      add_constrained_cell(nodes, c, cells.of(c));
  }
  for (const auto& constraint : base_.nodes)
    if (constraint.friction_tool >= 0)
      matrix.value[diagonal_[dim * constraint.node + dim - 1]] += base_.tangential_stiffness[constraint.node];
  return factorised_ = linear_.factorise(matrix);
}

Eigen::MatrixXd SaddleSystem::solve(Eigen::MatrixXd rhs) const {
  for (const auto& constraint : base_.nodes) {
    auto rows = rhs.middleRows<dim>(dim * constraint.node);
    rows = (constraint.basis.transpose() * rows).eval();
    for (int a = 0; a < dim; ++a)
      if (constraint.fixed[a]) rows.row(a).setZero();
  }
  Eigen::MatrixXd solution = linear_.solve(rhs);
  for (const auto& constraint : base_.nodes) {
    auto rows = solution.middleRows<dim>(dim * constraint.node);
    rows = (constraint.basis * rows).eval();
  }
  return solution;
}

}  // namespace parison::flow
