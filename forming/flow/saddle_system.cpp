// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/saddle_system.hpp"

#include <algorithm>

namespace parison::flow {

using core::dim;

SaddleSystem::SaddleSystem(const core::Mesh& mesh) : vertices_(mesh.vertex_count) {
  core::Cliques cliques;
  for (Index c = 0; c < mesh.cell_count(); ++c) cliques.add(unknowns_of(mesh, c).data(), cell_unknowns);
  assembly_ = core::make_assembly(dim * mesh.node_count() + mesh.vertex_count, cliques);
}

void SaddleSystem::analyse(const core::Mesh& mesh) {
  linear_.analyse(assembly_);
  diagonal_.resize(size());
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto unknowns = unknowns_of(mesh, c);
    const Index* position = assembly_.scatter.position.data() + assembly_.scatter.offset[c];
    for (int k = 0; k < cell_unknowns; ++k) diagonal_[unknowns[k]] = position[packed(k, k)];
  }
}

void SaddleSystem::add_held_cell(const std::array<Index, 6>& nodes, Index cell, CellMatrix local) {
  for (int i = 0; i < 6; ++i) {
    const NodeFrame* held = base_.find(nodes[i]);
    if (!held) continue;
    local.middleCols<dim>(dim * i) = (local.middleCols<dim>(dim * i) * held->frame).eval();
    local.middleRows<dim>(dim * i) = (held->frame.transpose() * local.middleRows<dim>(dim * i)).eval();
    for (int a = 0; a < dim; ++a) {
      if (!held->fixed[a]) continue;
      const double diagonal = local(dim * i + a, dim * i + a);
      local.row(dim * i + a).setZero();
      local.col(dim * i + a).setZero();
      local(dim * i + a, dim * i + a) = diagonal;
    }
  }
  core::add_clique(assembly_.matrix, assembly_.scatter, cell, cell_unknowns, local.data());
}

void SaddleSystem::add_cell(const Lanes* entries, Index cell) {
  const Index* position = assembly_.scatter.position.data() + assembly_.scatter.offset[cell];
  for (int k = 0; k < cell_entries; ++k) assembly_.matrix.value[position[k]] += entries[k][cell % lanes];
}

bool SaddleSystem::factorise(const core::Mesh& mesh, const CellMatrices& cells, const Held& base) {
  base_ = base;
  if (diagonal_.empty()) analyse(mesh);
  auto& matrix = assembly_.matrix;
  std::fill(matrix.value.begin(), matrix.value.end(), 0.0);
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto& nodes = mesh.cells[c];
    if (std::none_of(nodes.begin(), nodes.end(), [&](Index n) { return base_.find(n); }))
      add_cell(cells.batch(c / lanes), c);
    else
      add_held_cell(nodes, c, cells.of(c));
  }
  for (const auto& frame : base_.frames)
    if (frame.friction_tool >= 0) matrix.value[diagonal_[dim * frame.node + dim - 1]] += base_.drag[frame.node];
  return factorised_ = linear_.factorise(matrix);
}

Eigen::MatrixXd SaddleSystem::solve(Eigen::MatrixXd rhs) const {
  for (const auto& held : base_.frames) {
    auto rows = rhs.middleRows<dim>(dim * held.node);
    rows = (held.frame.transpose() * rows).eval();
    for (int a = 0; a < dim; ++a)
      if (held.fixed[a]) rows.row(a).setZero();
  }
  Eigen::MatrixXd solution = linear_.solve(rhs);
  for (const auto& held : base_.frames) {
    auto rows = solution.middleRows<dim>(dim * held.node);
    rows = (held.frame * rows).eval();
  }
  return solution;
}

}  // namespace parison::flow
