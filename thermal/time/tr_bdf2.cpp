// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/time/tr_bdf2.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "thermal/cells/cell_kernels.hpp"
#include "thermal/time/stage_solver.hpp"

namespace parison::thermal {

namespace {

constexpr double same_step = 1e-9;  ///< relative change of the substep up to which the factor is reused
constexpr Index many_solves = 7;    ///< a stage that needs more causes a new factorisation

/// Initial guess at `time`; evaluated there where prescribed temperatures do not follow the extrapolation.
StageGuess extrapolate(const HeatSystem& system, const StageValue& start, const Rate& rate, double time,
                       double duration) {
  StageGuess guess{start.temperature + duration * rate.temperature, start.response.content + duration * rate.content,
                   start.response.power + duration * rate.power};
  if (!impose_prescribed(system, time, guess.temperature)) return guess;
  Response response = evaluate(system, time, guess.temperature);
  return {std::move(guess.temperature), std::move(response.content), std::move(response.power)};
}

struct PlaneStages final : HeatStages {
  const HeatSystem& system;
  StepMatrix& step_matrix;

  PlaneStages(const HeatSystem& of, StepMatrix& with, const StepOptions& by)
      : HeatStages(of, with, by), system(of), step_matrix(with) {}

  Response response(double time, const Eigen::VectorXd& temperature) const override {
    return evaluate(system, time, temperature);
  }

  StageValue solve_middle(const StageEquation& equation, const StageValue& start, const Rate& rate,
                          double duration) override {
    return solve(equation, extrapolate(system, start, rate, equation.time, duration));
  }

  StageValue solve_end(const StageEquation& equation, const StageValue& start, const StageValue& middle,
                       double dt) override {
    const Rate rate = rate_between(start, middle, middle_of_substep() * dt);
    return solve(equation, extrapolate(system, start, rate, equation.time, dt));
  }

  /// Solves a stage with the present factor, or with a new one where its step differs or Newton's method fails.
  StageValue solve(const StageEquation& equation, const StageGuess& guess) {
    bool fresh = false;
    const auto refactorise = [&] {
      return fresh = factorise(step_matrix, system, equation.time, guess.temperature, equation.step);
    };
    if (!(std::abs(matrix.factored_step / equation.step - 1) <= same_step) && !refactorise()) return {};
    StageSolution solution = solve_stage(system, step_matrix, equation, guess, options.newton_tolerance);
    solves += solution.solves;
    if (!solution.converged && !fresh && refactorise()) {
      solution = solve_stage(system, step_matrix, equation, guess, options.newton_tolerance);
      solves += solution.solves;
    }
    return {
        solution.converged,           equation.time, std::move(solution.temperature), std::move(solution.response), {},
        solution.solves > many_solves};
  }

  /// The same, to reuse the factor, unless the larger one that the error allows saves more substeps than a new
  /// factorisation costs.
  double next_size(double substep, double fitting, double remaining, bool rejected_before) const override {
    constexpr double factor_cost = 2;  // substeps
    const double saved = std::round(remaining / substep) - std::ceil(remaining / fitting - 1e-9);
    return !rejected_before && fitting > 1.3 * substep && saved >= factor_cost ? fitting : substep;
  }

  void restore_content(HeatBalance& balance, StageValue& end) const override {
    Eigen::VectorXd missing = end.content - end.response.content, free = Eigen::VectorXd::Ones(system.size());
    clear_prescribed(system, missing);
    clear_prescribed(system, free);
    Response capacity{Eigen::VectorXd::Zero(system.size()), Eigen::VectorXd::Zero(system.size()), {}};
    add_cells(system, end.temperature, &free, capacity);
    Eigen::VectorXd& gained = capacity.content;
    for (Index b = 0; b < system.body_count(); ++b) {
      const Index first = system.first_unknown[b], count = system.size_of(b);
      const double per_kelvin = free.segment(first, count).dot(gained.segment(first, count));
      const double wanted = per_kelvin > 0 ? missing.segment(first, count).sum() / per_kelvin : 0;
      const double change = std::clamp(wanted, -options.newton_tolerance, options.newton_tolerance);
      end.temperature.segment(first, count) += change * free.segment(first, count);
      gained.segment(first, count) *= change;
    }
    end.response.content += gained;
    for (const PrescribedUnknown& at : system.prescribed) accumulate_prescribed(balance, at, gained[at.unknown]);
  }
};

/// A step in which the absorption of every body is given or does not depend on temperature.
StepOutcome advance_once(const Problem& problem, double time, const std::vector<Eigen::VectorXd>& temperature,
                         double dt, const StepOptions& options, StepMatrix& matrix) {
  const HeatSystem system = make_heat_system(problem, &matrix.kept);
  if (std::string reason = why_not_solvable(system); !reason.empty()) return failed_step(std::move(reason));
  prepare(matrix, system);
  PlaneStages stages(system, matrix, options);
  return advance_in_substeps(stages, time, temperature, dt);
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
