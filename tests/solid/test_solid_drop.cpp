// SPDX-License-Identifier: GPL-3.0-or-later
// A viscous drop returns to a ball by surface tension: each surface mode of degree l, whatever its order m, at the rate
// l (l + 2) (2 l + 1) / (2 (2 l^2 + 4 l + 3)) sigma / (mu R), without inertia (H. Lamb, Hydrodynamics, 355).
#include <gtest/gtest.h>

#include <cmath>

#include "figure.hpp"
#include "solid/hex_block.hpp"

namespace parison::tests {
namespace {

constexpr double core_share = 0.45;  ///< of the ball's radius: half the side of the cube of cells in its middle

/// Adds the cells of another mesh; nodes at the same place become one.
void join(core::HexMesh& mesh, const core::HexMesh& other) {
  std::vector<Index> number;
  const Index own = mesh.node_count();
  for (const Vector3& x : other.nodes) {
    Index found = 0;
    while (found < own && (mesh.nodes[found] - x).norm() > 1e-9) ++found;
    if (found == own) {
      found = mesh.node_count();
      mesh.nodes.push_back(x);
    }
    number.push_back(found);
  }
  for (auto cell : other.cells) {
    for (Index& node : cell) node = number[node];
    mesh.cells.push_back(cell);
  }
}

/// The same cells on the other side of the plane through the origin across an axis.
core::HexMesh mirrored(core::HexMesh mesh, int axis) {
  for (Vector3& x : mesh.nodes) x[axis] = -x[axis];
  for (auto& cell : mesh.cells)
    for (int n = 0; n < 27; n += 3) std::swap(cell[n], cell[n + 2]);
  return mesh;
}

/// Octant of a ball of radius 1 in cells n along a third of a quarter and n outwards: a cube within a shell.
core::HexMesh ball_octant(Index n) {
  core::HexMesh mesh = hex_block(
      n, n, n, [](const Vector3& x) -> Vector3 { return core_share * (x * M_PI / 4).array().tan().matrix(); });
  core::HexMesh shell = octant(n, n, [](double s) { return 1 + s; });
  for (Vector3& x : shell.nodes) {
    const double outwards = x.norm() - 1;
    const Vector3 direction = x.normalized();
    x = outwards * direction + (1 - outwards) * core_share / direction.maxCoeff() * direction;
  }
  join(mesh, shell);
  return mesh;
}

/// A surface mode: a harmonic polynomial of degree l, not normalised.
struct Mode {
  const char* name;
  int degree;
  std::function<double(const Vector3&)> shape;
  double exact() const {
    const double l = degree;
    return l * (l + 2) * (2 * l + 1) / (2 * (2 * l * l + 4 * l + 3));
  }
};

/// Rate at which the mode decays, over sigma/(mu R).
double decay_rate(const core::HexMesh& ball, std::vector<flow::SymmetryPlane> planes, const Mode& mode) {
  constexpr double amplitude = 1e-3;
  auto material = uniform_glass(1);
  material.surface_tension = 1;
  flow::SolidProblem problem;
  problem.material = &material;
  problem.planes = std::move(planes);
  problem.open_faces = faces_where(ball, [](const Vector3& x) { return x.norm() > 1 - 1e-9; });
  flow::FlowMatrix matrix(ball, problem.planes, {});
  double moved = 0, all = 0;
  for (const double sign : {1.0, -1.0}) {  // the difference is free of what the cells' own facets do
    core::HexMesh mesh = ball;
    for (Vector3& x : mesh.nodes) x *= 1 + sign * amplitude * mode.shape(x);
    const auto result = solve_instant(problem, matrix, glass_of(mesh, material));
    for (const core::HexFace& face : problem.open_faces) {
      const auto nodes = core::face_node_numbers(ball, face);
      for (const auto& at : core::map_hex_face(core::face_nodes(ball, face), face, flow::points_along)) {
        Vector3 velocity = Vector3::Zero();
        for (int k = 0; k < 9; ++k) velocity += at.shape[k] * result.velocity.segment<3>(3 * nodes[k]);
        const double shape = mode.shape(at.position.normalized());
        moved -= sign * at.area * shape * velocity.dot(at.normal);
        all += at.area * shape * shape;
      }
    }
  }
  return moved / (amplitude * all);
}

TEST(SolidDrop, ModesOfAnOctantDecayAtTheOrderOfTheElement) {
  for (const Mode& mode :
       {Mode{"(2,0)", 2, [](const Vector3& x) { return x[2] * x[2] - 0.5 * x.head<2>().squaredNorm(); }},
        Mode{"(4,4)", 4, [](const Vector3& x) {
               const double a = x[0] * x[0], b = x[1] * x[1];
               return a * a - 6 * a * b + b * b;
             }}}) {
    double first = 0, error = 0;
    for (const Index n : {1, 2, 4}) {
      const core::HexMesh ball = ball_octant(n);
      std::vector<flow::SymmetryPlane> planes;
      for (int axis = 0; axis < 3; ++axis) planes.push_back(plane_of(ball, Vector3::Unit(axis)));
      const double rate = decay_rate(ball, planes, mode);
      error = std::abs(rate / mode.exact() - 1);
      if (n == 1) first = error;
      fmt::print("mode {} n {} rate {:.8f} exact {:.8f} error {:+.2e}\n", mode.name, n, rate, mode.exact(),
                 rate / mode.exact() - 1);
    }
    expect_at_most(fmt::format("decay of mode {} of a drop, 4 cells a third of a quarter", mode.name), error, 2e-4);
    expect_at_least("its order over two halvings", 0.5 * std::log2(first / error), 3);
  }
}

TEST(SolidDrop, AWholeDropDecaysAlikeInAnyOrder) {
  core::HexMesh ball = ball_octant(2);
  for (int axis = 0; axis < 3; ++axis) join(ball, mirrored(ball, axis));
  // A drop in space may move and turn: the middle is held, and three directions of two points on axes.
  const auto at = [&](const Vector3& place) {
    return nodes_where(ball, [&](const Vector3& x) { return (x - place).norm() < 1e-9; });
  };
  std::vector<flow::SymmetryPlane> planes;
  for (int axis = 0; axis < 3; ++axis) {
    planes.push_back({Vector3::Unit(axis), at(Vector3::Zero())});
    planes.push_back({Vector3::Unit((axis + 1) % 3), at(Vector3::Unit(axis))});
  }
  Figure second("decay of modes (2,m) of a whole drop, 2 cells a third of a quarter"), third("of modes (3,m)");
  const std::vector<Mode> modes{
      {"(2,0)", 2, [](const Vector3& x) { return x[2] * x[2] - 0.5 * x.head<2>().squaredNorm(); }},
      {"(2,1)", 2, [](const Vector3& x) { return 1.5 * x[0] * x[2]; }},
      {"(2,2)", 2, [](const Vector3& x) { return x[0] * x[0] - x[1] * x[1]; }},
      {"(3,0)", 3, [](const Vector3& x) { return x[2] * (x[2] * x[2] - 1.5 * x.head<2>().squaredNorm()); }},
      {"(3,1)", 3, [](const Vector3& x) { return x[1] * (4 * x[2] * x[2] - x.head<2>().squaredNorm()) / 2; }},
      {"(3,2)", 3, [](const Vector3& x) { return 3 * x[0] * x[1] * x[2]; }},
      {"(3,3)", 3, [](const Vector3& x) { return x[0] * (x[0] * x[0] - 3 * x[1] * x[1]); }}};
  for (const Mode& mode : modes) {
    const double rate = decay_rate(ball, planes, mode);
    fmt::print("mode {} of a whole drop: rate {:.8f} exact {:.8f} error {:+.2e}\n", mode.name, rate, mode.exact(),
               rate / mode.exact() - 1);
    (mode.degree == 2 ? second : third).add(std::abs(rate / mode.exact() - 1));
  }
  second.at_most(3e-3);
  third.at_most(5e-3);
}

}  // namespace
}  // namespace parison::tests
