// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "exact_flows.hpp"
#include "figure.hpp"
#include "remesh/mesher/mesh_profile.hpp"

namespace parison::flow {
namespace {

using core::Geometry;
using core::Mesh;

// Published: ASPECT, Q2-Q1 quadrilaterals, 16 x 16; the velocity vector and the pressure of mean zero in L2 over the
// domain; 2467 unknowns of flow.
constexpr Index published_unknowns = 2467;
constexpr double published_cx = 1.670e-6, published_cx_pressure = 9.778e-3, published_kz = 2.638e-7,
                 published_kz_pressure = 1.070e-3, published_vi = 0.128;

Index unknowns(const Mesh& mesh) {
  return core::dim * mesh.node_count() + mesh.vertex_count();
}

/// A straight-sided mesh to be made quadratic.
struct Triangles {
  std::vector<Point> vertices;
  std::vector<std::array<Index, 3>> cells;
};

/// The unit square cut into n x n squares, and these all from lower left to upper right.
Triangles cut_squares(Index n) {
  Triangles made;
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i) made.vertices.push_back({double(i) / n, double(j) / n});
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i, above = a + n + 1;
      made.cells.push_back({a, a + 1, above + 1});
      made.cells.push_back({a, above + 1, above});
    }
  return made;
}

/// What the program's own mesher makes of the rectangle from x = `from` to `to` with edges of `size`, and of
/// `line_size` on the line x = 1/2 and growing from there.
Mesh own_mesh(double from, double to, double size, double line_size) {
  constexpr double growth = 0.5;
  const std::array<Point, 4> corners{Point(from, 0), Point(to, 0), Point(to, 1), Point(from, 1)};
  core::Profile profile;
  profile.boundary_names = {"wall", "line"};
  for (int i = 0; i < 4; ++i) {
    core::Segment side;
    side.start = corners[i], side.end = corners[(i + 1) % 4];
    side.boundary_id = side.start[0] == 0.5 && side.end[0] == 0.5;
    profile.segments.push_back(side);
  }
  return remesh::mesh_profile(profile, {size, line_size, growth, {false, true}});
}

/// One mesh of parts that share the vertices in which they meet.
Triangles united(const std::vector<Mesh>& parts) {
  Triangles made;
  constexpr double same_point = 1e-9;
  std::map<std::pair<long, long>, Index> known;
  for (const Mesh& part : parts) {
    std::vector<Index> number;
    for (Index v = 0; v < part.vertex_count(); ++v) {
      const std::pair place(std::lround(part.nodes[v][0] / same_point), std::lround(part.nodes[v][1] / same_point));
      const auto [at, fresh] = known.insert({place, Index(made.vertices.size())});
      if (fresh) made.vertices.push_back(part.nodes[v]);
      number.push_back(at->second);
    }
    for (const auto& cell : part.cells()) made.cells.push_back({number[cell[0]], number[cell[1]], number[cell[2]]});
  }
  return made;
}

Mesh square_mesh(const Triangles& made) {
  return core::make_quadratic_mesh(made.vertices, made.cells);
}

/// The finest mesh, of sizes a hundredth apart, with no more unknowns than the published one.
Mesh finest(const std::function<Triangles(double size)>& make) {
  Mesh last;
  for (double size = 0.08;; size *= 0.99) {
    Mesh mesh = square_mesh(make(size));
    if (unknowns(mesh) > published_unknowns) return last;
    last = std::move(mesh);
  }
}

/// The unit square between slipping walls.
FlowProblem slipping_square(Mesh mesh) {
  FlowProblem flow(std::move(mesh), Geometry::planar);
  flow.hold_all(BoundaryCondition::Kind::symmetry);
  return flow;
}

FlowErrors report(const char* name, FlowProblem& flow, const ExactFlow& exact) {
  const auto solution = flow.solve();
  EXPECT_TRUE(solution.converged) << solution.reason;
  const auto errors = flow_errors(flow, solution, exact);
  std::printf("%s, %d unknowns: velocity %.3e, pressure %.3e\n", name, unknowns(flow.mesh), errors.velocity,
              errors.pressure);
  return errors;
}

FlowErrors cx_errors(const char* name, Mesh mesh, double jump) {
  FlowProblem flow = slipping_square(std::move(mesh));
  flow.problem.viscosity = [=](const Point& x) { return x[0] < 0.5 ? 1.0 : jump; };
  flow.problem.force = [](const Point& x) { return Point(0, std::sin(M_PI * x[1]) * std::cos(M_PI * x[0])); };
  return report(name, flow, sol_cx(jump));
}

