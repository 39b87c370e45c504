// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/time/tr_bdf2.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "thermal/time/stage_solver.hpp"

namespace parison::thermal {

namespace {

// Stages at 0, middle and 1; both implicit ones solve content - implicit dt power = target.
const double middle = 2 - std::sqrt(2.0), implicit = middle / 2, w = std::sqrt(2.0) / 4;
const std::array<double, 3> weight{w, w, implicit};
const std::array<double, 3> error_weight{w - (1 - w) / 3, w - (3 * w + 1) / 3, implicit - implicit / 3};

constexpr double reuse_band = 1e-9;         ///< relative change of the step that the factor bears
constexpr double startup_transient = 0.25;  ///< first over last fitting substep of a step
constexpr Index many_solves = 7;            ///< a stage that needs more asks for a new factor

struct Run {
  const HeatSystem& system;
  const StepOptions& options;
  StepMatrix& matrix;
  Index solves = 0;
};

/// Temperatures, what the equations say there, and the content that they have accounted for.
struct StageValue {
  Eigen::VectorXd temperature;
  Response response;
  Eigen::VectorXd content;  ///< J
};

/// Change with time over the last part of a substep, per second.
struct Rate {
  Eigen::VectorXd temperature, content, power;
};

struct TrialStep {
  bool solved = false;
  double error = 0;  ///< K
  Response middle;
  StageValue end;
  Rate rate;
};

Rate rate_between(const Eigen::VectorXd& first, const Response& before, const Eigen::VectorXd& second,
                  const Response& after, double duration) {
  return {(second - first) / duration, (after.content - before.content) / duration,
          (after.power - before.power) / duration};
}

StageGuess extrapolate(const StageValue& start, const Rate& rate, double duration) {
  return {start.temperature + duration * rate.temperature, start.response.content + duration * rate.content,
          start.response.power + duration * rate.power};
}

/// Solves a stage with the factor at hand, or with a new one where that does not serve.
StageSolution solve(Run& run, const StageEquation& equation, const StageGuess& guess) {
  bool fresh = false;
  const auto refactorise = [&] { return fresh = factorise(run.matrix, run.system, guess.temperature, equation.step); };
  if (!(std::abs(run.matrix.factored_step / equation.step - 1) <= reuse_band) && !refactorise()) return {};
  StageSolution solution = solve_stage(run.system, run.matrix, equation, guess, run.options.newton_tolerance);
  run.solves += solution.solves;
  if (!solution.converged && !fresh && refactorise()) {
    solution = solve_stage(run.system, run.matrix, equation, guess, run.options.newton_tolerance);
    run.solves += solution.solves;
  }
  return solution;
}

TrialStep try_step(Run& run, const StageValue& start, const Rate& rate, double dt) {
  TrialStep result;
  const double step = implicit * dt;
  const Eigen::VectorXd& before = start.response.power;
  StageSolution half = solve(run, {step, start.content + step * before}, extrapolate(start, rate, middle * dt));
  if (!half.converged) return result;
  const Eigen::VectorXd target = start.content + dt * (weight[0] * before + weight[1] * half.response.power);
  const Rate first = rate_between(start.temperature, start.response, half.temperature, half.response, middle * dt);
  StageSolution full = solve(run, {step, target}, extrapolate(start, first, dt));
  if (!full.converged) return result;

  const Eigen::VectorXd& after = full.response.power;
  Eigen::VectorXd error =
      dt * (error_weight[0] * before + error_weight[1] * half.response.power + error_weight[2] * after);
  for (const auto& [unknown, value] : run.system.prescribed) error[unknown] = 0;
  result.error = run.matrix.cholesky.solve(error).lpNorm<Eigen::Infinity>();
  ++run.solves;
  result.solved = std::isfinite(result.error);
  result.rate = rate_between(half.temperature, half.response, full.temperature, full.response, (1 - middle) * dt);
  result.middle = std::move(half.response);
  result.end = {std::move(full.temperature), {}, target + step * after};
  result.end.response = std::move(full.response);
  if (half.solves > many_solves || full.solves > many_solves) run.matrix.factored_step = 0;
  return result;
}

/// Accumulates an accepted substep. What the equations of the prescribed unknowns lack is what flowed in through them.
void accumulate_substep(HeatBalance& balance, const HeatSystem& system, const StageValue& start,
                        const TrialStep& accepted, double dt) {
  accumulate(balance, start.response.flows, dt * weight[0]);
  accumulate(balance, accepted.middle.flows, dt * weight[1]);
  accumulate(balance, accepted.end.response.flows, dt * weight[2]);
  for (const auto& [unknown, value] : system.prescribed) {
    const double power = weight[0] * start.response.power[unknown] + weight[1] * accepted.middle.power[unknown] +
                         weight[2] * accepted.end.response.power[unknown];
    balance.bodies[body_of(system, unknown)].from_prescribed +=
        accepted.end.response.content[unknown] - start.response.content[unknown] - dt * power;
  }
}

/// Start of a step: prescribed temperatures are set, and the heat that takes is accumulated as coming through them.
StageValue begin(const HeatSystem& system, const std::vector<Eigen::VectorXd>& temperature, HeatBalance& balance) {
  StageValue start;
  start.temperature = join(system, temperature);
  start.response = evaluate(system, start.temperature);
  if (!system.prescribed.empty()) {
    const Eigen::VectorXd before = start.response.content;
    for (const auto& [unknown, value] : system.prescribed) start.temperature[unknown] = value;
    start.response = evaluate(system, start.temperature);
    accumulate_content(balance, system, before, start.response.content);
    for (BodyBalance& body : balance.bodies) body.from_prescribed = body.content_change;
  }
  start.content = start.response.content;
  return start;
}

/// Size that suits the error of an attempt, which falls with the third power of it.
double fitting_size(const TrialStep& trial, double substep, double tolerance) {
  if (!trial.solved) return 0.25 * substep;
  const double factor = trial.error > 0 ? std::clamp(0.9 * std::cbrt(tolerance / trial.error), 0.1, 4.0) : 4.0;
  return substep * (trial.error > tolerance ? std::min(factor, 0.9) : factor);
}

/// Size after an accepted substep: the same, for its factor, unless a larger one that the error allows saves more
/// substeps than the new factor costs.
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

/// Substeps over dt from `start`, which ends at the last accepted one; counts, balance and reason go into the outcome.
void integrate(Run& run, StageValue& start, double dt, StepOutcome& outcome) {
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
    // A new interface jolts the start of each step alike; a first substep far too short for the last was a jolt of its
    // own.
    outcome.next_substep = std::max(outcome.next_substep, startup_transient * fitting);
  }
  outcome.converged = true;
}

}  // namespace

StepOutcome advance(const Problem& problem, const std::vector<Eigen::VectorXd>& temperature, double dt,
                    const StepOptions& options, StepMatrix& matrix) {
  const HeatSystem system = make_heat_system(problem, &matrix.kept);
  prepare(matrix, system);
  const Index factorisations_before = matrix.factorisations;
  Run run{system, options, matrix};
  StepOutcome outcome;
  outcome.balance = zero_balance(system);
  StageValue stage_value = begin(system, temperature, outcome.balance);
  if (!stage_value.response.power.allFinite() || !stage_value.response.content.allFinite()) {
    outcome.reason = "heat: the temperatures or the meshes at the start of the step are not finite";
    return outcome;
  }
  const Eigen::VectorXd content = stage_value.response.content;
  integrate(run, stage_value, dt, outcome);
  accumulate_content(outcome.balance, system, content, stage_value.response.content);
  outcome.temperature = split(system, stage_value.temperature);
  outcome.factorisations = matrix.factorisations - factorisations_before;
  outcome.solves = run.solves;
  return outcome;
}

}  // namespace parison::thermal
