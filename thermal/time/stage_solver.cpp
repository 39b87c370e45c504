// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/time/stage_solver.hpp"

#include <Eigen/Jacobi>
#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "thermal/time/step_matrix.hpp"

namespace parison::thermal {

namespace {

constexpr int anderson_depth = 4;
constexpr int max_updates = 20;
constexpr int first_judged = 3;  ///< a later update larger than one before it is a stall
constexpr double inner_fraction =
    1e-2;                              ///< of its right hand side that the inner solution of the full Newton may leave
constexpr int max_products = 12;       ///< of the full derivative in an inner solution
constexpr double shortest = 1.0 / 64;  ///< part of an update of the full Newton that must lower the residual

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

/// Newton's update with the full derivative, slopes of conductivity and conductance included: GMRES, with the factor as
/// preconditioner and its update `plain` as the right hand side.
Eigen::VectorXd full_update(const HeatSystem& system, const StepMatrix& matrix, double step,
                            const Eigen::VectorXd& temperature, const Eigen::VectorXd& plain, Index& solves) {
  const Linearisation jacobian = linearise(system, temperature);
  const auto product = [&](const Eigen::VectorXd& change) -> Eigen::VectorXd {
    Eigen::VectorXd moved = apply(system, jacobian, step, change);
    for (const auto& [unknown, value] : system.prescribed) moved[unknown] = change[unknown];
    return matrix.cholesky.solve(moved);
  };
  KrylovSolution solution = solve_by_gmres(product, plain, inner_fraction, max_products);
  solves += solution.products;
  return std::move(solution.x);
}

/// A stage at the iterate reached.
struct Iterate {
  StageSolution stage;
  Eigen::VectorXd residual;  ///< J
  double scaled = 0;         ///< residual over the matrix's diagonal, largest, K
};

void set_residual(const HeatSystem& system, const StepMatrix& matrix, const StageEquation& equation,
                  const Eigen::VectorXd& content, const Eigen::VectorXd& power, Iterate& at) {
  at.residual = content - equation.step * power - equation.target;
  for (const auto& [unknown, value] : system.prescribed) at.residual[unknown] = 0;
  at.scaled = at.residual.cwiseQuotient(matrix.diagonal).lpNorm<Eigen::Infinity>();
  if (!std::isfinite(at.residual.lpNorm<1>())) at.scaled = std::numeric_limits<double>::quiet_NaN();
}

void move_to(const HeatSystem& system, const StepMatrix& matrix, const StageEquation& equation,
             Eigen::VectorXd temperature, Iterate& at) {
  at.stage.temperature = std::move(temperature);
  at.stage.response = evaluate(system, at.stage.temperature);
  set_residual(system, matrix, equation, at.stage.response.content, at.stage.response.power, at);
}

/// Whether the residual fell so far since an update of `size` K that the error stands below the tolerance: it falls as
/// the error does, give or take its distribution, and a factor 10 spares the proving solve.
bool is_solved(const Iterate& at, double size, double last_scaled, double tolerance) {
  return at.scaled == 0 || 10 * size * at.scaled <= tolerance * last_scaled;
}

/// Modified Newton; false where it stalls, with the iterate to go on from.
bool solve_by_factor(const HeatSystem& system, const StepMatrix& matrix, const StageEquation& equation,
                     double tolerance, Iterate& at) {
  History history(system.size());
  Eigen::VectorXd last_update, last_move;
  double smallest = std::numeric_limits<double>::infinity();
  for (int updates = 0; updates < max_updates; ++updates) {
    const Eigen::VectorXd update = -matrix.cholesky.solve(at.residual);
    ++at.stage.solves;
    const double size = update.lpNorm<Eigen::Infinity>(), last_scaled = at.scaled;
    // The first update is always made: dropped again and again in tiny steps it would add up.
    at.stage.converged = updates > 0 && size <= tolerance;
    if (at.stage.converged) return true;
    if (!std::isfinite(size) || (updates >= first_judged && size > smallest)) return false;
    if (last_update.size()) history.add(last_move, update - last_update);
    last_move = history.move(update);
    last_update = update;
    smallest = std::min(smallest, size);
    move_to(system, matrix, equation, at.stage.temperature + last_move, at);
    at.stage.converged = is_solved(at, size, last_scaled, tolerance);
    if (at.stage.converged || !std::isfinite(at.scaled)) return at.stage.converged;
  }
  return false;
}

/// Newton's method with the full derivative, shortened where the residual would not fall.
void solve_by_full_derivative(const HeatSystem& system, const StepMatrix& matrix, const StageEquation& equation,
                              double tolerance, Iterate& at) {
  for (int updates = 0; updates < max_updates; ++updates) {
    const Eigen::VectorXd plain = -matrix.cholesky.solve(at.residual), before = at.stage.temperature;
    ++at.stage.solves;
    const Eigen::VectorXd update = full_update(system, matrix, equation.step, before, plain, at.stage.solves);
    const double size = update.lpNorm<Eigen::Infinity>(), last_scaled = at.scaled;
    const double norm = at.residual.cwiseQuotient(matrix.diagonal).norm();
    ++at.stage.full_updates;
    if (!std::isfinite(size)) return;
    for (double part = 1; part >= shortest; part /= 2) {
      move_to(system, matrix, equation, before + part * update, at);
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
  if (solve_by_factor(system, matrix, equation, tolerance, at)) return std::move(at.stage);
  if (!std::isfinite(at.scaled)) move_to(system, matrix, equation, guess.temperature, at);
  solve_by_full_derivative(system, matrix, equation, tolerance, at);
  return std::move(at.stage);
}

KrylovSolution solve_by_gmres(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& product,
                              const Eigen::VectorXd& rhs, double fraction, int most) {
  const double size = rhs.norm();
  if (!(size > 0)) return {rhs, 0};
  Eigen::MatrixXd basis(rhs.size(), most + 1), triangle = Eigen::MatrixXd::Zero(most + 1, most);
  Eigen::VectorXd left = Eigen::VectorXd::Unit(most + 1, 0) * size;  // the residual in the basis, rotated
  std::vector<Eigen::JacobiRotation<double>> rotations;
  basis.col(0) = rhs / size;
  int n = 0;
  while (n < most && std::abs(left[n]) > fraction * size) {
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
