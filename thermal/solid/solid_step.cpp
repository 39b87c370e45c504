// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/solid/solid_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/linear/anderson.hpp"
#include "thermal/solid/solid_cells.hpp"

namespace parison::thermal {

namespace {

using Eigen::VectorXd;

// As in time/tr_bdf2.cpp (Hosea and Shampine 1996, section 2).
const double gamma = 2 - std::sqrt(2.0), d = gamma / 2, w = std::sqrt(2.0) / 4;
const std::array<double, 3> weight{w, w, d};
const std::array<double, 3> error_weight{w - (1 - w) / 3, w - (3 * w + 1) / 3, d - d / 3};

/// Factors of the substep between which the factor of another one, or of the step before, is tried.
constexpr double least_ratio = 0.7, most_ratio = 1.5;
constexpr int many_updates = 8;  ///< of a stage, after which the next one has a new factor
constexpr std::size_t anderson_depth = 4;
constexpr int max_updates = 25;
constexpr double divergence = 1e3;  ///< growth of an update over the smallest one at which a stage is given up

struct Integration {
  const SolidSystem& system;
  const StepOptions& options;
  SolidStepMatrix& matrix;
  Index solves = 0;
};

/// content(T) - step power(T, time) = target.
struct Stage {
  double time, step;  ///< s
  VectorXd target;    ///< J
};
struct StageValue {
  VectorXd temperature;  ///< by unknown, K
  Response response;     ///< there
  VectorXd content;      ///< as integrated in time, J
  bool solved = false;
};

VectorXd residual_of(const SolidSystem& system, const Stage& stage, const Response& at) {
  VectorXd residual = at.content - stage.step * at.power - stage.target;
  for (const SolidPrescribed& each : system.prescribed) residual[each.unknown] = 0;
  return residual;
}

/// Modified Newton with the present factor.
StageValue iterate(Integration& run, const Stage& stage, VectorXd temperature) {
  StageValue at{std::move(temperature), {}, {}};
  core::AndersonAcceleration history(anderson_depth);
  VectorXd last_update, last_move;
  double smallest = std::numeric_limits<double>::infinity(), last_scaled = 0, size = 0;
  for (int updates = 0; updates < max_updates; ++updates) {
    at.response = evaluate(run.system, stage.time, at.temperature);
    const VectorXd residual = residual_of(run.system, stage, at.response);
    const double scaled = residual.cwiseQuotient(run.matrix.diagonal).lpNorm<Eigen::Infinity>();
    // Error and residual fall alike up to the shape of the field, for which the factor 10 allows.
    at.solved = scaled == 0 || (updates > 0 && 10 * size * scaled <= run.options.newton_tolerance * last_scaled);
    if (at.solved || !std::isfinite(scaled)) return at;
    last_scaled = scaled;
    const VectorXd update = -run.matrix.cholesky.solve(residual);
    ++run.solves;
    size = update.lpNorm<Eigen::Infinity>();
    at.solved = updates > 0 && size <= run.options.newton_tolerance;
    if (at.solved || !(size <= divergence * smallest)) return at;
    if (last_update.size() > 0) history.add(last_move + (update - last_update), update - last_update);
    last_move = history.accelerated(update, update);
    last_update = update;
    smallest = std::min(smallest, size);
    at.temperature += last_move;
  }
  return at;
}

/// Solves a stage with the present factor, or with a new one where its step differs or the iteration fails.
StageValue solve(Integration& run, const Stage& stage, VectorXd guess) {
  impose_prescribed(run.system, stage.time, guess);
  const auto refactorise = [&] { return factorise(run.matrix, run.system, stage.time, guess, stage.step); };
  const double ratio = run.matrix.factored_step / stage.step;
  const bool fresh = !(ratio >= least_ratio && ratio <= most_ratio);
  if (fresh && !refactorise()) return {};
  const Index before = run.solves;
  StageValue value = iterate(run, stage, guess);
  if (!value.solved && !fresh && refactorise())
    value = iterate(run, stage, guess);
  else if (!fresh && run.solves - before > many_updates)
    run.matrix.factored_step = 0;
  value.content = stage.target + stage.step * value.response.power;
  return value;
}

struct TrialStep {
  bool solved = false;
  double error = 0;  ///< max norm of the estimated local error, K
  StageValue middle, end;
};

/// One substep from `start`; `rate`, K/s, is that of the one before it.
TrialStep try_step(Integration& run, double time, const StageValue& start, const VectorXd& rate, double dt) {
  TrialStep trial;
  const double step = d * dt;
  const VectorXd& before = start.response.power;
  trial.middle =
      solve(run, {time + gamma * dt, step, start.content + step * before}, start.temperature + gamma * dt * rate);
  if (!trial.middle.solved) return trial;
  const VectorXd& half = trial.middle.response.power;
  const VectorXd guess = start.temperature + (trial.middle.temperature - start.temperature) / gamma;
  trial.end = solve(run, {time + dt, step, start.content + dt * (weight[0] * before + weight[1] * half)}, guess);
  if (!trial.end.solved) return trial;
  const VectorXd& after = trial.end.response.power;
  VectorXd error = dt * (error_weight[0] * before + error_weight[1] * half + error_weight[2] * after);
  for (const SolidPrescribed& at : run.system.prescribed) error[at.unknown] = 0;
  trial.error = run.matrix.cholesky.solve(error).lpNorm<Eigen::Infinity>();
  ++run.solves;
  trial.solved = std::isfinite(trial.error);
  return trial;
}

void book_prescribed(HeatBalance& balance, const SolidPrescribed& at, double heat) {
  balance.bodies[at.body].from_prescribed += heat;
  balance.through_boundary[at.boundary] -= heat;
}

/// The residuals of the prescribed unknowns' equations are the heat that entered there.
void accumulate_substep(HeatBalance& balance, const SolidSystem& system, const StageValue& start,
                        const TrialStep& trial, double dt) {
  accumulate(balance, start.response.flows, dt * weight[0]);
  accumulate(balance, trial.middle.response.flows, dt * weight[1]);
  accumulate(balance, trial.end.response.flows, dt * weight[2]);
  for (const SolidPrescribed& at : system.prescribed) {
    const Index u = at.unknown;
    const double power = weight[0] * start.response.power[u] + weight[1] * trial.middle.response.power[u] +
                         weight[2] * trial.end.response.power[u];
    book_prescribed(balance, at, trial.end.response.content[u] - start.response.content[u] - dt * power);
  }
}

void accumulate_content(HeatBalance& balance, const SolidSystem& system, const VectorXd& change) {
  for (std::size_t b = 0; b < balance.bodies.size(); ++b)
    balance.bodies[b].content_change +=
        change.segment(system.first_unknown[b], system.first_unknown[b + 1] - system.first_unknown[b]).sum();
}

/// Solution at the start. What it takes to impose prescribed temperatures is booked as heat through their boundaries.
StageValue begin(const SolidSystem& system, double time, const std::vector<VectorXd>& temperature,
                 HeatBalance& balance) {
  StageValue start;
  start.temperature = join(temperature);
  start.response = evaluate(system, time, start.temperature);
  const VectorXd before = start.response.content;
  if (impose_prescribed(system, time, start.temperature)) {
    start.response = evaluate(system, time, start.temperature);
    const VectorXd change = start.response.content - before;
    accumulate_content(balance, system, change);
    std::vector<char> booked(balance.bodies.size(), 0);
    for (const SolidPrescribed& at : system.prescribed)
      if (!std::exchange(booked[at.body], 1)) book_prescribed(balance, at, balance.bodies[at.body].content_change);
  }
  start.content = start.response.content;
  return start;
}

/// One change of all temperatures of a body that are not prescribed, within the algebraic error of the last stage,
/// gives the body exactly the heat that was integrated.
void restore_content(HeatBalance& balance, const SolidSystem& system, double tolerance, StageValue& end) {
  VectorXd missing = end.content - end.response.content, capacity = VectorXd::Zero(system.size());
  for (const SolidLaws& body : system.bodies) add_capacity(body, end.temperature, capacity);
  for (const SolidPrescribed& at : system.prescribed) missing[at.unknown] = 0;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const Index first = system.first_unknown[b], count = system.first_unknown[b + 1] - first;
    double free_capacity = 0;
    for (Index u = first; u < first + count; ++u)
      if (!system.is_prescribed[u]) free_capacity += capacity[u];
    if (!(free_capacity > 0)) continue;
    const double change = std::clamp(missing.segment(first, count).sum() / free_capacity, -tolerance, tolerance);
    for (Index u = first; u < first + count; ++u)
      if (!system.is_prescribed[u]) end.temperature[u] += change;
  }
  const VectorXd before = std::move(end.response.content);
  Response content{VectorXd::Zero(system.size()), VectorXd::Zero(system.size()), {}};
  for (const SolidLaws& body : system.bodies) add_cells(body, end.temperature, content);
  end.response.content = std::move(content.content);
  for (const SolidPrescribed& at : system.prescribed)
    book_prescribed(balance, at, end.response.content[at.unknown] - before[at.unknown]);
}

/// Substep whose error would just meet the tolerance: the error falls with the third power.
double fitting_size(const TrialStep& trial, double substep, double tolerance) {
  if (!trial.solved) return 0.25 * substep;
  const double factor = trial.error > 0 ? std::clamp(0.9 * std::cbrt(tolerance / trial.error), 0.1, 4.0) : 4.0;
  return substep * (trial.error > tolerance ? std::min(factor, 0.9) : factor);
}

/// Integrates over dt from `start`, which becomes the end, and sets the counts, balance and reason of the outcome.
void integrate(Integration& run, double time, StageValue& start, double dt, StepOutcome& outcome) {
  const StepOptions& options = run.options;
  VectorXd rate = VectorXd::Zero(run.system.size());
  double remaining = dt, wanted = options.initial_substep > 0 ? options.initial_substep : dt;
  while (remaining > 0) {
    const double count = std::max(1.0, std::ceil(remaining / std::min(wanted, options.max_substep) - 1e-9));
    const double substep = remaining / count;
    TrialStep trial = try_step(run, time, start, rate, substep);
    const double fitting = fitting_size(trial, substep, options.tolerance);
    if (!trial.solved || trial.error > options.tolerance) {
      ++outcome.rejected;
      wanted = fitting;
      if (wanted >= options.min_substep) continue;
      outcome.reason = fmt::format("heat: substeps below {:.3g} s would be needed", options.min_substep);
      return;
    }
    if (outcome.substeps++ == 0) outcome.next_substep = fitting;
    accumulate_substep(outcome.balance, run.system, start, trial, substep);
    rate = (trial.end.temperature - trial.middle.temperature) / ((1 - gamma) * substep);
    start = std::move(trial.end);
    time += substep;
    remaining = count > 1 ? remaining - substep : 0;
    wanted = fitting > 1.3 * substep ? fitting : substep;
    outcome.next_substep = std::max(outcome.next_substep, 0.25 * fitting);
  }
  outcome.converged = true;
}

}  // namespace

StepOutcome advance(const SolidProblem& problem, double time, const std::vector<VectorXd>& temperature, double dt,
                    const StepOptions& options, SolidStepMatrix& matrix) {
  const SolidSystem system = make_solid_system(problem, temperature);
  StepOutcome outcome;
  outcome.reason = why_not_solvable(system);
  if (!outcome.reason.empty()) return outcome;
  prepare(matrix, system);
  const Index factorisations_before = matrix.factorisations;
  Integration run{system, options, matrix};
  outcome.balance = zero_balance(system);
  StageValue value = begin(system, time, temperature, outcome.balance);
  if (!value.response.power.allFinite() || !value.response.content.allFinite()) {
    outcome.reason = "heat: the temperatures or the meshes at the start of the step are not finite";
    return outcome;
  }
  const VectorXd content = value.response.content;
  integrate(run, time, value, dt, outcome);
  restore_content(outcome.balance, system, options.newton_tolerance, value);
  accumulate_content(outcome.balance, system, value.response.content - content);
  outcome.temperature = split(system, value.temperature);
  outcome.factorisations = matrix.factorisations - factorisations_before;
  outcome.solves = run.solves;
  return outcome;
}

}  // namespace parison::thermal
