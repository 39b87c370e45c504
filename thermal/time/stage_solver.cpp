// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/time/stage_solver.hpp"

#include <Eigen/Jacobi>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/linear/anderson.hpp"
#include "thermal/time/step_matrix.hpp"

namespace parison::thermal {

namespace {

constexpr int max_updates = 20;
constexpr int first_checked_update = 3;   ///< from this one on an update larger than an earlier one is a stall
constexpr double gmres_fraction = 1e-2;   ///< relative residual of GMRES for an update of Newton-Krylov
constexpr int max_gmres_products = 12;    ///< for an update of Newton-Krylov
constexpr double min_damping = 1.0 / 64;  ///< smallest factor on an update of Newton-Krylov

/// Newton's update with the full derivative, those of conductivity and conductance included, by GMRES preconditioned
/// with the factor; `modified_update` is the update of modified Newton, the preconditioned right-hand side.
Eigen::VectorXd full_update(const HeatSystem& system, const StepMatrix& matrix, const StageEquation& equation,
                            const Eigen::VectorXd& temperature, const Eigen::VectorXd& modified_update, Index& solves) {
  const Linearisation jacobian = linearise(system, equation.time, temperature);
  const auto product = [&](const Eigen::VectorXd& change) -> Eigen::VectorXd {
    Eigen::VectorXd moved = apply(system, jacobian, equation.step, change);
    for (const PrescribedUnknown& at : system.prescribed) moved[at.unknown] = change[at.unknown];
    return matrix.cholesky.solve(moved);
  };
  KrylovSolution solution = solve_by_gmres(product, modified_update, gmres_fraction, max_gmres_products);
  solves += solution.products;
  return std::move(solution.x);
}

/// Current iterate of a stage.
struct Iterate {
  StageSolution stage;
  Eigen::VectorXd residual;  ///< by unknown, J
  double scaled = 0;         ///< max norm of the residual divided by the matrix's diagonal, K
};

void set_residual(const HeatSystem& system, const StepMatrix& matrix, const StageEquation& equation,
                  const Eigen::VectorXd& content, const Eigen::VectorXd& power, Iterate& at) {
  at.residual = content - equation.step * power - equation.target;
  clear_prescribed(system, at.residual);
  at.scaled = at.residual.cwiseQuotient(matrix.diagonal).lpNorm<Eigen::Infinity>();
  if (!std::isfinite(at.residual.lpNorm<1>())) at.scaled = std::numeric_limits<double>::quiet_NaN();
}

void move_to(const HeatSystem& system, const StepMatrix& matrix, const StageEquation& equation,
             Eigen::VectorXd temperature, Iterate& at) {
  at.stage.temperature = std::move(temperature);
  at.stage.response = evaluate(system, equation.time, at.stage.temperature);
  set_residual(system, matrix, equation, at.stage.response.content, at.stage.response.power, at);
}

/// Whether the residual fell so far with the last update, of `size` K, that the error must be below the tolerance.
/// Error and residual fall alike up to the shape of the field; the factor 10 allows for that, and no further solve is
/// needed.
bool is_solved(const Iterate& at, double size, double last_scaled, double tolerance) {
  return at.scaled == 0 || 10 * size * at.scaled <= tolerance * last_scaled;
}

/// Modified Newton with Anderson acceleration; false where it stalls, `at` being the last iterate.
bool solve_by_modified_newton(const HeatSystem& system, const StepMatrix& matrix, const StageEquation& equation,
                              double tolerance, Iterate& at) {
  core::AndersonAcceleration history(anderson_depth);
  double smallest = std::numeric_limits<double>::infinity();
  for (int updates = 0; updates < max_updates; ++updates) {
    const Eigen::VectorXd update = -matrix.cholesky.solve(at.residual);
    ++at.stage.solves;
    const double size = update.lpNorm<Eigen::Infinity>(), last_scaled = at.scaled;
    // The first update is always made, however small: omitted in many tiny steps the updates would add up.
    at.stage.converged = updates > 0 && size <= tolerance;
    if (at.stage.converged) return true;
    if (!std::isfinite(size) || (updates >= first_checked_update && size > smallest)) return false;
    smallest = std::min(smallest, size);
    move_to(system, matrix, equation, at.stage.temperature + history.next_move(update), at);
    at.stage.converged = is_solved(at, size, last_scaled, tolerance);
    if (at.stage.converged || !std::isfinite(at.scaled)) return at.stage.converged;
  }
  return false;
}

/// Newton-Krylov with the full derivative, damped where the residual would not fall.
void solve_by_newton_krylov(const HeatSystem& system, const StepMatrix& matrix, const StageEquation& equation,
                            double tolerance, Iterate& at) {
  for (int updates = 0; updates < max_updates; ++updates) {
    const Eigen::VectorXd modified_update = -matrix.cholesky.solve(at.residual), before = at.stage.temperature;
    ++at.stage.solves;
    const Eigen::VectorXd update = full_update(system, matrix, equation, before, modified_update, at.stage.solves);
    const double size = update.lpNorm<Eigen::Infinity>(), last_scaled = at.scaled;
    const double norm = at.residual.cwiseQuotient(matrix.diagonal).norm();
    ++at.stage.full_updates;
    if (!std::isfinite(size)) return;
    for (double damping = 1; damping >= min_damping; damping /= 2) {
      move_to(system, matrix, equation, before + damping * update, at);
      if (at.residual.cwiseQuotient(matrix.diagonal).norm() < norm) break;
    }
    at.stage.converged = is_solved(at, size, last_scaled, tolerance) || size <= tolerance;
    if (at.stage.converged || !std::isfinite(at.scaled)) return;
  }
}

}  // namespace

StageSolution solve_stage(const HeatSystem& system, const StepMatrix& matrix, const StageEquation& equation,
                          const StageGuess& guess, double tolerance) {
  Iterate at;
  at.stage.temperature = guess.temperature;
  set_residual(system, matrix, equation, guess.content, guess.power, at);
  if (!(at.scaled > 0)) move_to(system, matrix, equation, guess.temperature, at);
  at.stage.converged = at.scaled == 0;
  if (at.stage.converged || !std::isfinite(at.scaled)) return std::move(at.stage);
  if (solve_by_modified_newton(system, matrix, equation, tolerance, at)) return std::move(at.stage);
  if (!std::isfinite(at.scaled)) move_to(system, matrix, equation, guess.temperature, at);
  solve_by_newton_krylov(system, matrix, equation, tolerance, at);
  return std::move(at.stage);
}

KrylovSolution solve_by_gmres(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& product,
                              const Eigen::VectorXd& rhs, double fraction, int max_products) {
  const double size = rhs.norm();
  if (!(size > 0)) return {rhs, 0};
  Eigen::MatrixXd basis(rhs.size(), max_products + 1), triangle = Eigen::MatrixXd::Zero(max_products + 1, max_products);
  Eigen::VectorXd left = Eigen::VectorXd::Unit(max_products + 1, 0) * size;  // residual in the basis, rotated
  std::vector<Eigen::JacobiRotation<double>> rotations;
  basis.col(0) = rhs / size;
  int n = 0;
  while (n < max_products && std::abs(left[n]) > fraction * size) {
    Eigen::VectorXd next = product(basis.col(n));
    for (int i = 0; i <= n; ++i) {
      triangle(i, n) = basis.col(i).dot(next);
      next -= triangle(i, n) * basis.col(i);
    }
    const double norm = next.norm();
    if (norm > 0) basis.col(n + 1) = next / norm;
    triangle(n + 1, n) = norm;
    for (int i = 0; i < n; ++i) triangle.col(n).applyOnTheLeft(i, i + 1, rotations[i].adjoint());
    rotations.emplace_back().makeGivens(triangle(n, n), triangle(n + 1, n));
    triangle.col(n).applyOnTheLeft(n, n + 1, rotations[n].adjoint());
    left.applyOnTheLeft(n, n + 1, rotations[n].adjoint());
    ++n;
    if (norm == 0) break;
  }
  const Eigen::VectorXd weights = triangle.topLeftCorner(n, n).triangularView<Eigen::Upper>().solve(left.head(n));
  return {basis.leftCols(n) * weights, n};
}

}  // namespace parison::thermal
