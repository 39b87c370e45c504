// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/flow/flow_matrix.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>

#include "core/process/run_error.hpp"
#include "core/solid/hex_geometry.hpp"

namespace parison::flow {

namespace {

constexpr double penalty_factor = 1e3;  ///< gamma: each correction of the pressure leaves about 1/gamma of its error

}  // namespace

FlowMatrix::FlowMatrix(const HexMesh& mesh, const std::vector<SymmetryPlane>& planes, const std::vector<Index>& fixed)
    : numbering_(mesh, planes, fixed), nodes_(mesh.cells), places_(mesh.cells.size()), cells_(mesh.cells.size()) {
  core::Cliques cliques;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    std::vector<Index> unknowns;
    for (int n = 0; n < HexMesh::nodes_per_cell; ++n) {
      const Index node = nodes_[cell][n];
      if (!numbering_.is_plain(node)) places_[cell].turned.push_back(n);
      for (int d = 0; d < 3; ++d)
        if (const Index k = numbering_.unknown(node, d); k >= 0) {
          unknowns.push_back(k);
          places_[cell].local.push_back(3 * n + d);
        }
    }
    cliques.add(unknowns.data(), static_cast<Index>(unknowns.size()));
    for (int i = 0; i < static_cast<int>(unknowns.size()); ++i)
      for (int j = 0; j < i; ++j)
        if (unknowns[i] == unknowns[j]) places_[cell].repeats.push_back({i, j});
  }
  assembly_ = core::make_assembly(numbering_.size(), cliques);
  std::vector<Index> order(numbering_.size());
  std::iota(order.begin(), order.end(), 0);
  factor_.analyse_ordered(assembly_.matrix, order, core::Triangle::lower);
}

CellVector FlowMatrix::of_cell(const Eigen::VectorXd& space, Index cell) const {
  CellVector own;
  for (int n = 0; n < HexMesh::nodes_per_cell; ++n) own.segment<3>(3 * n) = space.segment<3>(3 * nodes_[cell][n]);
  return own;
}

/// To the directions of its nodes.
void FlowMatrix::turn(Index cell, HexMatrix& matrix) const {
  for (const int n : places_[cell].turned) {
    const Eigen::Matrix3d& frame = numbering_.frame(nodes_[cell][n]);
    matrix.middleCols<3>(3 * n) = (matrix.middleCols<3>(3 * n) * frame).eval();
    matrix.middleRows<3>(3 * n) = (frame.transpose() * matrix.middleRows<3>(3 * n)).eval();
  }
}

void FlowMatrix::set_given(const SolidProblem& problem) {
  Index nodes = 0;
  for (const auto& cell : nodes_) nodes = std::max(nodes, *std::max_element(cell.begin(), cell.end()) + 1);
  given_ = given_force_ = Eigen::VectorXd::Zero(3 * nodes);
  for (const Index node : problem.fixed) given_.segment<3>(3 * node) = problem.fixed_velocity;
  moves_given_ = !problem.fixed.empty() && !problem.fixed_velocity.isZero(0);
}

void FlowMatrix::assemble(const SolidProblem& problem, const HexMesh& mesh, const Eigen::VectorXd& temperature,
                          const Eigen::VectorXd& velocity) {
  set_given(problem);
  std::fill(assembly_.matrix.value.begin(), assembly_.matrix.value.end(), 0.0);
  if (problem.memory) {
    memory_force_ = Eigen::VectorXd::Zero(3 * mesh.node_count());
    memory_expansion_.resize(4 * mesh.cell_count());
  }
  HexMatrices computed;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    CellState own{core::cell_nodes(mesh, cell), {}, {}, cell};
    for (int n = 0; n < HexMesh::nodes_per_cell; ++n) {
      own.temperature[n] = temperature[nodes_[cell][n]];
      own.velocity.col(n) = velocity.segment<3>(3 * nodes_[cell][n]);
    }
    compute_cell(problem, own, computed);
    // Elastic volume makes the pressure at once: p = p0 + K dt M^-1 (s - B v).
    const double penalty = problem.memory ? problem.memory->bulk : penalty_factor * computed.mean_viscosity;
    cells_[cell] = {computed.divergence, penalty * computed.mass.inverse(), computed.moment, computed.share,
                    computed.mean_viscosity};
    if (problem.memory) {
      for (int n = 0; n < HexMesh::nodes_per_cell; ++n)
        memory_force_.segment<3>(3 * nodes_[cell][n]) += computed.memory_force.segment<3>(3 * n);
      memory_expansion_.segment<4>(4 * cell) = computed.memory_expansion;
      computed.viscous.diagonal().array() += problem.memory->drag * computed.moment[0] / HexMesh::nodes_per_cell;
    }
    computed.viscous.noalias() += computed.divergence.transpose() * (cells_[cell].penalty * computed.divergence);
    add(cell, computed.viscous);
  }
}

