// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/cells/cell_product.hpp"

#include <numeric>

namespace parison::flow {

using core::dim;

namespace {

using BatchVector = std::array<BatchArray, cell_unknowns>;

/// The unknowns of the cells of a batch; those that stand in for missing cells are left out when forces are added.
struct BatchUnknowns {
  std::array<std::array<Index, cell_unknowns>, batch_size> of;
  Index count;

  BatchUnknowns(const core::Mesh& mesh, Index batch)
      : count(std::min(batch_size, mesh.cell_count() - batch * batch_size)) {
    for (Index lane = 0; lane < batch_size; ++lane)
      of[lane] = unknowns_of(mesh, std::min(batch * batch_size + lane, mesh.cell_count() - 1));
  }
};

/// The unknowns' numbers, put together where they are used: vectors that were stored in parts are slow to load.
[[gnu::always_inline]] inline void gather(const BatchUnknowns& unknowns, const double* x, VectorizedArray* in) {
  for (int k = 0; k < cell_unknowns; ++k)
    in[k] = VectorizedArray{x[unknowns.of[0][k]], x[unknowns.of[1][k]], x[unknowns.of[2][k]], x[unknowns.of[3][k]]};
}

[[gnu::target_clones("avx2", "default")]] void multiply_batch(const BatchArray* matrix, const BatchUnknowns& unknowns,
                                                              const double* x, BatchVector& out) {
  VectorizedArray in[cell_unknowns];
  gather(unknowns, x, in);
  for (int i = 0; i < cell_unknowns; ++i) {
    VectorizedArray row{};
    for (int j = 0; j < i; ++j, ++matrix) {
      row += vectorized(*matrix) * in[j];
      vectorized(out[j]) += vectorized(*matrix) * in[i];
    }
    vectorized(out[i]) = row + vectorized(*matrix++) * in[i];
  }
}

[[gnu::always_inline]] inline void absolute_value(const VectorizedArray& x, VectorizedArray& size) {
  size = x < 0 ? -x : x;
}

/// The product of numbers without sign.
[[gnu::target_clones("avx2", "default")]] void multiply_sizes(const BatchArray* matrix, const BatchUnknowns& unknowns,
                                                              const double* x, BatchVector& out) {
  VectorizedArray in[cell_unknowns], size[cell_unknowns], entry;
  gather(unknowns, x, in);
  for (int i = 0; i < cell_unknowns; ++i) {
    absolute_value(in[i], size[i]);
    VectorizedArray row{};
    for (int j = 0; j < i; ++j, ++matrix) {
      absolute_value(vectorized(*matrix), entry);
      row += entry * size[j];
      vectorized(out[j]) += entry * size[i];
    }
    absolute_value(vectorized(*matrix++), entry);
    vectorized(out[i]) = row + entry * size[i];
  }
}

Index batch_count(const core::Mesh& mesh) {
  return (mesh.cell_count() + batch_size - 1) / batch_size;
}

}  // namespace

std::array<Index, cell_unknowns> unknowns_of(const core::Mesh& mesh, Index cell) {
  std::array<Index, cell_unknowns> result;
  for (int i = 0; i < 6; ++i)
    for (int a = 0; a < dim; ++a) result[dim * i + a] = dim * mesh.cells()[cell][i] + a;
  for (int q = 0; q < 3; ++q) result[cell_velocities + q] = dim * mesh.node_count() + mesh.cells()[cell][q];
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
  std::vector<Index> columns;
  for (Index column = 0; column < x.cols(); ++column)
    if (!x.col(column).isZero(0)) columns.push_back(column);
  for (const Index batch : batches) {
    const BatchUnknowns unknowns(mesh, batch);
    for (const Index column : columns) {
      BatchVector out;
      multiply_batch(cells.batch(batch), unknowns, x.col(column).data(), out);
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
    BatchVector out, size;
    multiply_batch(cells.batch(batch), unknowns, x.data(), out);
    multiply_sizes(cells.batch(batch), unknowns, x.data(), size);
    for (Index lane = 0; lane < unknowns.count; ++lane)
      for (int k = 0; k < cell_unknowns; ++k) {
        result(unknowns.of[lane][k], 0) += out[k][lane];
        result(unknowns.of[lane][k], 1) += size[k][lane];
      }
  }
  return result;
}

Eigen::VectorXd cell_loads(const core::Mesh& mesh, const CellMatrices& cells) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(dim * mesh.node_count() + mesh.vertex_count());
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto where = unknowns_of(mesh, c);
    for (int k = 0; k < cell_unknowns; ++k) load[where[k]] += cells.load_at(c, k);
  }
  return load;
}

}  // namespace parison::flow
