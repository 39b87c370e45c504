// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/saddle_system.hpp"

#include <algorithm>

namespace parison::flow {

using core::dim;

namespace {
using Local = Eigen::Matrix<double, cell_unknowns, cell_unknowns, Eigen::RowMajor>;
}  // namespace

std::array<Index, cell_unknowns> unknowns_of(const core::Mesh& mesh, Index cell) {
  std::array<Index, cell_unknowns> result;
  for (int i = 0; i < 6; ++i)
    for (int a = 0; a < dim; ++a) result[dim * i + a] = dim * mesh.cells[cell][i] + a;
  for (int q = 0; q < 3; ++q) result[cell_velocities + q] = dim * mesh.node_count() + mesh.cells[cell][q];
  return result;
}

SaddleSystem::SaddleSystem(const core::Mesh& mesh) : vertices_(mesh.vertex_count) {
  core::Cliques cliques;
  for (Index c = 0; c < mesh.cell_count(); ++c) cliques.add(unknowns_of(mesh, c).data(), cell_unknowns);
  assembly_ = core::make_assembly(dim * mesh.node_count() + mesh.vertex_count, cliques);
}

void SaddleSystem::add_held_cell(const std::array<Index, 6>& nodes, Index cell, const double* matrix) {
  Local local = Eigen::Map<const Local>(matrix);
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

bool SaddleSystem::factorise(const core::Mesh& mesh, const CellMatrices& cells, const Held& base) {
  base_ = base;
  auto& matrix = assembly_.matrix;
  std::fill(matrix.value.begin(), matrix.value.end(), 0.0);
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto& nodes = mesh.cells[c];
    if (std::none_of(nodes.begin(), nodes.end(), [&](Index n) { return base_.find(n); }))
      core::add_clique(matrix, assembly_.scatter, c, cell_unknowns, cells.of(c));
    else
      add_held_cell(nodes, c, cells.of(c));
  }
  for (const auto& frame : base_.frames)
    if (frame.friction_tool >= 0) matrix.value[matrix.column_start[dim * frame.node + dim - 1]] += base_.drag[frame.node];
  if (!analysed_) linear_.analyse(matrix);
  analysed_ = true;
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

Eigen::Matrix<double, cell_unknowns, 1> cell_product(const double* matrix, const std::array<Index, cell_unknowns>& where,
                                                     Eigen::Ref<const Eigen::VectorXd> x) {
  Eigen::Matrix<double, cell_unknowns, 1> in;
  for (int k = 0; k < cell_unknowns; ++k) in[k] = x[where[k]];
  return Eigen::Map<const Local>(matrix) * in;
}

Eigen::MatrixXd product(const core::Mesh& mesh, const CellMatrices& cells, const Eigen::MatrixXd& x,
                        const std::vector<Index>* listed) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(x.rows(), x.cols());
  const Index count = listed ? static_cast<Index>(listed->size()) : mesh.cell_count();
  for (Index i = 0; i < count; ++i) {
    const Index c = listed ? (*listed)[i] : i;
    const auto where = unknowns_of(mesh, c);
    for (Index column = 0; column < x.cols(); ++column) {
      const auto out = cell_product(cells.of(c), where, x.col(column));
      for (int k = 0; k < cell_unknowns; ++k) result(where[k], column) += out[k];
    }
  }
  return result;
}

}  // namespace parison::flow
