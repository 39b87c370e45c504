// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "forming/study/search/calibration/calibration.hpp"

namespace parison::forming {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of a unit direction: smaller parts are not named, and do not take a constant's interval away.
constexpr double part_that_counts = 0.1;

/// "h0 times 1.8 with h1 times 0.6": a direction of length `reach`, in widths of the bounds.
std::string direction_text(const std::vector<SearchVariable>& variables, const VectorXd& direction, double reach) {
  std::vector<std::string> parts;
  for (Eigen::Index i = 0; i < direction.size(); ++i) {
    if (std::abs(direction[i]) < part_that_counts) continue;
    const SearchVariable& variable = variables[std::size_t(i)];
    const double change = direction[i] * reach * (variable.high() - variable.low());
    parts.push_back(variable.logarithmic
                        ? fmt::format("{} times {:.3g}", variable.key, std::exp(change))
                        : fmt::format("{} {} by {:.3g} {}", variable.key, change > 0 ? "higher" : "lower",
                                      std::abs(change), variable.bounds.unit));
  }
  return fmt::format("{}", fmt::join(parts, " with "));
}

FittedConstant constant_of(const SearchVariable& variable, double at, double half) {
  const double near = 1e-6 * (variable.high() - variable.low());
  const bool at_bound = at <= variable.low() + near || at >= variable.high() - near;
  return {variable.value(at), variable.value(at - half), variable.value(at + half), at_bound};
}

}  // namespace

FitIntervals fit_intervals(const std::vector<SearchVariable>& variables, const VectorXd& at, const VectorXd& residual,
                           const MatrixXd& jacobian) {
  const Eigen::Index count = at.size();
  FitIntervals found;
  found.freedom = residual.size() - count;
  found.scatter = residual.norm() / std::sqrt(double(std::max(1L, found.freedom)));
  const double t = quantile(boost::math::students_t(double(std::max(1L, found.freedom))), 0.975);
  VectorXd width(count);
  for (Eigen::Index i = 0; i < count; ++i)
    width[i] = variables[std::size_t(i)].high() - variables[std::size_t(i)].low();
  const Eigen::JacobiSVD<MatrixXd> svd(jacobian * width.asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeThinV);
  VectorXd variance = VectorXd::Zero(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const VectorXd direction = svd.matrixV().col(k);
    const double singular = svd.singularValues()[k];
    const double half = singular > 0 ? t * found.scatter / singular : std::numeric_limits<double>::infinity();
    const bool unseen = 2 * half > 1;
    if (unseen)
      found.cannot.push_back(fmt::format("the data cannot tell {}: they are the same within their noise",
                                         direction_text(variables, direction, std::min(half, 0.5))));
    for (Eigen::Index i = 0; i < count; ++i) {
      if (!unseen)
        variance[i] += std::pow(direction[i] * half, 2);
      else if (std::abs(direction[i]) > part_that_counts)
        variance[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  for (Eigen::Index i = 0; i < count; ++i)
    found.constants.push_back(constant_of(variables[std::size_t(i)], at[i], width[i] * std::sqrt(variance[i])));
  return found;
}

}  // namespace parison::forming
