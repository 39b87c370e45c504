// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/cell_product.hpp"

#include <numeric>

namespace parison::flow {

using core::dim;

namespace {

using BatchVector = std::array<Lanes, cell_unknowns>;

/// The unknowns of the cells of a batch; those that stand in for missing cells are left out when forces are added.
struct BatchUnknowns {
  std::array<std::array<Index, cell_unknowns>, lanes> of;
  Index count;

  BatchUnknowns(const core::Mesh& mesh, Index batch) : count(std::min(lanes, mesh.cell_count() - batch * lanes)) {
    for (Index lane = 0; lane < lanes; ++lane)
      of[lane] = unknowns_of(mesh, std::min(batch * lanes + lane, mesh.cell_count() - 1));
  }
};

template <class Column>
BatchVector gather(const BatchUnknowns& unknowns, const Column& x) {
  BatchVector in;
  for (Index lane = 0; lane < lanes; ++lane)
    for (int k = 0; k < cell_unknowns; ++k) in[k][lane] = x[unknowns.of[lane][k]];
  return in;
}

BatchVector batch_product(const Lanes* matrix, const BatchVector& in) {
  BatchVector out;
  for (int i = 0; i < cell_unknowns; ++i) {
    Lanes row = Lanes::Zero();
    for (int j = 0; j < i; ++j, ++matrix) {
      row += *matrix * in[j];
      out[j] += *matrix * in[i];
    }
    out[i] = row + *matrix++ * in[i];
  }
  return out;
}

/// The product, and the sum of its parts without sign.
std::array<BatchVector, 2> batch_product_and_size(const Lanes* matrix, const BatchVector& in) {
  std::array<BatchVector, 2> result;
  auto& [out, size] = result;
  for (int i = 0; i < cell_unknowns; ++i) {
    Lanes row = Lanes::Zero(), row_size = row;
    for (int j = 0; j < i; ++j, ++matrix) {
      const Lanes from_j = *matrix * in[j], from_i = *matrix * in[i];
      row += from_j;
      row_size += from_j.abs();
      out[j] += from_i;
      size[j] += from_i.abs();
    }
    const Lanes own = *matrix++ * in[i];
    out[i] = row + own;
    size[i] = row_size + own.abs();
  }
  return result;
}

Index batch_count(const core::Mesh& mesh) { return (mesh.cell_count() + lanes - 1) / lanes; }

}  // namespace

std::array<Index, cell_unknowns> unknowns_of(const core::Mesh& mesh, Index cell) {
  std::array<Index, cell_unknowns> result;
  for (int i = 0; i < 6; ++i)
    for (int a = 0; a < dim; ++a) result[dim * i + a] = dim * mesh.cells[cell][i] + a;
  for (int q = 0; q < 3; ++q) result[cell_velocities + q] = dim * mesh.node_count() + mesh.cells[cell][q];
  return result;
}

Eigen::MatrixXd product(const core::Mesh& mesh, const CellMatrices& cells, const Eigen::MatrixXd& x) {
  std::vector<Index> all(batch_count(mesh));
  std::iota(all.begin(), all.end(), 0);
  return product(mesh, cells, x, all);
}

Eigen::MatrixXd product(const core::Mesh& mesh, const CellMatrices& cells, const Eigen::MatrixXd& x,
                        const std::vector<Index>& batches) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(x.rows(), x.cols());
  for (const Index batch : batches) {
    const BatchUnknowns unknowns(mesh, batch);
    for (Index column = 0; column < x.cols(); ++column) {
      const auto out = batch_product(cells.batch(batch), gather(unknowns, x.col(column)));
      for (Index lane = 0; lane < unknowns.count; ++lane)
        for (int k = 0; k < cell_unknowns; ++k) result(unknowns.of[lane][k], column) += out[k][lane];
    }
  }
  return result;
}

Eigen::MatrixXd product_and_size(const core::Mesh& mesh, const CellMatrices& cells, const Eigen::VectorXd& x) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(x.size(), 2);
  for (Index batch = 0; batch < batch_count(mesh); ++batch) {
    const BatchUnknowns unknowns(mesh, batch);
    const auto [out, size] = batch_product_and_size(cells.batch(batch), gather(unknowns, x));
    for (Index lane = 0; lane < unknowns.count; ++lane)
      for (int k = 0; k < cell_unknowns; ++k) {
        result(unknowns.of[lane][k], 0) += out[k][lane];
        result(unknowns.of[lane][k], 1) += size[k][lane];
      }
  }
  return result;
}

Eigen::VectorXd cell_loads(const core::Mesh& mesh, const CellMatrices& cells) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(dim * mesh.node_count() + mesh.vertex_count);
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto where = unknowns_of(mesh, c);
    for (int k = 0; k < cell_unknowns; ++k) load[where[k]] += cells.load_at(c, k);
  }
  return load;
}

}  // namespace parison::flow
