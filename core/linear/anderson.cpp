// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/anderson.hpp"

#include <Eigen/QR>

namespace parison::core {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd AndersonAcceleration::next(const VectorXd& x, const VectorXd& image) {
  const VectorXd residual = image - x;
  if (image_.size() > 0) add(image - image_, residual - residual_);
  image_ = image;
  residual_ = residual;
  return accelerated(image, residual);
}

VectorXd AndersonAcceleration::next_move(const VectorXd& update) {
  if (residual_.size() > 0) add(image_ + (update - residual_), update - residual_);
  residual_ = update;
  return image_ = accelerated(update, update);
}

void AndersonAcceleration::add(const VectorXd& image_change, const VectorXd& residual_change) {
  if (image_change_.size() < depth_) {
    image_change_.push_back(image_change);
    residual_change_.push_back(residual_change);
  } else {
    image_change_[added_ % depth_] = image_change;
    residual_change_[added_ % depth_] = residual_change;
  }
  ++added_;
}

VectorXd AndersonAcceleration::accelerated(const VectorXd& image, const VectorXd& residual) const {
  if (added_ == 0) return image;
  const auto count = static_cast<Eigen::Index>(image_change_.size());
  MatrixXd images(image.size(), count), residuals(image.size(), count);
  for (Eigen::Index i = 0; i < count; ++i) {
    images.col(i) = image_change_[static_cast<std::size_t>(i)];
    residuals.col(i) = residual_change_[static_cast<std::size_t>(i)];
  }
  return image - images * residuals.colPivHouseholderQr().solve(residual);
}

}  // namespace parison::core
