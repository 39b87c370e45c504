// SPDX-License-Identifier: GPL-3.0-or-later
// The matrix of heat in space: orders of elimination and patterns that are kept.
#include <gtest/gtest.h>

#include "core/linear/cholesky.hpp"
#include "solid/solid_meshes.hpp"

namespace parison::thermal::test {
namespace {

/// A mass matrix plus a Laplacian over the cells of a block.
core::Assembly block_matrix(const Block& block) {
  core::Cliques cliques;
  for (const auto& cell : block.mesh.cells) cliques.add(cell.data(), 27);
  core::Assembly assembly = core::make_assembly(block.mesh.node_count(), cliques);
  const Eigen::Matrix<double, 27, 27, Eigen::RowMajor> local =
      Eigen::Matrix<double, 27, 27>::Identity() * 28 - Eigen::Matrix<double, 27, 27>::Ones();
  for (Index c = 0; c < cliques.count(); ++c) core::add_clique(assembly.matrix, assembly.scatter, c, 27, local.data());
  return assembly;
}

TEST(SolidMatrix, dissection_solves_the_same_with_fewer_operations) {
  const Block cube = block(8, 8, 8, [](const Vector3& x) { return x; });
  const core::Assembly assembly = block_matrix(cube);
  const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(assembly.matrix.size, -1, 2);
  const Eigen::VectorXd rhs = core::multiply(assembly.matrix, exact);
  core::Cholesky degree, dissected;
  degree.analyse(assembly.matrix);
  dissected.analyse_dissected(assembly.matrix);
  EXPECT_LT(dissected.operations(), 0.8 * degree.operations());
  const double operations = dissected.operations();
  for (const bool again : {false, true}) {
    if (again) dissected.analyse_in_same_order(assembly.matrix);
    EXPECT_NEAR(dissected.operations(), operations, 0.02 * operations);
    ASSERT_TRUE(dissected.factorise(assembly.matrix));
    EXPECT_LT((dissected.solve(rhs) - exact).lpNorm<Eigen::Infinity>(), 1e-10);
  }
}

}  // namespace
}  // namespace parison::thermal::test