void FlowMatrix::add(Index cell, const HexMatrix& matrix) {
  if (moves_given_)
    if (const CellVector given = of_cell(given_, cell); !given.isZero(0)) {
      const CellVector force = matrix.selfadjointView<Eigen::Lower>() * given;
      for (int n = 0; n < HexMesh::nodes_per_cell; ++n)
        given_force_.segment<3>(3 * nodes_[cell][n]) += force.segment<3>(3 * n);
    }
  const auto& [local, repeats, turned] = places_[cell];
  const HexMatrix* own = &matrix;
  HexMatrix in_frames;
  if (!turned.empty()) {
    in_frames = matrix.selfadjointView<Eigen::Lower>();
    turn(cell, in_frames);
    own = &in_frames;
  }
  const Index* position = assembly_.scatter.position.data() + assembly_.scatter.offset[cell];
  for (const auto& [i, j] : repeats)  // both triangles are one entry
    assembly_.matrix.value[position[i * (i + 1) / 2 + j]] += (*own)(local[i], local[j]);
  for (std::size_t i = 0; i < local.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) assembly_.matrix.value[*position++] += (*own)(local[i], local[j]);
}

void FlowMatrix::factorise() {
  if (!factor_.factorise(assembly_.matrix))
    throw core::RunError("the forces on the glass cannot be balanced: a part of it is held by nothing");
}

Eigen::VectorXd FlowMatrix::solve(const Eigen::VectorXd& force, const Eigen::VectorXd& pressure,
                                  const Eigen::VectorXd& expansion) const {
  Eigen::VectorXd total = force - given_force_;
  for (Index cell = 0; cell < static_cast<Index>(cells_.size()); ++cell) {
    const Eigen::Vector4d p = pressure.segment<4>(4 * cell) + cells_[cell].penalty * expansion.segment<4>(4 * cell);
    const CellVector own = cells_[cell].divergence.transpose() * p;
    for (int n = 0; n < HexMesh::nodes_per_cell; ++n) total.segment<3>(3 * nodes_[cell][n]) += own.segment<3>(3 * n);
  }
  return numbering_.to_space(factor_.solve(numbering_.to_unknowns(total))) + given_;
}

Eigen::VectorXd FlowMatrix::divergence(const Eigen::VectorXd& velocity) const {
  Eigen::VectorXd result(4 * static_cast<Index>(cells_.size()));
  for (Index cell = 0; cell < static_cast<Index>(cells_.size()); ++cell)
    result.segment<4>(4 * cell) = cells_[cell].divergence * of_cell(velocity, cell);
  return result;
}

Eigen::VectorXd FlowMatrix::corrected_pressure(const Eigen::VectorXd& velocity, const Eigen::VectorXd& pressure,
                                               const Eigen::VectorXd& expansion) const {
  Eigen::VectorXd result = pressure;
  const Eigen::VectorXd rest = expansion - divergence(velocity);
  for (Index cell = 0; cell < static_cast<Index>(cells_.size()); ++cell)
    result.segment<4>(4 * cell) += cells_[cell].penalty * rest.segment<4>(4 * cell);
  return result;
}

Eigen::VectorXd FlowMatrix::weight(double gravity, const Eigen::VectorXd& cell_mass) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(given_.size());
  for (Index cell = 0; cell < static_cast<Index>(cells_.size()); ++cell)
    for (int n = 0; n < HexMesh::nodes_per_cell; ++n)
      force[3 * nodes_[cell][n] + 2] += gravity * cell_mass[cell] * cells_[cell].share[n];
  return force;
}

}  // namespace parison::flow
