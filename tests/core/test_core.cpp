// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/case/table.hpp"
#include "core/linear/cholesky.hpp"
#include "core/linear/elimination_order.hpp"
#include "core/linear/indefinite.hpp"
#include "core/linear/sparse_matrix.hpp"
#include "core/mesh/cell_map.hpp"
#include "core/mesh/element.hpp"
#include "core/mesh/mesh.hpp"
#include "core/mesh/profile.hpp"

namespace parison::core {
namespace {

Mesh unit_square(Index n) {
  std::vector<Point> x;
  std::vector<std::array<Index, 3>> cells;
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i) x.push_back({double(i) / n, double(j) / n});
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      cells.push_back({a, a + 1, a + n + 2});
      cells.push_back({a, a + n + 2, a + n + 1});
    }
  return make_quadratic_mesh(x, cells);
}

TEST(Element, rules_integrate_the_monomials_they_promise) {
  for (const int degree : {2, 4, 5, 6})
    for (int p = 0; p <= degree; ++p)
      for (int q = 0; p + q <= degree; ++q) {
        double sum = 0;
        for (const auto& at : triangle_rule(degree)) sum += at.weight * std::pow(at.a, p) * std::pow(at.b, q);
        EXPECT_NEAR(sum, std::tgamma(p + 1) * std::tgamma(q + 1) / std::tgamma(p + q + 3), 1e-14);
      }
  for (int points = 1; points <= 5; ++points)
    for (int p = 0; p < 2 * points; ++p) {
      double sum = 0;
      for (const auto& at : edge_rule(points)) sum += at.weight * std::pow(at.s, p);
      EXPECT_NEAR(sum, 1.0 / (p + 1), 1e-15) << points << " " << p;
    }
}

TEST(Element, shape_functions_are_nodal_and_their_derivatives_are_right) {
  const std::array<std::array<double, 2>, 6> at{{{0, 0}, {1, 0}, {0, 1}, {.5, 0}, {.5, .5}, {0, .5}}};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) EXPECT_NEAR(triangle_shape(at[i][0], at[i][1])[j], i == j, 1e-15);
  const double a = 0.21, b = 0.37, e = 1e-6;
  const auto d = triangle_shape_derivative(a, b);
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(d[i][0], (triangle_shape(a + e, b)[i] - triangle_shape(a - e, b)[i]) / (2 * e), 1e-9);
    EXPECT_NEAR(d[i][1], (triangle_shape(a, b + e)[i] - triangle_shape(a, b - e)[i]) / (2 * e), 1e-9);
  }
}

TEST(Element, cell_map_is_inverted_inside_curved_cells) {
  Mesh mesh = unit_square(1);
  mesh.nodes[mesh.boundary_edges()[0].nodes[2]] += Point(0.05, -0.08);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto at = map_cell_point(mesh, cell, Geometry::planar, {0.3, 0.5, 1});
    const auto found = invert_cell_map(mesh, cell, at.position);
    EXPECT_NEAR(found[0], 0.3, 1e-12);
    EXPECT_NEAR(found[1], 0.5, 1e-12);
  }
}

TEST(Mesh, boundary_is_one_chain_with_the_body_on_the_left) {
  const Mesh mesh = unit_square(3);
  ASSERT_EQ(mesh.boundary_edges().size(), 12u);
  Point outward_flux = Point::Zero();
  double divergence = 0;
  for (std::size_t i = 0; i < mesh.boundary_edges().size(); ++i) {
    EXPECT_EQ(mesh.boundary_edges()[i].nodes[1], mesh.boundary_edges()[(i + 1) % 12].nodes[0]);
    for (const auto& at : edge_rule(2)) {
      const auto p = map_edge_point(mesh, mesh.boundary_edges()[i].nodes, Geometry::planar, at);
      outward_flux += p.area * p.normal;
      divergence += p.area * p.normal.dot(p.position);
    }
  }
  EXPECT_NEAR(outward_flux.norm(), 0, 1e-14);
  EXPECT_NEAR(divergence, 2, 1e-14);  // int x.n = 2 V
  EXPECT_NEAR(volume(mesh, Geometry::planar), 1, 1e-14);
  EXPECT_NEAR(volume(mesh, Geometry::axisymmetric), M_PI, 1e-13);
}

