#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "forming/flow/element_matrix.hpp"

namespace parison::flow {

/// Adds to the cells' matrices what the viscous forces change by through the Carreau factor, at a velocity that gives `viscosity`:
/// 8 d eta/d(rate^2) (D:dD)(D:dD'). The matrices stay symmetric, and positive where the law's exponent is.
void add_thinning_derivative(const Problem& problem, const CellGeometry& geometry, const std::vector<double>& viscosity,
                             const Eigen::VectorXd& velocity, CellMatrices& cells);

/// Chooses between Newton's steps and those with the viscosity as it is (Kacanov's), which are slow but always approach the
/// answer: a Newton step that moves the flow further than the step before is followed by ever more of the latter.
class NewtonGuard {
 public:
  /// Whether the next step may be Newton's after one that changed the velocities by `moved`, relative.
  bool trusts(double moved);

 private:
  double last_moved_ = std::numeric_limits<double>::infinity();
  int penalty_ = 0, left_ = 0;
};

}  // namespace parison::flow
