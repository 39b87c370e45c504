// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/saddle_system.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "core/element.hpp"

namespace parison::flow {

using core::dim;

namespace {

/// Whether anything resists a translation of the glass along coordinate `axis`.
bool is_held(const std::vector<NodeFrame>& frames, int axis) {
  constexpr double counts = 1e-3;
  return std::any_of(frames.begin(), frames.end(), [&](const NodeFrame& frame) {
    for (int a = 0; a < dim; ++a)
      if ((frame.fixed[a] || (frame.friction_tool >= 0 && a == dim - 1)) && std::abs(frame.frame(axis, a)) > counts)
        return true;
    return false;
  });
}

/// Closes the candidate that a glass pushed by `load` along `axis` would meet first; false when there is none.
bool close_first_met(const Problem& problem, int axis, double load, std::vector<bool>& active) {
  int best = -1;
  for (std::size_t i = 0; i < active.size(); ++i) {
    const auto& candidate = problem.candidates[i];
    if (active[i] || candidate.normal[axis] * load >= 0 || std::abs(candidate.normal[axis]) < 0.1) continue;
    if (best < 0 || candidate.rate > problem.candidates[best].rate) best = static_cast<int>(i);
  }
  if (best >= 0) active[best] = true;
  return best >= 0;
}

}  // namespace

SaddleSystem::SaddleSystem(const core::Mesh& mesh) {
  core::Cliques cliques;
  for (Index c = 0; c < mesh.cell_count(); ++c) cliques.add(unknowns(mesh, c).data(), cell_unknowns);
  assembly = core::make_assembly(dim * mesh.node_count() + mesh.vertex_count, cliques);
}

std::array<Index, cell_unknowns> SaddleSystem::unknowns(const core::Mesh& mesh, Index cell) const {
  std::array<Index, cell_unknowns> result;
  for (int i = 0; i < 6; ++i)
    for (int a = 0; a < dim; ++a) result[dim * i + a] = dim * mesh.cells[cell][i] + a;
  for (int q = 0; q < 3; ++q) result[cell_velocities + q] = dim * mesh.node_count() + mesh.cells[cell][q];
  return result;
}

void SaddleSystem::add_constrained_cell(const std::array<Index, 6>& nodes, Index cell, Eigen::MatrixXd& rhs,
                                        const std::array<Index, cell_unknowns>& where) {
  using Local = Eigen::Matrix<double, cell_unknowns, cell_unknowns, Eigen::RowMajor>;
  Local local = Eigen::Map<const Local>(cells.matrix.data() + std::size_t(cell) * cell_unknowns * cell_unknowns);
  for (int i = 0; i < 6; ++i) {
    if (frame_of[nodes[i]] < 0) continue;
    const core::Tensor& frame = frames[frame_of[nodes[i]]].frame;
    local.middleCols<dim>(dim * i) = (local.middleCols<dim>(dim * i) * frame).eval();
    local.middleRows<dim>(dim * i) = (frame.transpose() * local.middleRows<dim>(dim * i)).eval();
  }
  for (int i = 0; i < 6; ++i) {
    if (frame_of[nodes[i]] < 0) continue;
    const NodeFrame& frame = frames[frame_of[nodes[i]]];
    for (int a = 0; a < dim; ++a) {
      if (!frame.fixed[a]) continue;
      const int d = dim * i + a;
      for (int row = 0; row < cell_unknowns; ++row)
        if (row != d) rhs.row(where[row]) -= local(row, d) * frame.given.row(a);
      const double diagonal = local(d, d);
      local.row(d).setZero();
      local.col(d).setZero();
      local(d, d) = diagonal;
    }
  }
  core::add_clique(assembly.matrix, assembly.scatter, cell, cell_unknowns, local.data());
}

Eigen::MatrixXd SaddleSystem::assemble(const Problem& problem, const Eigen::VectorXd& friction) {
  const auto& mesh = *problem.mesh;
  const auto driven = driven_tools(problem);
  auto& matrix = assembly.matrix;
  std::fill(matrix.value.begin(), matrix.value.end(), 0.0);
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(matrix.size, 1 + Index(driven.size()));
  rhs.col(0) = load;
  for (const auto& frame : frames)
    rhs.block(dim * frame.node, 0, dim, 1) = (frame.frame.transpose() * rhs.block(dim * frame.node, 0, dim, 1)).eval();
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto& nodes = mesh.cells[c];
    if (std::all_of(nodes.begin(), nodes.end(), [&](Index n) { return frame_of[n] < 0; }))
      core::add_clique(matrix, assembly.scatter, c, cell_unknowns,
                       cells.matrix.data() + std::size_t(c) * cell_unknowns * cell_unknowns);
    else
      add_constrained_cell(nodes, c, rhs, unknowns(mesh, c));
  }
  for (const auto& frame : frames) {
    if (frame.friction_tool >= 0) {
      const Index sideways = dim * frame.node + dim - 1;
      const double drag = friction[frame.node], along = frame.frame(dim - 1, dim - 1);
      matrix.value[matrix.column_start[sideways]] += drag;
      const auto k = std::find(driven.begin(), driven.end(), frame.friction_tool);
      if (k == driven.end())
        rhs(sideways, 0) += drag * along * problem.tools[frame.friction_tool].velocity;
      else
        rhs(sideways, 1 + (k - driven.begin())) += drag * along;
    }
    for (int a = 0; a < dim; ++a)
      if (frame.fixed[a]) {
        const Index unknown = dim * frame.node + a;
        rhs.row(unknown) = matrix.value[matrix.column_start[unknown]] * frame.given.row(a);
      }
  }
  return rhs;
}

