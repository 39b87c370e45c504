#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>

#include <Eigen/Core>

namespace parison::thermal {

struct KrylovSolution {
  Eigen::VectorXd x;
  int products = 0;
};

/// GMRES (Saad and Schultz 1986) for product(x) = rhs from x = 0, until the residual is `share` of rhs or after `most`
/// products.
KrylovSolution solve_by_gmres(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& product,
                              const Eigen::VectorXd& rhs, double share, int most);

}  // namespace parison::thermal
