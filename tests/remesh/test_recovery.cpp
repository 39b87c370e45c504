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

/// Steps from -1 to 1 across the circle of the given radius about the origin, within about `width`.
Field layer(double radius, double width) {
  return {[=](const Point& x) { return std::tanh((x.norm() - radius) / width); },
          [=](const Point& x) {
            const double c = std::cosh((x.norm() - radius) / width);
            return Point(x / (x.norm() * width * c * c));
          }};
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
  return gradient_error(mesh, geometry, nodal).cell.norm() / true_error(mesh, geometry, nodal, smooth()).norm();
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
    error.push_back(gradient_error(mesh, Geometry::planar, galerkin(mesh, Geometry::planar, smooth())).relative());
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
  const DerivativeError error = gradient_error(mesh, Geometry::axisymmetric, nodal);
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

Criteria wide_criteria(const Mesh& mesh) {
  Criteria criteria{Geometry::planar, 0.1, 0.1, 0.5, 0.5, 1e-3, {}, {}, {}, {}};
  criteria.straight_boundaries.assign(mesh.boundaries().size(), false);
  criteria.contact.assign(mesh.nodes.size(), false);
  return criteria;
}

struct Adapted {
  Mesh mesh;
  Eigen::VectorXd error;  ///< true, per cell
  double relative = 0;    ///< of the body, true
  /// Share of the cells that hold half of the squared error.
  double half() const {
    std::vector<double> squares(error.size());
    for (Index i = 0; i < error.size(); ++i) squares[i] = error[i] * error[i];
    std::sort(squares.rbegin(), squares.rend());
    double left = 0.5 * error.squaredNorm(), count = 0;
    for (; left > 0; ++count) left -= squares[static_cast<std::size_t>(count)];
    return count / static_cast<double>(squares.size());
  }
};

Adapted judged(Mesh mesh, const Field& field) {
  Adapted result{std::move(mesh), {}};
  const Eigen::VectorXd nodal = galerkin(result.mesh, Geometry::planar, field);
  result.error = true_error(result.mesh, Geometry::planar, nodal, field);
  result.relative = result.error.norm() / gradient_error(result.mesh, Geometry::planar, nodal).derivative;
  return result;
}

/// From a uniform mesh, by so many remeshes.
Adapted adapted(const Field& field, double wanted, int times, double max_cells = 1e6) {
  Mesh mesh = quarter_ring(0.1);
  for (int i = 0; i < times; ++i) {
    Criteria criteria = wide_criteria(mesh);
    criteria.max_cells = max_cells;
    const auto error = gradient_error(mesh, Geometry::planar, galerkin(mesh, Geometry::planar, field));
    const Eigen::VectorXd sizes = equidistributing_sizes(mesh, error, wanted);
    criteria.target_cell_size.assign(sizes.begin(), sizes.end());
    const Remeshed made = remesh_glass(mesh, criteria);
    EXPECT_TRUE(made.ok) << made.reason;
    mesh = made.mesh;
  }
  return judged(std::move(mesh), field);
}

TEST(Recovery, two_remeshes_reach_the_wanted_error_of_a_layer_with_a_seventh_of_the_cells_of_even_ones) {
  const Field field = layer(1, 0.02);
  const Adapted start = judged(quarter_ring(0.1), field), end = adapted(field, 0.02, 2),
                even = judged(quarter_ring(0.0125), field);
  EXPECT_GT(start.relative, 0.5);
  EXPECT_LT(end.relative, 0.02);
  EXPECT_GT(end.relative, 0.01);
  EXPECT_LE(end.relative, 1.01 * even.relative);
  EXPECT_LT(7 * end.mesh.cell_count(), even.mesh.cell_count());
  EXPECT_GT(end.half(), 10 * even.half());
  EXPECT_GT(end.half(), 4 * start.half());
}

TEST(Recovery, within_a_node_budget_the_error_of_a_layer_is_a_fifth_of_that_of_even_cells) {
  const Field field = layer(1, 0.02);
  const Adapted held = adapted(field, 0.02, 2, 1000), even = judged(quarter_ring(0.0575), field);
  EXPECT_LT(held.mesh.cell_count(), even.mesh.cell_count() + 50);
  EXPECT_LT(5 * held.relative, even.relative);
}

TEST(Recovery, a_field_that_changes_by_rounding_only_asks_for_no_cells) {
  const Mesh mesh = quarter_ring(0.03);
  Eigen::VectorXd warm = Eigen::VectorXd::Constant(mesh.node_count(), 1423.0);
  Eigen::VectorXd falling = Eigen::VectorXd::Zero(2 * mesh.node_count());
  for (Index n = 0; n < mesh.node_count(); ++n) warm[n] += 1e-12 * n, falling[2 * n + 1] = -0.3 - 1e-16 * n;
  for (const DerivativeError& error :
       {gradient_error(mesh, Geometry::planar, warm), rate_error(mesh, Geometry::planar, falling)})
    EXPECT_EQ(equidistributing_sizes(mesh, error, 0.1).minCoeff(), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace parison::remesh