TEST(Mesh, volume_is_that_of_the_curved_cells_and_the_mean_is_weighed_with_it) {
  Mesh mesh = unit_square(3);
  for (Point& x : mesh.nodes) x = {0.7 + x[0] + 0.1 * x[1] * x[1], 5 + x[1] - 0.2 * x[0] * (1 - x[0])};
  const Eigen::VectorXd field = Eigen::VectorXd::LinSpaced(mesh.node_count(), 300, 1500);
  for (const auto geometry : {Geometry::planar, Geometry::axisymmetric}) {
    double sum = 0, content = 0;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
      for (const auto& at : triangle_rule(6)) {
        const auto p = map_cell_point(mesh, cell, geometry, at);
        sum += p.volume;
        for (int k = 0; k < 6; ++k) content += p.volume * p.shape[k] * field[mesh.cells()[cell][k]];
      }
    EXPECT_NEAR(volume(mesh, geometry) / sum, 1, 1e-14);
    EXPECT_NEAR(volume_mean(mesh, geometry, field), content / sum, 1e-10);
    EXPECT_EQ(volume_mean(mesh, geometry, Eigen::VectorXd::Constant(mesh.node_count(), 1 / 3.0)), 1 / 3.0);
  }
}

TEST(Cholesky, recovers_a_known_solution_and_refuses_a_negative_definite_matrix) {
  const Mesh mesh = unit_square(6);
  Cliques cliques;
  for (const auto& cell : mesh.cells()) cliques.add(cell.data(), 6);
  Assembly assembly = make_assembly(mesh.node_count(), cliques);
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    std::array<double, 36> local{};
    for (const auto& at : triangle_rule(4)) {
      const auto p = map_cell_point(mesh, c, Geometry::planar, at);
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
          local[6 * i + j] += p.volume * (p.gradient[i].dot(p.gradient[j]) + 10 * p.shape[i] * p.shape[j]);
    }
    add_clique(assembly.matrix, assembly.scatter, c, 6, local.data());
  }
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(mesh.node_count(), -1, 2);
  const Eigen::VectorXd b = multiply(assembly.matrix, x);
  Cholesky cholesky;
  cholesky.analyse(assembly.matrix);
  ASSERT_TRUE(cholesky.factorise(assembly.matrix));
  EXPECT_LT((cholesky.solve(b) - x).norm(), 1e-11 * x.norm());
  for (auto& v : assembly.matrix.value) v = -v;
  EXPECT_FALSE(cholesky.factorise(assembly.matrix));
}

/// Pairs of nodes that are in one cell.
std::vector<std::array<Index, 2>> edges_of(const Mesh& mesh) {
  std::vector<std::array<Index, 2>> edges;
  for (const auto& cell : mesh.cells())
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < i; ++j) edges.push_back({cell[i], cell[j]});
  return edges;
}

