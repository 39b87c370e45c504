#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <functional>
#include <limits>
#include <optional>

namespace parison::forming {

/// A value that is to be small, and by how much limits are missed (not above zero where they hold).
struct ScalarValue {
  double value;
  Eigen::VectorXd excess;
};

struct ScalarOptions {
  Eigen::VectorXd low, high, step;
  std::size_t runs = 120, limits = 0;
  double good_enough = -std::numeric_limits<double>::infinity();  ///< ends at this value or below, where limits hold
};

enum class ScalarEnding { good_enough, converged, no_more_runs, stopped };

/// The least value under limits, by linear models over a simplex of places as wide as the steps, which no derivative
/// and little noise enters (COBYLA of NLopt; M. J. D. Powell, Advances in Optimization and Numerical Analysis (1994)
/// 51-67). `ask` gives nothing where a run fails; `stopped` is asked after each.
ScalarEnding scalar_search(const Eigen::VectorXd& start, const ScalarOptions& options,
                           const std::function<std::optional<ScalarValue>(const Eigen::VectorXd&)>& ask,
                           const std::function<bool()>& stopped);

}  // namespace parison::forming
