// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/time/substeps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace parison::thermal {

namespace {

using Eigen::VectorXd;

// TR-BDF2 as the diagonally implicit Runge-Kutta method of Hosea and Shampine (1996, section 2): stages at t, at
// t + gamma dt and at t + dt, d = gamma/2 on the diagonal, weights (w, w, d) with w = sqrt(2)/4. The weights
// of the embedded method of third order are ((1 - w)/3, (3 w + 1)/3, d/3).
const double gamma = 2 - std::sqrt(2.0), d = gamma / 2, w = std::sqrt(2.0) / 4;
const std::array<double, 3> weight{w, w, d};
const std::array<double, 3> error_weight{w - (1 - w) / 3, w - (3 * w + 1) / 3, d - d / 3};

constexpr double startup_transient = 0.25;  ///< expected ratio of the first to the last fitting substep of a step

struct TrialStep {
  bool solved = false;
  double error = 0;  ///< max norm of the estimated local error, K
  StageValue middle, end;
};

/// One substep of length dt from `start`, with the rate of the substep before it for the initial guess.
TrialStep try_step(HeatStages& stages, const StageValue& start, const Rate& rate, double dt) {
  TrialStep trial;
  const double step = d * dt;
  const VectorXd& before = start.response.power;
  trial.middle =
      stages.solve_middle({start.time + gamma * dt, step, start.content + step * before}, start, rate, gamma * dt);
  if (!trial.middle.solved) return trial;
  const VectorXd& half = trial.middle.response.power;
  const StageEquation last{start.time + dt, step, start.content + dt * (weight[0] * before + weight[1] * half)};
  trial.end = stages.solve_end(last, start, trial.middle, dt);
  if (!trial.end.solved) return trial;
  const VectorXd& after = trial.end.response.power;
  VectorXd error = dt * (error_weight[0] * before + error_weight[1] * half + error_weight[2] * after);
  clear_prescribed(stages.unknowns, error);
  trial.error = stages.matrix.cholesky.solve(error).lpNorm<Eigen::Infinity>();
  ++stages.solves;
  trial.solved = std::isfinite(trial.error);
  trial.end.content = last.target + step * after;
  if (trial.middle.slow || trial.end.slow) stages.matrix.factored_step = 0;
  return trial;
}

/// Accumulates an accepted substep. The residuals of the prescribed unknowns' equations are the heat that entered
/// through the prescribed boundaries.
void accumulate_substep(HeatBalance& balance, const HeatUnknowns& unknowns, const StageValue& start,
                        const TrialStep& accepted, double dt) {
  const std::array<const Response*, 3> at{&start.response, &accepted.middle.response, &accepted.end.response};
  for (std::size_t i = 0; i < at.size(); ++i) accumulate(balance, at[i]->flows, dt * weight[i]);
  for (const PrescribedUnknown& given : unknowns.prescribed) {
    const Index u = given.unknown;
    const double power = weight[0] * at[0]->power[u] + weight[1] * at[1]->power[u] + weight[2] * at[2]->power[u];
    accumulate_prescribed(balance, given, at[2]->content[u] - at[0]->content[u] - dt * power);
  }
}

/// Solution at the start of a step. Prescribed temperatures are imposed, and the heat that this takes is accumulated as
/// heat through the prescribed boundaries.
StageValue begin(const HeatStages& stages, double time, const std::vector<VectorXd>& temperature,
                 HeatBalance& balance) {
  StageValue start;
  start.time = time;
  start.temperature = join(stages.unknowns, temperature);
  start.response = stages.response(time, start.temperature);
  const VectorXd before = start.response.content;
  if (impose_prescribed(stages.unknowns, time, start.temperature)) {
    start.response = stages.response(time, start.temperature);
    accumulate_content(balance, stages.unknowns, before, start.response.content);
    accumulate_imposed(balance, stages.unknowns);
  }
  start.content = start.response.content;
  return start;
}

/// Substep whose error would just meet the tolerance, from that of a trial step: the error falls with the third power.
double fitting_size(const TrialStep& trial, double substep, double tolerance) {
  if (!trial.solved) return 0.25 * substep;
  const double factor = trial.error > 0 ? std::clamp(0.9 * std::cbrt(tolerance / trial.error), 0.1, 4.0) : 4.0;
  return substep * (trial.error > tolerance ? std::min(factor, 0.9) : factor);
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
void integrate(HeatStages& stages, StageValue& start, double dt, StepOutcome& outcome) {
  const StepOptions& options = stages.options;
  const VectorXd none = VectorXd::Zero(stages.unknowns.size());
  Rate rate{none, none, none};
  double remaining = dt, wanted = options.initial_substep > 0 ? options.initial_substep : dt;
  bool rejected_before = false;
  while (remaining > 0) {
    const double count = std::max(1.0, std::ceil(remaining / std::min(wanted, options.max_substep) - 1e-9));
    const double substep = remaining / count;
    TrialStep trial = try_step(stages, start, rate, substep);
    const double fitting = fitting_size(trial, substep, options.tolerance);
    if (!trial.solved || trial.error > options.tolerance) {
      ++outcome.rejected;
      rejected_before = true;
      wanted = fitting;
      if (wanted >= options.min_substep) continue;
      outcome.reason = describe_failure(trial, substep, options);
      return;
    }
    if (outcome.substeps++ == 0) outcome.next_substep = fitting;
    accumulate_substep(outcome.balance, stages.unknowns, start, trial, substep);
    rate = rate_between(trial.middle, trial.end, (1 - gamma) * substep);
    start = std::move(trial.end);
    remaining = count > 1 ? remaining - substep : 0;
    wanted = stages.next_size(substep, fitting, remaining, std::exchange(rejected_before, false));
    // A new interface causes a start-up transient in every step alike, so the first fitting substep is proposed for the
    // next step; where it is far shorter than the last one, it was a transient of this step alone.
    outcome.next_substep = std::max(outcome.next_substep, startup_transient * fitting);
  }
  outcome.converged = true;
}

}  // namespace

double middle_of_substep() {
  return gamma;
}

Rate rate_between(const StageValue& first, const StageValue& second, double duration) {
  return {(second.temperature - first.temperature) / duration,
          (second.response.content - first.response.content) / duration,
          (second.response.power - first.response.power) / duration};
}

StepOutcome advance_in_substeps(HeatStages& stages, double time, const std::vector<VectorXd>& temperature, double dt) {
  StepOutcome outcome;
  const Index factorisations_before = stages.matrix.factorisations;
  outcome.balance = zero_balance(stages.unknowns);
  StageValue value = begin(stages, time, temperature, outcome.balance);
  if (!value.response.power.allFinite() || !value.response.content.allFinite()) {
    outcome.reason = "heat: the temperatures or the meshes at the start of the step are not finite";
    return outcome;
  }
  const VectorXd content = value.response.content;
  integrate(stages, value, dt, outcome);
  stages.restore_content(outcome.balance, value);
  accumulate_content(outcome.balance, stages.unknowns, content, value.response.content);
  outcome.temperature = split(stages.unknowns, value.temperature);
  outcome.factorisations = stages.matrix.factorisations - factorisations_before;
  outcome.solves = stages.solves;
  return outcome;
}

}  // namespace parison::thermal
