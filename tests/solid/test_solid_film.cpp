// SPDX-License-Identifier: GPL-3.0-or-later
// A film squeezed between plates that it sticks to: F = c mu V b^4 / h^3 for a plate b wide and a film h thick, h/b to
// 0 (J. Stefan 1874), where c is the torsion constant of the plate's shape.
#include <gtest/gtest.h>

#include <cmath>

#include "figure.hpp"
#include "solid/hex_block.hpp"

namespace parison::tests {
namespace {

/// Force over mu V b^4 / h^3 on a plate `length` times 1 wide, of a film `thin` thick: an eighth of it, whose cells are
/// the finer the nearer to the free edge.
double squeeze(Index n, double length, double thin) {
  const auto material = uniform_glass(1);
  const auto towards_edge = [](double s) { return s * (2 - s); };
  flow::SolidGlass glass =
      glass_of(hex_block(n, n, 1,
                         [&](const Vector3& x) -> Vector3 {
                           return {0.5 * length * towards_edge(x[0]), 0.5 * towards_edge(x[1]), 0.5 * thin * x[2]};
                         }),
               material);
  flow::SolidProblem problem;
  problem.material = &material;
  for (int axis = 0; axis < 3; ++axis) problem.planes.push_back(plane_of(glass.mesh, Vector3::Unit(axis)));
  const auto on_plate = [=](const Vector3& x) { return x[2] > 0.5 * thin - 1e-9; };
  problem.fixed = nodes_where(glass.mesh, on_plate);
  problem.fixed_velocity = {0, 0, -0.5};  // each plate: they approach at 1 m/s
  flow::FlowMatrix matrix(glass.mesh, problem.planes, problem.fixed);
  const auto result = solve_instant(problem, matrix, glass);
  double force = 0;  // at the plate dw/dz = 0: the pressure alone
  for (const core::HexFace& face : faces_where(glass.mesh, on_plate))
    for (const auto& at : core::map_hex_face(core::face_nodes(glass.mesh, face), face, 1))
      force += 4 * at.area * (result.pressure[4 * face.cell] + 0.5 * result.pressure[4 * face.cell + 3]);
  return force * std::pow(thin, 3);
}

TEST(SolidFilm, ASqueezedFilmResistsAsStefanSays) {
  // Exact is the force of a film that is infinitely thin beside its plate, so that no order is asked.
  constexpr double thin = 0.02;
  Figure error("force of a squeezed film, 12 cells a half");
  for (const auto& [length, exact] : {std::pair{1.0, 0.4217310449}, {2.0, 1.3720900627}})
    for (const Index n : {6, 12}) {
      const double force = squeeze(n, length, thin), off = std::abs(force / exact - 1);
      fmt::print("plate {}:1 n {} force {:.6f} of {:.6f} error {:.2e}\n", length, n, force, exact, off);
      if (n == 12) error.add(off);
    }
  error.at_most(1e-2);
}

}  // namespace
}  // namespace parison::tests
