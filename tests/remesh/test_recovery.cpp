// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/mesh/element.hpp"
#include "figure.hpp"
#include "remesh/mesher/mesh_profile.hpp"
#include "remesh/profiles.hpp"
#include "remesh/remesh_glass.hpp"
#include "remesh/sizing/recovery.hpp"
#include "structured.hpp"

namespace parison::remesh {
namespace {

using core::Geometry;
using core::Index;
using core::Mesh;
using core::Point;

/// A function of space with its gradient.
struct Field {
  std::function<double(const Point&)> value;
  std::function<Point(const Point&)> gradient;
};

Field smooth() {
  return {[](const Point& x) { return std::sin(3 * x[0]) * std::exp(x[1]); },
          [](const Point& x) { return Point(std::exp(x[1]) * Point(3 * std::cos(3 * x[0]), std::sin(3 * x[0]))); }};
}

/// The field that Galerkin's method finds for a Poisson equation with this solution, exact on the boundary.
Eigen::VectorXd galerkin(const Mesh& mesh, Geometry geometry, const Field& field) {
  Eigen::VectorXd solution(mesh.node_count()), load = Eigen::VectorXd::Zero(mesh.node_count());
  for (Index n = 0; n < mesh.node_count(); ++n) solution[n] = field.value(mesh.nodes[n]);
  std::vector<bool> given(mesh.nodes.size(), false);
  for (const auto& edge : mesh.boundary_edges())
    for (const Index n : edge.nodes) given[n] = true;
  std::vector<Eigen::Triplet<double>> entries;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (const auto& at : core::triangle_rule(6)) {
      const auto point = core::map_cell_point(mesh, cell, geometry, at);
      const auto& nodes = mesh.cells()[cell];
      for (int i = 0; i < 6; ++i) {
        if (given[nodes[i]]) continue;
        load[nodes[i]] += point.volume * point.gradient[i].dot(field.gradient(point.position));
        for (int j = 0; j < 6; ++j) {
          const double entry = point.volume * point.gradient[i].dot(point.gradient[j]);
          if (given[nodes[j]])
            load[nodes[i]] -= entry * solution[nodes[j]];
          else
            entries.emplace_back(nodes[i], nodes[j], entry);
        }
      }
    }
  for (Index n = 0; n < mesh.node_count(); ++n)
    if (given[n]) entries.emplace_back(n, n, 1), load[n] = solution[n];
  Eigen::SparseMatrix<double> matrix(mesh.node_count(), mesh.node_count());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(load);
}

/// The estimate of a velocity with this component alone: its rate of deformation is the gradient, with half the square
/// of the part across the component; across the axis there is the hoop's besides.
DerivativeError estimate(const Mesh& mesh, Geometry geometry, const Eigen::VectorXd& nodal, int component = 1) {
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(2 * mesh.node_count());
  for (Index n = 0; n < mesh.node_count(); ++n) velocity[2 * n + component] = nodal[n];
  return rate_error(mesh, geometry, velocity);
}

/// Root of the integral of the gradient's squared error over each cell.
Eigen::VectorXd true_error(const Mesh& mesh, Geometry geometry, const Eigen::VectorXd& nodal, const Field& field) {
  Eigen::VectorXd error = Eigen::VectorXd::Zero(mesh.cell_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (const auto& at : core::triangle_rule(6)) {
      const auto point = core::map_cell_point(mesh, cell, geometry, at);
      Point difference = -field.gradient(point.position);
      for (int i = 0; i < 6; ++i) difference += nodal[mesh.cells()[cell][i]] * point.gradient[i];
      error[cell] += point.volume * difference.squaredNorm();
    }
  return error.cwiseSqrt();
}

Mesh distorted(Index n) {
  return tests::structured(n, n, [](double a, double b) {
    return Point(0.5 + a + 0.05 * std::sin(4 * b + 2 * a), b + 0.1 * a * a + 0.04 * std::sin(5 * a));
  });
}

/// A quarter of a ring, meshed without structure.
core::Profile quarter_ring() {
  return Pen(500, 0)
      .line(1500, 0, "low")
      .arc(0, 0, 0, 90, "outer")
      .line(0, 500, "left")
      .arc(0, 0, 90, 0, "inner")
      .closed();
}

Mesh quarter_ring(double size) {
  return mesh_profile(quarter_ring(), {size, size, 0.3, std::vector<bool>(4, false)});
}

double effectivity(const Mesh& mesh, Geometry geometry) {
  const Eigen::VectorXd nodal = galerkin(mesh, geometry, smooth());
  // Both components count the square of the gradient one and a half times.
  const double estimated =
      std::hypot(estimate(mesh, geometry, nodal, 0).cell.norm(), estimate(mesh, geometry, nodal, 1).cell.norm());
  return estimated / (std::sqrt(1.5) * true_error(mesh, geometry, nodal, smooth()).norm());
}

TEST(Recovery, the_effectivity_comes_within_one_percent_of_one_on_structured_meshes_and_two_on_others) {
  tests::Figure structured("estimated over true error of the gradient, structured meshes: off 1 by"),
      unstructured("the same on meshes without structure: off 1 by");
  for (const Geometry geometry : {Geometry::planar, Geometry::axisymmetric}) {
    EXPECT_NEAR(effectivity(distorted(4), geometry), 1, 0.35);
    EXPECT_NEAR(effectivity(distorted(8), geometry), 1, 0.08);
    for (const Index n : {16, 32}) structured.add(std::abs(effectivity(distorted(n), geometry) - 1));
    for (const double size : {0.075, 0.0375}) unstructured.add(std::abs(effectivity(quarter_ring(size), geometry) - 1));
  }
  structured.at_most(0.01);
  unstructured.at_most(0.02);
}

TEST(Recovery, the_estimate_falls_with_the_square_of_the_edge) {
  std::vector<double> error;
  for (const Index n : {8, 16, 32}) {
    const Mesh mesh = distorted(n);
    error.push_back(estimate(mesh, Geometry::planar, galerkin(mesh, Geometry::planar, smooth())).relative());
  }
  EXPECT_NEAR(std::log2(error[1] / error[2]), 2, 0.05);
}

TEST(Recovery, a_quadratic_field_has_no_error) {
  const Mesh mesh = tests::structured(5, 4, [](double a, double b) { return Point(1 + a + 0.3 * b, b); });
  Eigen::VectorXd nodal(mesh.node_count());
  for (Index n = 0; n < mesh.node_count(); ++n) {
    const Point& x = mesh.nodes[n];
    nodal[n] = 3 * x[0] * x[0] - x[0] * x[1] + 2 * x[1];
  }
  const DerivativeError error = estimate(mesh, Geometry::axisymmetric, nodal);
  EXPECT_LT(error.relative(), 1e-9);
  EXPECT_GT(error.derivative, 1);
}

/// What of a velocity's gradient is no deformation must not count; a pure rotation deforms nothing.
TEST(Recovery, a_rotation_has_no_rate_of_deformation_and_a_squeeze_its_own) {
  const Mesh mesh = quarter_ring(0.2);
  Eigen::VectorXd turning(2 * mesh.node_count()), squeeze(2 * mesh.node_count());
  for (Index n = 0; n < mesh.node_count(); ++n) {
    const Point& x = mesh.nodes[n];
    turning.segment<2>(2 * n) << -x[1], x[0];
    squeeze.segment<2>(2 * n) << x[0], -2 * x[1];
  }
  EXPECT_LT(rate_error(mesh, Geometry::planar, turning).derivative, 1e-9);
  const DerivativeError error = rate_error(mesh, Geometry::axisymmetric, squeeze);
  EXPECT_LT(error.relative(), 1e-9);
  EXPECT_NEAR(error.derivative / std::sqrt(6 * core::volume(mesh, Geometry::axisymmetric)), 1, 1e-9);
}

}  // namespace
}  // namespace parison::remesh
