#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <functional>

#include "thermal/time/step_matrix.hpp"

namespace parison::thermal {

/// Initial guess of a stage; content, J, and power, W, may be extrapolated like the temperature, K.
struct StageGuess {
  Eigen::VectorXd temperature, content, power;
};

/// Result of solve_stage, meaningful where converged.
struct StageSolution {
  bool converged = false;
  Eigen::VectorXd temperature;  ///< by unknown, K
  Response response;            ///< at that temperature
  Index solves = 0;             ///< with the factor
  Index full_updates = 0;       ///< Newton updates with the full derivative
};

/// Solves a stage by modified Newton with the matrix's factor and Anderson acceleration (Anderson 1965; Walker and Ni
/// 2011), and where that converges slowly by Newton-Krylov with the full derivative. The guess must have the prescribed
/// temperatures of the stage; they are kept. Converged when the estimated error is below `tolerance` K at every node.
StageSolution solve_stage(const HeatSystem& system, const StepMatrix& matrix, const StageEquation& equation,
                          const StageGuess& guess, double tolerance);

struct KrylovSolution {
  Eigen::VectorXd x;
  int products = 0;
};

/// GMRES (Saad and Schultz 1986) for product(x) = rhs from x = 0, until the norm of the residual is `fraction` of that
/// of rhs or after `max_products` products.
KrylovSolution solve_by_gmres(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& product,
                              const Eigen::VectorXd& rhs, double fraction, int max_products);

}  // namespace parison::thermal
