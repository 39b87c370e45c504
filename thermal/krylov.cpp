// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/krylov.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Jacobi>
#include <Eigen/LU>

namespace parison::thermal {

KrylovSolution solve_by_gmres(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& product,
                              const Eigen::VectorXd& rhs, double share, int most) {
  const double size = rhs.norm();
  if (!(size > 0)) return {rhs, 0};
  Eigen::MatrixXd basis(rhs.size(), most + 1), triangle = Eigen::MatrixXd::Zero(most + 1, most);
  Eigen::VectorXd left = Eigen::VectorXd::Unit(most + 1, 0) * size;  // the residual in the basis, rotated
  std::vector<Eigen::JacobiRotation<double>> rotations;
  basis.col(0) = rhs / size;
  int n = 0;
  while (n < most && std::abs(left[n]) > share * size) {
    Eigen::VectorXd next = product(basis.col(n));
    for (int i = 0; i <= n; ++i) {
      triangle(i, n) = basis.col(i).dot(next);
      next -= triangle(i, n) * basis.col(i);
    }
    const double norm = next.norm();
    if (norm > 0) basis.col(n + 1) = next / norm;
    triangle(n + 1, n) = norm;
    for (int i = 0; i < n; ++i) triangle.col(n).applyOnTheLeft(i, i + 1, rotations[i].adjoint());
    rotations.emplace_back().makeGivens(triangle(n, n), triangle(n + 1, n));
    triangle.col(n).applyOnTheLeft(n, n + 1, rotations[n].adjoint());
    left.applyOnTheLeft(n, n + 1, rotations[n].adjoint());
    ++n;
    if (norm == 0) break;
  }
  const Eigen::VectorXd weights = triangle.topLeftCorner(n, n).triangularView<Eigen::Upper>().solve(left.head(n));
  return {basis.leftCols(n) * weights, n};
}

}  // namespace parison::thermal
