// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/flow/fixed_point.hpp"

#include <Eigen/QR>

namespace parison::forming {

Eigen::VectorXd FixedPoint::next(const Eigen::VectorXd& x, const Eigen::VectorXd& mapped) {
  mapped_.push_back(mapped);
  residual_.push_back(mapped - x);
  const auto known = static_cast<Eigen::Index>(residual_.size()) - 1;
  if (known == 0) return mapped;
  Eigen::MatrixXd change(x.size(), known), mapped_change(x.size(), known);
  for (Eigen::Index i = 0; i < known; ++i) {
    change.col(i) = residual_[i + 1] - residual_[i];
    mapped_change.col(i) = mapped_[i + 1] - mapped_[i];
  }
  return mapped - mapped_change * change.colPivHouseholderQr().solve(residual_.back());
}

void FixedPoint::forget() {
  mapped_.clear();
  residual_.clear();
}

}  // namespace parison::forming
