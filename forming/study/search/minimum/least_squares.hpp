#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace parison::forming {

/// Residuals at places that may be computed at once, nothing where a run fails; fewer than asked for where stopped.
using Residuals = std::function<std::vector<std::optional<Eigen::VectorXd>>(const std::vector<Eigen::VectorXd>&)>;

struct LeastSquaresOptions {
  Eigen::VectorXd low, high, step;  ///< bounds and widths of the difference quotients, one a variable
  std::size_t runs = 120;           ///< at most
  /// The last so many residuals count only where they are above zero: by how much limits are missed.
  Eigen::Index limits = 0;
  double good_enough = 0;    ///< norm of the residual below which the search ends
  double least_gain = 0.01;  ///< share of the norm; what gains less than this counts as noise
};

struct LeastSquaresResult {
  Eigen::VectorXd at, residual;  ///< of the best run; the residual is empty where the first run failed
  Eigen::MatrixXd jacobian;      ///< by the variables
  std::size_t runs = 0;
  enum class Ending { good_enough, no_more_gain, no_more_runs, start_failed, stopped } ending;
};

/// Least squares between bounds for residuals with noise, by K. Levenberg (Q. Appl. Math. 2 (1944) 164-168) and D. W.
/// Marquardt (J. SIAM 11 (1963) 431-441): difference quotients over steps wider than the noise, all of one Jacobian
/// asked for at once, and between two of them C. G. Broyden's rank-one updates (Math. Comp. 19 (1965) 577-593), which
/// cost no run. A place that fails is tried from the other side, then left out; a step that fails is shortened.
LeastSquaresResult least_squares(const Eigen::VectorXd& start, const LeastSquaresOptions& options,
                                 const Residuals& residuals);

/// A residual with the limits that hold at zero.
Eigen::VectorXd counted(Eigen::VectorXd residual, Eigen::Index limits);

/// The step of Levenberg and Marquardt that stays between bounds: variables that a bound holds take no part. All in
/// steps of the variables.
Eigen::VectorXd bounded_step(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual, double damping,
                             const Eigen::VectorXd& low, const Eigen::VectorXd& high);

}  // namespace parison::forming