TEST(IndefiniteSolver, takes_a_matrix_in_the_order_of_its_elimination_with_either_library) {
  const Mesh mesh = unit_square(6);
  const std::vector<Index> order = minimum_fill_order(std::vector<Index>(mesh.node_count(), 0), edges_of(mesh));
  std::vector<Index> rank(order.size());
  for (std::size_t k = 0; k < rank.size(); ++k) rank[order[k]] = static_cast<Index>(k);
  Cliques natural, ranked;
  for (const auto& cell : mesh.cells()) {
    auto places = cell;
    for (Index& place : places) place = rank[place];
    natural.add(cell.data(), 6);
    ranked.add(places.data(), 6);
  }
  Assembly lower = make_assembly(mesh.node_count(), natural);
  Assembly upper = make_assembly(mesh.node_count(), ranked, Triangle::upper);
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    std::array<double, 36> local;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        local[6 * i + j] = i == j ? (mesh.cells()[c][i] % 3 == 0 ? -9 : 9) : std::cos(c + i * j);
    add_clique(lower.matrix, lower.scatter, c, 6, local.data());
    add_clique(upper.matrix, upper.scatter, c, 6, local.data());
  }
  Eigen::MatrixXd x(mesh.node_count(), 2), b(mesh.node_count(), 2);
  x << Eigen::VectorXd::LinSpaced(mesh.node_count(), -1, 2), Eigen::VectorXd::LinSpaced(mesh.node_count(), 5, 1);
  for (int column = 0; column < 2; ++column) b.col(column) = multiply(lower.matrix, x.col(column));
  for (const auto library : {IndefiniteSolver::Library::cholmod, IndefiniteSolver::Library::mumps}) {
    IndefiniteSolver solver;
    solver.analyse_ordered(upper.matrix, order, library);
    ASSERT_TRUE(solver.factorise(upper.matrix));
    EXPECT_LT((solver.solve(b) - x).norm(), 1e-11 * x.norm());
  }
}

/// Operations of a factorisation of the graph in this order, and in that of approximate minimum degree.
std::array<double, 2> operations(const Mesh& mesh, const std::vector<Index>& order) {
  std::vector<Index> rank(order.size());
  for (std::size_t k = 0; k < rank.size(); ++k) rank[order[k]] = static_cast<Index>(k);
  Cliques natural, ranked;
  for (const auto& cell : mesh.cells()) {
    auto places = cell;
    for (Index& place : places) place = rank[place];
    natural.add(cell.data(), 6);
    ranked.add(places.data(), 6);
  }
  Cholesky given, by_degree;
  given.analyse_ordered(make_assembly(mesh.node_count(), ranked, Triangle::upper).matrix, order);
  by_degree.analyse(make_assembly(mesh.node_count(), natural).matrix);
  return {given.operations(), by_degree.operations()};
}

TEST(EliminationOrder, has_every_vertex_once_and_less_fill_than_minimum_degree) {
  EXPECT_TRUE(minimum_fill_order({}, {}).empty());
  EXPECT_EQ(minimum_fill_order({0, 1}, {}), (std::vector<Index>{1, 0}));
  const Mesh mesh = unit_square(24);
  const auto edges = edges_of(mesh);
  std::vector<Index> layer;  // from the boundary
  for (const Point& x : mesh.nodes)
    layer.push_back(static_cast<Index>(std::lround(48 * std::min({x[0], 1 - x[0], x[1], 1 - x[1]}))));
  const std::vector<Index> order = minimum_fill_order(layer, edges);
  std::vector<Index> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (Index k = 0; k < mesh.node_count(); ++k) ASSERT_EQ(sorted[k], k);
  auto twice = edges;  // named again, in the other direction
  for (const auto& [a, b] : edges) twice.push_back({b, a});
  EXPECT_EQ(minimum_fill_order(layer, twice), order);
  const auto [fill, degree] = operations(mesh, order);
  EXPECT_LT(fill, 0.9 * degree);
}

TEST(Table, interpolates_holds_its_ends_and_integrates) {
  const Table table{{1, 2, 4}, {10, 20, 0}};
  EXPECT_DOUBLE_EQ(table(0), 10);
  EXPECT_DOUBLE_EQ(table(1.5), 15);
  EXPECT_DOUBLE_EQ(table(9), 0);
  EXPECT_DOUBLE_EQ(table.derivative(3), -10);
  EXPECT_DOUBLE_EQ(table.integral(4), 35);
  EXPECT_DOUBLE_EQ(table.integral(0), -10);
  EXPECT_DOUBLE_EQ(constant(3)(7), 3);
  EXPECT_DOUBLE_EQ(constant(3).integral(7), 21);
}