void SaddleSystem::set_frames(const Problem& problem, const std::vector<bool>& active) {
  frames = node_frames(problem, active);
  frame_of.assign(problem.mesh->nodes.size(), -1);
  for (std::size_t i = 0; i < frames.size(); ++i) frame_of[frames[i].node] = Index(i);
}

bool SaddleSystem::hold(const Problem& problem, std::vector<bool>& active) {
  const bool rings = core::hoop(problem.geometry, Point::Ones()) != 0;
  for (int axis = rings ? dim - 1 : 0; axis < dim; ++axis) {
    if (is_held(frames, axis)) continue;
    double force = 0;
    for (Index n = 0; n < problem.mesh->node_count(); ++n) force += load[dim * n + axis];
    if (!close_first_met(problem, axis, force, active)) return false;
    set_frames(problem, active);
  }
  return true;
}

void SaddleSystem::to_global_frame(Eigen::MatrixXd& solution) const {
  for (const auto& frame : frames)
    solution.middleRows<dim>(dim * frame.node) = (frame.frame * solution.middleRows<dim>(dim * frame.node)).eval();
}

Eigen::MatrixXd SaddleSystem::reactions(const Problem& problem, const Eigen::MatrixXd& solution) const {
  using Local = Eigen::Matrix<double, cell_unknowns, cell_unknowns, Eigen::RowMajor>;
  const auto& mesh = *problem.mesh;
  Eigen::MatrixXd reaction = Eigen::MatrixXd::Zero(dim * mesh.node_count(), solution.cols());
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto& nodes = mesh.cells[c];
    if (std::all_of(nodes.begin(), nodes.end(), [&](Index n) { return frame_of[n] < 0; })) continue;
    const Eigen::Map<const Local> local(cells.matrix.data() + std::size_t(c) * cell_unknowns * cell_unknowns);
    const auto where = unknowns(mesh, c);
    Eigen::MatrixXd x(cell_unknowns, solution.cols());
    for (int i = 0; i < cell_unknowns; ++i) x.row(i) = solution.row(where[i]);
    const Eigen::MatrixXd product = local.topRows<cell_velocities>() * x;
    for (int i = 0; i < cell_velocities; ++i) reaction.row(where[i]) += product.row(i);
  }
  reaction.col(0) -= load.head(reaction.rows());
  return reaction;
}

}  // namespace parison::flow
