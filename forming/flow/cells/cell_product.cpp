// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/cells/cell_product.hpp"

#include <numeric>

namespace parison::flow {

using core::dim;

namespace {

using BatchVector = core::UnknownValues<cell_unknowns>;

/// Unknowns of the cells of a batch.
core::BatchIndices<cell_unknowns> batch_unknowns(const core::Mesh& mesh, Index batch) {
  core::BatchIndices<cell_unknowns> result;
  for (int lane = 0; lane < batch_size; ++lane) {
    const auto unknowns = unknowns_of(mesh, core::cell_in_lane(mesh.cell_count(), batch, lane));
    for (int k = 0; k < cell_unknowns; ++k) result[k][lane] = unknowns[k];
  }
  return result;
}

[[gnu::target_clones("avx2", "default")]] void multiply_batch(const VectorizedArray* matrix,
                                                              const core::BatchIndices<cell_unknowns>& unknowns,
                                                              const double* x, BatchVector& out) {
  BatchVector in;
  core::gather(x, unknowns, in);
  for (int i = 0; i < cell_unknowns; ++i) {
    VectorizedArray row{};
    for (int j = 0; j < i; ++j, ++matrix) {
      row += *matrix * in[j];
      out[j] += *matrix * in[i];
    }
    out[i] = row + *matrix++ * in[i];
  }
}

[[gnu::always_inline]] inline void absolute_value(const VectorizedArray& x, VectorizedArray& size) {
  size = core::absolute(x);
}

/// The product of the absolute values, |K| |x|.
[[gnu::target_clones("avx2", "default")]] void multiply_sizes(const VectorizedArray* matrix,
                                                              const core::BatchIndices<cell_unknowns>& unknowns,
                                                              const double* x, BatchVector& out) {
  BatchVector in, size;
  VectorizedArray entry;
  core::gather(x, unknowns, in);
  for (int i = 0; i < cell_unknowns; ++i) {
    absolute_value(in[i], size[i]);
    VectorizedArray row{};
    for (int j = 0; j < i; ++j, ++matrix) {
      absolute_value(*matrix, entry);
      row += entry * size[j];
      out[j] += entry * size[i];
    }
    absolute_value(*matrix++, entry);
    out[i] = row + entry * size[i];
  }
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
  std::vector<Index> all(core::batch_count(mesh.cell_count()));
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
    const auto unknowns = batch_unknowns(mesh, batch);
    const int lanes = core::filled_lanes(mesh.cell_count(), batch);
    for (const Index column : columns) {
      BatchVector out;
      multiply_batch(cells.batch(batch), unknowns, x.col(column).data(), out);
      core::scatter(out, unknowns, lanes, result.col(column).data());
    }
  }
  return result;
}

Eigen::MatrixXd product_and_size(const core::Mesh& mesh, const CellMatrices& cells, const Eigen::VectorXd& x) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(x.size(), 2);
  for (Index batch = 0; batch < core::batch_count(mesh.cell_count()); ++batch) {
    const auto unknowns = batch_unknowns(mesh, batch);
    const int lanes = core::filled_lanes(mesh.cell_count(), batch);
    BatchVector out, size;
    multiply_batch(cells.batch(batch), unknowns, x.data(), out);
    multiply_sizes(cells.batch(batch), unknowns, x.data(), size);
    core::scatter(out, unknowns, lanes, result.col(0).data());
    core::scatter(size, unknowns, lanes, result.col(1).data());
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
