// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "exact_flows.hpp"

namespace parison::flow {
namespace {

using core::Geometry;
using core::Mesh;

// Published: ASPECT, Q2-Q1 quadrilaterals, 16 x 16, L2 over the domain; 2467 unknowns of flow.
constexpr Index published_unknowns = 2467;
constexpr double published_cx = 1.670e-6, published_cx_pressure = 9.778e-3, published_kz = 2.638e-7,
                 published_kz_pressure = 1.070e-3, published_vi = 0.128;

Index unknowns(const Mesh& mesh) { return core::dim * mesh.node_count() + mesh.vertex_count; }

/// The unit square between slipping walls, its rectangles all cut from lower left to upper right.
FlowProblem slipping_square(Index columns, Index rows, const std::function<double(double)>& height) {
  std::vector<Point> x;
  std::vector<std::array<Index, 3>> cells;
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= columns; ++i) x.push_back({double(i) / columns, double(j) / rows});
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i, above = a + columns + 1;
      cells.push_back({a, a + 1, above + 1});
      cells.push_back({a, above + 1, above});
    }
  Mesh mesh = core::make_quadratic_mesh(x, cells);
  for (auto& node : mesh.nodes) node[1] = height(node[1]);
  FlowProblem flow(std::move(mesh), Geometry::planar);
  flow.hold_all(PieceCondition::Kind::symmetry);
  return flow;
}

FlowErrors report(const char* name, FlowProblem& flow, const ExactFlow& exact) {
  const auto solution = flow.solve();
  EXPECT_TRUE(solution.converged) << solution.reason;
  const auto errors = flow_errors(flow, solution, exact);
  std::printf("%s, %d unknowns: velocity %.3e, pressure %.3e\n", name, unknowns(flow.mesh), errors.velocity, errors.pressure);
  return errors;
}

FlowErrors cx_errors(Index columns, Index rows, double jump) {
  FlowProblem flow = slipping_square(columns, rows, [](double y) { return y; });
  flow.problem.viscosity = [=](const Point& x) { return x[0] < 0.5 ? 1.0 : jump; };
  flow.problem.force = [](const Point& x) { return Point(0, std::sin(M_PI * x[1]) * std::cos(M_PI * x[0])); };
  EXPECT_LE(unknowns(flow.mesh), published_unknowns);
  char name[40];
  std::snprintf(name, sizeof name, "SolCx %.0e, %d x %d", jump, columns, rows);
  return report(name, flow, sol_cx(jump));
}

FlowErrors kz_errors(Index n, double to_walls) {
  FlowProblem flow =
      slipping_square(n, n, [=](double y) { return y - to_walls * std::sin(2 * M_PI * y) / (2 * M_PI); });
  flow.problem.viscosity = [](const Point& x) { return std::pow(1e6, x[1]); };
  flow.problem.force = [](const Point& x) { return Point(0, std::sin(2 * x[1]) * std::cos(3 * M_PI * x[0])); };
  char name[60];
  std::snprintf(name, sizeof name, "SolKz, %d x %d, rows by the walls %.2f of the mean", n, n, 1 - to_walls);
  return report(name, flow, sol_kz(1e6));
}

TEST(StokesBenchmarks, solcx_is_closer_than_published_with_fewer_unknowns) {
  const auto square = cx_errors(16, 16, 1e6), coarse = cx_errors(8, 8, 1e6), narrow = cx_errors(20, 12, 1e6);
  EXPECT_GT(std::log2(coarse.velocity / square.velocity), 2.9);
  EXPECT_LT(square.velocity, 1.3 * published_cx);  // squares cut in two know less than Q2 squares of as many unknowns
  EXPECT_LE(square.pressure, published_cx_pressure);
  EXPECT_LE(narrow.velocity, published_cx);
  EXPECT_LE(narrow.pressure, published_cx_pressure);
}

TEST(StokesBenchmarks, solcx_is_the_same_at_a_jump_of_ten_decades) {
  const auto six = cx_errors(16, 16, 1e6), ten = cx_errors(16, 16, 1e10);
  EXPECT_LT(ten.velocity, 1.01 * six.velocity);
  EXPECT_LT(ten.pressure, 1.01 * six.pressure);
}

TEST(StokesBenchmarks, solkz_is_closer_than_published_with_rows_narrower_by_the_walls) {
  const auto even = kz_errors(16, 0), fine = kz_errors(32, 0), graded = kz_errors(16, 0.36);
  EXPECT_GT(std::log2(even.velocity / fine.velocity), 2.8);
  EXPECT_LT(even.velocity, 1.2 * published_kz);
  EXPECT_LT(even.pressure, 1.2 * published_kz_pressure);
  EXPECT_LE(graded.velocity, published_kz);
  EXPECT_LE(graded.pressure, published_kz_pressure);
}

constexpr double vi_radius = 0.2, vi_jump = 1e3;

/// The square from -1 to 1 with exact velocities on its sides.
FlowErrors vi_errors(const char* name, Mesh mesh) {
  FlowProblem flow(std::move(mesh), Geometry::planar);
  const auto exact = sol_vi(vi_jump, vi_radius);
  flow.hold_all(PieceCondition::Kind::fixed);
  for (auto& piece : flow.problem.pieces) piece.velocity = exact.velocity;
  flow.problem.viscosity = [](const Point& x) { return x.norm() < vi_radius ? vi_jump : 1.0; };
  EXPECT_LE(unknowns(flow.mesh), published_unknowns);
  return report(name, flow, exact);
}

/// Carries the square of half side 1/4 to the disc of the inclusion, the sides of the outer square staying.
Point around_inclusion(double s, double t) {
  const Point x(2 * s - 1, 2 * t - 1);
  const double ring = x.lpNorm<Eigen::Infinity>(), inner = 0.25;
  if (ring == 0) return x;
  const Point square = x / ring, circle = vi_radius * x / x.norm();
  if (ring > inner) return circle + (ring - inner) / (1 - inner) * (square - circle);
  const double share = ring / inner;
  return share * (share * circle + (1 - share) * vi_radius * square / std::sqrt(2.0));
}

TEST(StokesBenchmarks, solvi_is_closer_than_published_whether_or_not_the_mesh_follows_the_inclusion) {
  const auto through = vi_errors("SolVi, 16 x 16 across the inclusion",
                                 tests::structured(16, 16, [](double s, double t) { return Point(2 * s - 1, 2 * t - 1); }));
  const auto along = vi_errors("SolVi, 16 x 16 following it", tests::structured(16, 16, around_inclusion));
  EXPECT_LE(through.velocity, published_vi);
  EXPECT_LE(along.velocity, published_vi / 20);
}

}  // namespace
}  // namespace parison::flow
