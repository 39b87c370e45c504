#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <limits>
#include <vector>

#include "forming/study/law/law_fit.hpp"

namespace parison::contact {

inline bool is_exponent(int constant) {
  return constant == law_constant::a || constant == law_constant::b;
}

/// The free constants as the fit sees them: logarithms, but the exponents themselves.
struct LawUnknowns {
  PressureViscosityConductance fixed;  ///< with the fixed constants
  std::vector<int> free;

  PressureViscosityConductance law(const Eigen::VectorXd& x) const;
  Eigen::VectorXd of(const PressureViscosityConductance& law) const;
};
LawUnknowns unknowns_of(const LawFitOptions& options);

/// Where the sum of squares is smallest; infinite `squares` where no start led to finite values.
struct LawOptimum {
  Eigen::VectorXd x, residual;
  Eigen::MatrixXd jacobian;  ///< of the residuals with the unknowns
  double squares = std::numeric_limits<double>::infinity();
};
LawOptimum find_optimum(const std::vector<LawMeasurement>& data, const LawFitOptions& options,
                        const LawUnknowns& unknowns);

}  // namespace parison::contact
