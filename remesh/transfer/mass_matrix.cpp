// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/transfer/mass_matrix.hpp"

#include "core/mesh/element.hpp"

namespace parison::remesh {

using core::Index;

/// Adds the lower triangle of a quadrature point.
void MassMatrix::add(Element& element, const double* shape, double measure) const {
  for (int i = 0; i < functions_; ++i)
    for (int j = 0; j <= i; ++j) element.values[functions_ * i + j] += shape[i] * shape[j] * measure;
}

/// Copies the lower triangle to the upper one and adds to the diagonal of all.
void MassMatrix::close(Element& element) {
  const int n = functions_;
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) element.values[n * i + j] = element.values[n * j + i];
    diagonal_[element.nodes[i]] += element.values[n * i + i];
  }
}

MassMatrix::MassMatrix(const core::Mesh& mesh, core::Geometry geometry)
    : functions_(6), diagonal_(Eigen::VectorXd::Zero(mesh.node_count())) {
  elements_.reserve(mesh.cells().size());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    Element& element = elements_.emplace_back(Element{mesh.cells()[cell], {}});
    for (const core::TriangleRulePoint& at : core::triangle_rule(6)) {
      const core::CellPoint point = core::map_cell_point(mesh, cell, geometry, at);
      add(element, point.shape.data(), point.volume);
    }
    close(element);
  }
}

MassMatrix::MassMatrix(const core::Mesh& mesh, core::Geometry geometry, const std::vector<core::BoundaryEdge>& edges)
    : functions_(3), diagonal_(Eigen::VectorXd::Zero(mesh.node_count())) {
  constexpr int points = 4;  // exact to degree 7: two quadratics, the radius and half of a curved edge's length
  elements_.reserve(edges.size());
  for (const core::BoundaryEdge& edge : edges) {
    Element& element = elements_.emplace_back(Element{{edge.nodes[0], edge.nodes[1], edge.nodes[2]}, {}});
    for (const core::EdgeRulePoint& at : core::edge_rule(points)) {
      const core::EdgePoint point = core::map_edge_point(mesh, edge.nodes, geometry, at);
      add(element, point.shape.data(), point.area);
    }
    close(element);
  }
  diagonal_ = (diagonal_.array() > 0).select(diagonal_, 1);
}

Eigen::VectorXd MassMatrix::multiply(const Eigen::VectorXd& x) const {
  const int n = functions_;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(x.size());
  for (const Element& element : elements_)
    for (int i = 0; i < n; ++i) {
      double sum = 0;
      for (int j = 0; j < n; ++j) sum += element.values[n * i + j] * x[element.nodes[j]];
      result[element.nodes[i]] += sum;
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
