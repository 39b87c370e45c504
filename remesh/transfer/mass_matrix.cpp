// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/transfer/mass_matrix.hpp"

#include "core/mesh/element.hpp"

namespace parison::remesh {

using core::Index;

MassMatrix::MassMatrix(const core::Mesh& mesh, core::Geometry geometry, int order)
    : mesh_(mesh), functions_(order == 2 ? 6 : 3), cells_(mesh.cells().size()) {
  const int n = functions_;
  diagonal_ = Eigen::VectorXd::Zero(order == 2 ? mesh.node_count() : mesh.vertex_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    auto& local = cells_[cell];
    local.fill(0);
    for (const core::TriangleRulePoint& at : core::triangle_rule(6)) {
      const core::CellPoint point = core::map_cell_point(mesh, cell, geometry, at);
      const double* shape = order == 2 ? point.shape.data() : point.linear.data();
      for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) local[n * i + j] += shape[i] * shape[j] * point.volume;
    }
    for (int i = 0; i < n; ++i) {
      for (int j = i + 1; j < n; ++j) local[n * i + j] = local[n * j + i];
      diagonal_[mesh.cells()[cell][i]] += local[n * i + i];
    }
  }
}

Eigen::VectorXd MassMatrix::multiply(const Eigen::VectorXd& x) const {
  const int n = functions_;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(x.size());
  for (Index cell = 0; cell < mesh_.cell_count(); ++cell) {
    const auto& nodes = mesh_.cells()[cell];
    for (int i = 0; i < n; ++i) {
      double sum = 0;
      for (int j = 0; j < n; ++j) sum += cells_[cell][n * i + j] * x[nodes[j]];
      result[nodes[i]] += sum;
    }
  }
  return result;
}

Eigen::VectorXd MassMatrix::solve(const Eigen::VectorXd& load, const Eigen::VectorXd& start,
                                  const std::vector<bool>& given) const {
  constexpr int most = 60;
  constexpr double tolerance = 1e-28;  // square of the relative residual
  if (!(diagonal_.minCoeff() > 0)) return start;
  const auto leave_out = [&](Eigen::VectorXd vector) {
    for (std::size_t i = 0; i < given.size(); ++i)
      if (given[i]) vector[static_cast<Index>(i)] = 0;
    return vector;
  };
  Eigen::VectorXd x = start, residual = leave_out(load - multiply(x)),
                  preconditioned = residual.cwiseQuotient(diagonal_), direction = preconditioned;
  const double whole = load.dot(load.cwiseQuotient(diagonal_));
  double square = residual.dot(preconditioned);
  for (int i = 0; i < most && square > tolerance * whole; ++i) {
    const Eigen::VectorXd image = leave_out(multiply(direction));
    const double curvature = direction.dot(image);
    if (!(curvature > 0)) return start;
    x += square / curvature * direction;
    residual -= square / curvature * image;
    preconditioned = residual.cwiseQuotient(diagonal_);
    const double next = residual.dot(preconditioned);
    direction = preconditioned + next / square * direction;
    square = next;
  }
  return x;
}

}  // namespace parison::remesh