FlowErrors kz_errors(const char* name, Mesh mesh) {
  FlowProblem flow = slipping_square(std::move(mesh));
  flow.problem.viscosity = [](const Point& x) { return std::pow(1e6, x[1]); };
  flow.problem.force = [](const Point& x) { return Point(0, std::sin(2 * x[1]) * std::cos(3 * M_PI * x[0])); };
  return report(name, flow, sol_kz(1e6));
}

/// The program's mesh of both halves, its edges twice as long where the viscosity is 1e6 times as high.
Mesh sized_by_viscosity() {
  return finest([](double h) { return united({own_mesh(0, 0.5, h, h), own_mesh(0.5, 1, 2 * h, h)}); });
}

/// The program's uniform mesh of the square.
Mesh uniform() {
  return finest([](double h) { return united({own_mesh(0, 1, h, h)}); });
}

TEST(StokesBenchmarks, solcx_is_closer_than_published_on_a_mesh_sized_by_the_viscosity) {
  const auto square = cx_errors("SolCx 1e6, 16 x 16 cut squares", square_mesh(cut_squares(16)), 1e6);
  const auto coarse = cx_errors("SolCx 1e6, 8 x 8 cut squares", square_mesh(cut_squares(8)), 1e6);
  const auto sized = cx_errors("SolCx 1e6, sized by the viscosity", sized_by_viscosity(), 1e6);
  EXPECT_GT(std::log2(coarse.velocity / square.velocity), 2.9);
  EXPECT_LT(square.velocity, 1.3 * published_cx);  // squares cut in two know less than Q2 squares of as many unknowns
  EXPECT_LE(square.pressure, published_cx_pressure);
  tests::expect_at_most("SolCx, jump of 1e6, mesh sized by the viscosity, unknowns as published: velocity",
                        sized.velocity, published_cx);
  tests::expect_at_most("the same: pressure", sized.pressure, published_cx_pressure);
}

TEST(StokesBenchmarks, solcx_is_the_same_at_a_jump_of_ten_decades) {
  tests::Figure ratio("SolCx, errors at a jump of 1e10 over those at 1e6");
  for (const Mesh& mesh : {square_mesh(cut_squares(16)), sized_by_viscosity()}) {
    const auto six = cx_errors("SolCx 1e6", mesh, 1e6), ten = cx_errors("SolCx 1e10", mesh, 1e10);
    ratio.add(ten.velocity / six.velocity);
    ratio.add(ten.pressure / six.pressure);
  }
  ratio.at_most(1.01);
}

TEST(StokesBenchmarks, solkz_is_closer_than_published_on_a_uniform_mesh) {
  const auto even = kz_errors("SolKz, 16 x 16 cut squares", square_mesh(cut_squares(16)));
  const auto fine = kz_errors("SolKz, 32 x 32 cut squares", square_mesh(cut_squares(32)));
  const auto own = kz_errors("SolKz, uniform", uniform());
  EXPECT_GT(std::log2(even.velocity / fine.velocity), 2.8);
  EXPECT_LT(even.velocity, 1.2 * published_kz);
  EXPECT_LT(even.pressure, 1.2 * published_kz_pressure);
  tests::expect_at_most("SolKz, uniform mesh, unknowns as published: velocity", own.velocity, published_kz);
  tests::expect_at_most("the same: pressure", own.pressure, published_kz_pressure);
}

constexpr double vi_radius = 0.2, vi_jump = 1e3;

/// The square from -1 to 1 with exact velocities on its sides.
FlowErrors vi_errors(const char* name, Mesh mesh) {
  FlowProblem flow(std::move(mesh), Geometry::planar);
  const auto exact = sol_vi(vi_jump, vi_radius);
  flow.hold_all(BoundaryCondition::Kind::fixed);
  for (auto& boundary : flow.problem.boundary_conditions) boundary.velocity = exact.velocity;
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
  const double fraction = ring / inner;
  return fraction * (fraction * circle + (1 - fraction) * vi_radius * square / std::sqrt(2.0));
}

TEST(StokesBenchmarks, solvi_is_closer_than_published_whether_or_not_the_mesh_follows_the_inclusion) {
  const auto through =
      vi_errors("SolVi, 16 x 16 across the inclusion",
                tests::structured(16, 16, [](double s, double t) { return Point(2 * s - 1, 2 * t - 1); }));
  const auto along = vi_errors("SolVi, 16 x 16 following it", tests::structured(16, 16, around_inclusion));
  tests::expect_at_most("SolVi, 16 x 16 across the inclusion: velocity", through.velocity, published_vi);
  EXPECT_LE(along.velocity, published_vi / 20);
}

}  // namespace
}  // namespace parison::flow
