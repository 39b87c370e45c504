#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <functional>

#include "thermal/time/step_matrix.hpp"

namespace parison::thermal {

/// Equation of an implicit stage: content(T) - step power(T) = target at every unknown that is not prescribed.
struct StageEquation {
  double step;             ///< s
  Eigen::VectorXd target;  ///< J
};

/// Where the solution of a stage starts: content and power there may be extrapolated like the temperature.
struct StageGuess {
  Eigen::VectorXd temperature, content, power;
};

struct StageSolution {
  bool converged = false;
  Eigen::VectorXd temperature;
  Response response;       ///< at the temperature
  Index solves = 0;        ///< with the factor
  Index full_updates = 0;  ///< Newton updates with the full derivative
};

/// Modified Newton with the matrix's present factor, accelerated by Anderson's method; where that contracts slowly,
/// Newton's method with the full derivative. Ends when the residual stands for less than `tolerance` K at every node.
StageSolution solve_stage(const HeatSystem& system, const StepMatrix& matrix, const StageEquation& equation,
                          const StageGuess& guess, double tolerance);

struct KrylovSolution {
  Eigen::VectorXd x;
  int products = 0;
};

/// GMRES (Saad and Schultz 1986) for product(x) = rhs from x = 0, until the residual is `fraction` of rhs or after
/// `most` products.
KrylovSolution solve_by_gmres(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& product,
                              const Eigen::VectorXd& rhs, double fraction, int most);

}  // namespace parison::thermal
