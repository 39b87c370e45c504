// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/linearise.hpp"

#include "thermal/cell_kernels.hpp"

namespace parison::thermal {

Linearisation linearise(const HeatSystem& system, const Eigen::VectorXd& temperature) {
  Linearisation result;
  linearise_cells(system, temperature, result.groups);
  linearise_exchange(system, temperature, result);
  return result;
}

Eigen::VectorXd apply(const HeatSystem& system, const Linearisation& linearisation, double step,
                      const Eigen::VectorXd& change) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(system.size());
  apply_cells(system, linearisation.groups, step, change, result);
  apply_exchange(system, linearisation, step, change, result);
  return result;
}

}  // namespace parison::thermal
