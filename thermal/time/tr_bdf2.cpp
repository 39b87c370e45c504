// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/time/tr_bdf2.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "thermal/cells/cell_kernels.hpp"
#include "thermal/time/stage_solver.hpp"

namespace parison::thermal {

namespace {

// TR-BDF2 as the diagonally implicit Runge-Kutta method of Hosea and Shampine (1996, section 2): stages at t, at
// t + gamma dt and at t + dt with gamma = 2 - sqrt(2), d = gamma/2 on the diagonal, weights (w, w, d) with
// w = sqrt(2)/4. The weights of the embedded method of third order are ((1 - w)/3, (3 w + 1)/3, d/3).
const double gamma = 2 - std::sqrt(2.0), d = gamma / 2, w = std::sqrt(2.0) / 4;
const std::array<double, 3> weight{w, w, d};
const std::array<double, 3> error_weight{w - (1 - w) / 3, w - (3 * w + 1) / 3, d - d / 3};

constexpr double same_step = 1e-9;          ///< relative change of the substep up to which the factor is reused
constexpr double startup_transient = 0.25;  ///< expected ratio of the first to the last fitting substep of a step
constexpr Index many_solves = 7;            ///< a stage that needs more causes a new factorisation

struct Integration {
  const HeatSystem& system;
  const StepOptions& options;
  StepMatrix& matrix;
  Index solves = 0;
};

/// Solution at the time of a stage.
struct StageValue {
  double time = 0;              ///< s
  Eigen::VectorXd temperature;  ///< by unknown, K
  Response response;            ///< at that time and temperature
  Eigen::VectorXd content;      ///< as integrated in time: that of the response up to the algebraic error, J
};

/// Rates of change over the last part of a substep, per second.
struct Rate {
  Eigen::VectorXd temperature, content, power;
};

struct TrialStep {
  bool solved = false;
  double error = 0;  ///< max norm of the estimated local error, K
  Response middle;   ///< at t + gamma dt
  StageValue end;
  Rate rate;  ///< from there to the end
};

Rate rate_between(const Eigen::VectorXd& first, const Response& before, const Eigen::VectorXd& second,
                  const Response& after, double duration) {
  return {(second - first) / duration, (after.content - before.content) / duration,
          (after.power - before.power) / duration};
}

/// Initial guess at `time`; evaluated there where prescribed temperatures do not follow the extrapolation.
StageGuess extrapolate(const HeatSystem& system, const StageValue& start, const Rate& rate, double time,
                       double duration) {
  StageGuess guess{start.temperature + duration * rate.temperature, start.response.content + duration * rate.content,
                   start.response.power + duration * rate.power};
  if (!impose_prescribed(system, time, guess.temperature)) return guess;
  Response response = evaluate(system, time, guess.temperature);
  return {std::move(guess.temperature), std::move(response.content), std::move(response.power)};
}

/// Solves a stage with the present factor, or with a new one where its step differs or Newton's method fails.
StageSolution solve(Integration& run, const StageEquation& equation, const StageGuess& guess) {
  bool fresh = false;
  const auto refactorise = [&] {
    return fresh = factorise(run.matrix, run.system, equation.time, guess.temperature, equation.step);
  };
  if (!(std::abs(run.matrix.factored_step / equation.step - 1) <= same_step) && !refactorise()) return {};
  StageSolution solution = solve_stage(run.system, run.matrix, equation, guess, run.options.newton_tolerance);
  run.solves += solution.solves;
  if (!solution.converged && !fresh && refactorise()) {
    solution = solve_stage(run.system, run.matrix, equation, guess, run.options.newton_tolerance);
    run.solves += solution.solves;
  }
  return solution;
}

/// One substep of length dt from `start`, with the rate of the substep before it for the initial guess.
TrialStep try_step(Integration& run, const StageValue& start, const Rate& rate, double dt) {
  TrialStep result;
  const double step = d * dt, middle_time = start.time + gamma * dt, end_time = start.time + dt;
  const Eigen::VectorXd& before = start.response.power;
  StageSolution half = solve(run, {middle_time, step, start.content + step * before},
                             extrapolate(run.system, start, rate, middle_time, gamma * dt));
  if (!half.converged) return result;
  const Eigen::VectorXd target = start.content + dt * (weight[0] * before + weight[1] * half.response.power);
  const Rate first = rate_between(start.temperature, start.response, half.temperature, half.response, gamma * dt);
  StageSolution full = solve(run, {end_time, step, target}, extrapolate(run.system, start, first, end_time, dt));
  if (!full.converged) return result;

  const Eigen::VectorXd& after = full.response.power;
  Eigen::VectorXd error =
      dt * (error_weight[0] * before + error_weight[1] * half.response.power + error_weight[2] * after);
  for (const auto& [unknown, value, boundary] : run.system.prescribed) error[unknown] = 0;
  result.error = run.matrix.cholesky.solve(error).lpNorm<Eigen::Infinity>();
  ++run.solves;
  result.solved = std::isfinite(result.error);
  result.rate = rate_between(half.temperature, half.response, full.temperature, full.response, (1 - gamma) * dt);
  result.middle = std::move(half.response);
  result.end = {end_time, std::move(full.temperature), {}, target + step * after};
  result.end.response = std::move(full.response);
  if (half.solves > many_solves || full.solves > many_solves) run.matrix.factored_step = 0;
  return result;
}

/// Accumulates an accepted substep. The residuals of the prescribed unknowns' equations are the heat that entered
/// through the prescribed boundaries.
void accumulate_substep(HeatBalance& balance, const HeatSystem& system, const StageValue& start,
                        const TrialStep& accepted, double dt) {
  accumulate(balance, start.response.flows, dt * weight[0]);
  accumulate(balance, accepted.middle.flows, dt * weight[1]);
  accumulate(balance, accepted.end.response.flows, dt * weight[2]);
  for (const PrescribedUnknown& at : system.prescribed) {
    const Index unknown = at.unknown;
    const double power = weight[0] * start.response.power[unknown] + weight[1] * accepted.middle.power[unknown] +
                         weight[2] * accepted.end.response.power[unknown];
    accumulate_prescribed(balance, system, at,
                          accepted.end.response.content[unknown] - start.response.content[unknown] - dt * power);
  }
}

/// Solution at the start of a step. Prescribed temperatures are imposed, and the heat that this takes is accumulated as
/// heat through the prescribed boundaries.
StageValue begin(const HeatSystem& system, double time, const std::vector<Eigen::VectorXd>& temperature,
                 HeatBalance& balance) {
  StageValue start;
  start.time = time;
  start.temperature = join(system, temperature);
  start.response = evaluate(system, time, start.temperature);
  const Eigen::VectorXd before = start.response.content;
  if (impose_prescribed(system, time, start.temperature)) {
    start.response = evaluate(system, time, start.temperature);
    accumulate_content(balance, system, before, start.response.content);
    accumulate_imposed(balance, system);
  }
  start.content = start.response.content;
  return start;
}

/// The algebraic error of the last stage leaves a body with a little more or less heat than was integrated. One change
/// of all its temperatures that are not prescribed, within the error that the stage may have, makes that good, so that
/// the balance closes whatever that tolerance, K, is.
void restore_content(HeatBalance& balance, const HeatSystem& system, double tolerance, StageValue& end) {
  Eigen::VectorXd missing = end.content - end.response.content, free = Eigen::VectorXd::Ones(system.size());
  for (const PrescribedUnknown& at : system.prescribed) missing[at.unknown] = free[at.unknown] = 0;
  Response capacity{Eigen::VectorXd::Zero(system.size()), Eigen::VectorXd::Zero(system.size()), {}};
  add_cells(system, end.temperature, &free, capacity);
  Eigen::VectorXd& gained = capacity.content;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const Index first = system.first_unknown[b], count = system.first_unknown[b + 1] - first;
    const double per_kelvin = free.segment(first, count).dot(gained.segment(first, count));
    const double wanted = per_kelvin > 0 ? missing.segment(first, count).sum() / per_kelvin : 0;
    const double change = std::clamp(wanted, -tolerance, tolerance);
    end.temperature.segment(first, count) += change * free.segment(first, count);
    gained.segment(first, count) *= change;
  }
  end.response.content += gained;
  for (const PrescribedUnknown& at : system.prescribed) accumulate_prescribed(balance, system, at, gained[at.unknown]);
}

/// Substep whose error would just meet the tolerance, from that of a trial step: the error falls with the third power.
double fitting_size(const TrialStep& trial, double substep, double tolerance) {
  if (!trial.solved) return 0.25 * substep;
  const double factor = trial.error > 0 ? std::clamp(0.9 * std::cbrt(tolerance / trial.error), 0.1, 4.0) : 4.0;
  return substep * (trial.error > tolerance ? std::min(factor, 0.9) : factor);
}

/// Substep after an accepted one: the same, to reuse the factor, unless the larger one that the error allows saves more
/// substeps than a new factorisation costs.
double next_size(double substep, double fitting, double remaining) {
  constexpr double factor_cost = 2;  // substeps
  const double saved = std::round(remaining / substep) - std::ceil(remaining / fitting - 1e-9);
  return fitting > 1.3 * substep && saved >= factor_cost ? fitting : substep;
}

std::string describe_failure(const TrialStep& trial, double substep, const StepOptions& options) {
  const std::string what =
      trial.solved ? fmt::format("the error is {:.3g} K where {:.3g} K is allowed", trial.error, options.tolerance)
                   : "the equations do not converge";
  return fmt::format("heat: substeps below {:.3g} s would be needed: with {:.3g} s {}", options.min_substep, substep,
                     what);
}

/// Integrates over dt from `start`, which becomes the end of the last accepted substep, and sets counts, balance and
/// reason of the outcome.
void integrate(Integration& run, StageValue& start, double dt, StepOutcome& outcome) {
  const StepOptions& options = run.options;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(run.system.size());
  Rate rate{none, none, none};
  double remaining = dt, wanted = options.initial_substep > 0 ? options.initial_substep : dt;
  bool rejected_before = false;
  while (remaining > 0) {
    const double count = std::max(1.0, std::ceil(remaining / std::min(wanted, options.max_substep) - 1e-9));
    const double substep = remaining / count;
    TrialStep trial = try_step(run, start, rate, substep);
    const bool accepted = trial.solved && trial.error <= options.tolerance;
    const double fitting = fitting_size(trial, substep, options.tolerance);
    if (!accepted) {
      ++outcome.rejected;
      rejected_before = true;
      wanted = fitting;
      if (wanted >= options.min_substep) continue;
      outcome.reason = describe_failure(trial, substep, options);
      return;
    }
    if (outcome.substeps++ == 0) outcome.next_substep = fitting;
    accumulate_substep(outcome.balance, run.system, start, trial, substep);
    start = std::move(trial.end);
    rate = std::move(trial.rate);
    remaining = count > 1 ? remaining - substep : 0;
    wanted = std::exchange(rejected_before, false) ? substep : next_size(substep, fitting, remaining);
    // A new interface causes a start-up transient in every step alike, so the first fitting substep is proposed for the
    // next step; where it is far shorter than the last one, it was a transient of this step alone.
    outcome.next_substep = std::max(outcome.next_substep, startup_transient * fitting);
  }
  outcome.converged = true;
}

/// A step in which the absorption of every body is given or does not depend on temperature.
StepOutcome advance_once(const Problem& problem, double time, const std::vector<Eigen::VectorXd>& temperature,
                         double dt, const StepOptions& options, StepMatrix& matrix) {
  const HeatSystem system = make_heat_system(problem, &matrix.kept);
  StepOutcome outcome;
  outcome.reason = why_not_solvable(system);
  if (!outcome.reason.empty()) return outcome;
  prepare(matrix, system);
  const Index factorisations_before = matrix.factorisations;
  Integration run{system, options, matrix};
  outcome.balance = zero_balance(system);
  StageValue stage_value = begin(system, time, temperature, outcome.balance);
  if (!stage_value.response.power.allFinite() || !stage_value.response.content.allFinite()) {
    outcome.reason = "heat: the temperatures or the meshes at the start of the step are not finite";
    return outcome;
  }
  const Eigen::VectorXd content = stage_value.response.content;
  integrate(run, stage_value, dt, outcome);
  restore_content(outcome.balance, system, options.newton_tolerance, stage_value);
  accumulate_content(outcome.balance, system, content, stage_value.response.content);
  outcome.temperature = split(system, stage_value.temperature);
  outcome.factorisations = matrix.factorisations - factorisations_before;
  outcome.solves = run.solves;
  return outcome;
}

/// Whether the step has to find the temperatures at which a body absorbs.
bool wants_absorption(const BodyView& body) {
  return !body.absorption_at && absorption_varies(*body.material);
}

void take_absorption_at(const std::vector<Eigen::VectorXd>& temperature, Problem& problem) {
  for (std::size_t b = 0; b < problem.bodies.size(); ++b)
    if (absorption_varies(*problem.bodies[b].material)) problem.bodies[b].absorption_at = &temperature[b];
}

}  // namespace

StepOutcome advance(const Problem& problem, double time, const std::vector<Eigen::VectorXd>& temperature, double dt,
                    const StepOptions& options, StepMatrix& matrix) {
  if (std::none_of(problem.bodies.begin(), problem.bodies.end(), wants_absorption))
    return advance_once(problem, time, temperature, dt, options, matrix);
  Problem given = problem;
  take_absorption_at(temperature, given);
  const StepOutcome first = advance_once(given, time, temperature, dt, options, matrix);
  if (!first.converged) return first;
  std::vector<Eigen::VectorXd> middle = temperature;
  for (std::size_t b = 0; b < middle.size(); ++b) middle[b] = 0.5 * (temperature[b] + first.temperature[b]);
  take_absorption_at(middle, given);
  given.traced = nullptr;  // what was kept by the first
  return advance_once(given, time, temperature, dt, options, matrix);
}

}  // namespace parison::thermal