/// Half disc of radius 2 on the right of the last coordinate's axis.
Profile half_disc() {
  Profile profile;
  profile.boundary_names = {"round", "axis"};
  profile.segments = {{{0, -2}, {0, 2}, true, {0, 0}, 2, -M_PI / 2, M_PI / 2, 0}, {{0, 2}, {0, -2}}};
  profile.segments[1].boundary_id = 1;
  return profile;
}

TEST(Profile, knows_area_inside_and_distance_of_arcs) {
  const Profile disc = half_disc();
  EXPECT_NEAR(signed_area(disc), 2 * M_PI, 1e-14);
  EXPECT_NEAR(signed_area(reversed(disc)), -2 * M_PI, 1e-14);
  EXPECT_TRUE(contains(disc, {1.9, 0}));
  EXPECT_TRUE(contains(disc, {0.1, 1.9}));
  EXPECT_FALSE(contains(disc, {2.01, 0}));
  EXPECT_FALSE(contains(disc, {-0.01, 0}));
  EXPECT_NEAR(distance(disc, {3, 0}), 1, 1e-14);
  EXPECT_NEAR(distance(disc, {0.5, 0}), 0.5, 1e-14);
  EXPECT_EQ(find_self_crossing(disc).first, -1);
  EXPECT_NEAR((normal_at(disc.segments[0], 0.5) - Point(1, 0)).norm(), 0, 1e-14);
}

TEST(Profile, contains_what_its_outline_turns_round_once) {
  Profile key;  // a bulge on the right, a bite out of the level top, a hollow foot
  key.boundary_names = {"all"};
  key.segments = {{{0, 0}, {1, 0}}, {{1, 0}, {3, 0}, true, {2, 0}, 1, M_PI, 0},
                  {{3, 0}, {4, 0}}, {{4, 0}, {4, 4}, true, {4, 2}, 2, -M_PI / 2, M_PI / 2},
                  {{4, 4}, {3, 4}}, {{3, 4}, {1, 4}, true, {2, 4}, 1, 0, -M_PI},
                  {{1, 4}, {0, 4}}, {{0, 4}, {0, 0}}};
  int inside = 0, compared = 0;
  for (double x = -0.5; x <= 6.5; x += 0.25)
    for (double y = -0.5; y <= 4.5; y += 0.25) {
      if (distance(key, {x, y}) < 1e-9) continue;
      const auto bitten = [&](double top) { return std::hypot(x - 2, y - top) < 1; };
      const bool expected =
          x > 0 && y > 0 && y < 4 && !bitten(0) && !bitten(4) && (x <= 4 || std::hypot(x - 4, y - 2) < 2);
      EXPECT_EQ(contains(key, {x, y}), expected) << x << ' ' << y;
      inside += expected;
      ++compared;
    }
  EXPECT_GT(inside, 100);
  EXPECT_GT(compared - inside, 100);
}

TEST(Profile, finds_the_segments_that_cross) {
  Profile bow;
  bow.boundary_names = {"all"};
  bow.segments = {{{0, 0}, {2, 2}}, {{2, 2}, {2, 0}}, {{2, 0}, {0, 2}}, {{0, 2}, {0, 0}}};
  EXPECT_EQ(find_self_crossing(bow), (std::pair<Index, Index>{0, 2}));
}

TEST(Profile, finds_an_outline_that_only_touches_itself) {
  Profile pinched;
  pinched.boundary_names = {"all"};
  pinched.segments = {{{0, 0}, {4, 0}}, {{4, 0}, {4, 2}}, {{4, 2}, {2, 0}}, {{2, 0}, {0, 2}}, {{0, 2}, {0, 0}}};
  EXPECT_EQ(find_self_crossing(pinched).first, 0);
}

}  // namespace
}  // namespace parison::core
