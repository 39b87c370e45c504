// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/stage.hpp"

#include <cmath>
#include <limits>

#include <Eigen/QR>

namespace parison::thermal {

namespace {

constexpr int anderson_depth = 4;
constexpr Index most_solves = 20;

/// The last few differences of iterates and of their updates.
struct History {
  Eigen::MatrixXd iterate, update;
  int filled = 0;

  explicit History(Index size) : iterate(size, anderson_depth), update(size, anderson_depth) {}
  void add(const Eigen::VectorXd& iterate_change, const Eigen::VectorXd& update_change) {
    const int at = filled++ % anderson_depth;
    iterate.col(at) = iterate_change;
    update.col(at) = update_change;
  }
  /// Next move from a Newton update: the combination of past updates that cancels it best is taken off.
  Eigen::VectorXd move(const Eigen::VectorXd& newton) const {
    const int n = std::min(filled, anderson_depth);
    if (n == 0) return newton;
    const Eigen::VectorXd weights = update.leftCols(n).colPivHouseholderQr().solve(newton);
    return newton - (iterate.leftCols(n) + update.leftCols(n)) * weights;
  }
};

Eigen::VectorXd residual(const HeatSystem& system, const StageEquation& equation, const Response& response) {
  Eigen::VectorXd r = response.content - equation.step * response.power - equation.target;
  for (const auto& [unknown, value] : system.prescribed) r[unknown] = 0;
  return r;
}

}  // namespace

StageSolution solve_stage(const HeatSystem& system, const StepMatrix& matrix, const StageEquation& equation,
                          const Eigen::VectorXd& guess, double tolerance) {
  StageSolution stage;
  stage.temperature = guess;
  History history(system.size());
  Eigen::VectorXd last_update, last_move;
  double last_size = std::numeric_limits<double>::infinity(), last_scaled = 0, smallest = last_size;
  while (stage.solves < most_solves) {
    stage.response = evaluate(system, stage.temperature);
    const Eigen::VectorXd r = residual(system, equation, stage.response);
    if (!r.allFinite()) return stage;
    const double scaled = r.cwiseQuotient(matrix.diagonal).lpNorm<Eigen::Infinity>();
    // The residual fell as far as the error in K, give or take its distribution: a factor 10 spares the proving solve.
    stage.converged = scaled == 0 || 10 * last_size * scaled <= tolerance * last_scaled;
    if (stage.converged) return stage;
    const Eigen::VectorXd update = -matrix.cholesky.solve(r);
    ++stage.solves;
    const double size = update.lpNorm<Eigen::Infinity>();
    // The first update is always made: dropped again and again in tiny steps it would add up.
    stage.converged = stage.solves > 1 && size <= tolerance;
    if (stage.converged || !std::isfinite(size) || size > 1e3 * smallest) return stage;
    if (last_update.size()) history.add(last_move, update - last_update);
    last_move = history.move(update);
    last_update = update;
    last_size = size;
    last_scaled = scaled;
    smallest = std::min(smallest, size);
    stage.temperature += last_move;
  }
  return stage;
}

}  // namespace parison::thermal
