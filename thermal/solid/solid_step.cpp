// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/solid/solid_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/linear/anderson.hpp"
#include "thermal/solid/solid_cells.hpp"

namespace parison::thermal {

namespace {

using Eigen::VectorXd;

/// Factors of the substep between which the factor of another one, or of the step before, is tried.
constexpr double least_ratio = 0.7, most_ratio = 1.5;
constexpr int many_updates = 8;  ///< of a stage, after which the next one has a new factor
constexpr int max_updates = 25;
constexpr double divergence = 1e3;  ///< growth of an update over the smallest one at which a stage is given up

VectorXd residual_of(const SolidSystem& system, const StageEquation& equation, const Response& at) {
  VectorXd residual = at.content - equation.step * at.power - equation.target;
  clear_prescribed(system, residual);
  return residual;
}

struct SpaceStages final : HeatStages {
  const SolidSystem& system;
  SolidStepMatrix& step_matrix;

  SpaceStages(const SolidSystem& of, SolidStepMatrix& with, const StepOptions& by)
      : HeatStages(of, with, by), system(of), step_matrix(with) {}

  Response response(double time, const VectorXd& temperature) const override {
    return evaluate(system, time, temperature);
  }

  StageValue solve_middle(const StageEquation& equation, const StageValue& start, const Rate& rate,
                          double duration) override {
    return solve(equation, start.temperature + duration * rate.temperature);
  }

  StageValue solve_end(const StageEquation& equation, const StageValue& start, const StageValue& middle,
                       double) override {
    return solve(equation, start.temperature + (middle.temperature - start.temperature) / middle_of_substep());
  }

  /// Modified Newton with the present factor.
  StageValue iterate(const StageEquation& equation, VectorXd temperature) {
    StageValue at{false, equation.time, std::move(temperature), {}, {}};
    core::AndersonAcceleration history(anderson_depth);
    double smallest = std::numeric_limits<double>::infinity(), last_scaled = 0, size = 0;
    for (int updates = 0; updates < max_updates; ++updates) {
      at.response = evaluate(system, equation.time, at.temperature);
      const VectorXd residual = residual_of(system, equation, at.response);
      const double scaled = residual.cwiseQuotient(matrix.diagonal).lpNorm<Eigen::Infinity>();
      // Error and residual fall alike up to the shape of the field, for which the factor 10 allows.
      at.solved = scaled == 0 || (updates > 0 && 10 * size * scaled <= options.newton_tolerance * last_scaled);
      if (at.solved || !std::isfinite(scaled)) return at;
      last_scaled = scaled;
      const VectorXd update = -matrix.cholesky.solve(residual);
      ++solves;
      size = update.lpNorm<Eigen::Infinity>();
      at.solved = updates > 0 && size <= options.newton_tolerance;
      if (at.solved || !(size <= divergence * smallest)) return at;
      smallest = std::min(smallest, size);
      at.temperature += history.next_move(update);
    }
    return at;
  }

  /// Solves a stage with the present factor, or with a new one where its step differs or the iteration fails.
  StageValue solve(const StageEquation& equation, VectorXd guess) {
    impose_prescribed(system, equation.time, guess);
    const auto refactorise = [&] { return factorise(step_matrix, system, equation.time, guess, equation.step); };
    const double ratio = matrix.factored_step / equation.step;
    const bool fresh = !(ratio >= least_ratio && ratio <= most_ratio);
    if (fresh && !refactorise()) return {};
    const Index before = solves;
    StageValue value = iterate(equation, guess);
    if (!value.solved && !fresh && refactorise())
      value = iterate(equation, guess);
    else if (!fresh && solves - before > many_updates)
      matrix.factored_step = 0;
    return value;
  }

  double next_size(double substep, double fitting, double, bool) const override {
    return fitting > 1.3 * substep ? fitting : substep;
  }

  void restore_content(HeatBalance& balance, StageValue& end) const override {
    VectorXd missing = end.content - end.response.content, capacity = VectorXd::Zero(system.size());
    for (const SolidLaws& body : system.bodies) add_capacity(body, end.temperature, capacity);
    clear_prescribed(system, missing);
    for (Index b = 0; b < system.body_count(); ++b) {
      const Index first = system.first_unknown[b], count = system.size_of(b);
      double free_capacity = 0;
      for (Index u = first; u < first + count; ++u)
        if (!system.is_prescribed[u]) free_capacity += capacity[u];
      if (!(free_capacity > 0)) continue;
      const double change = std::clamp(missing.segment(first, count).sum() / free_capacity, -options.newton_tolerance,
                                       options.newton_tolerance);
      for (Index u = first; u < first + count; ++u)
        if (!system.is_prescribed[u]) end.temperature[u] += change;
    }
    const VectorXd before = std::move(end.response.content);
    Response content{VectorXd::Zero(system.size()), VectorXd::Zero(system.size()), {}};
    for (const SolidLaws& body : system.bodies) add_cells(body, end.temperature, content);
    end.response.content = std::move(content.content);
    for (const PrescribedUnknown& at : system.prescribed)
      accumulate_prescribed(balance, at, end.response.content[at.unknown] - before[at.unknown]);
  }
};

}  // namespace

StepOutcome advance(const SolidProblem& problem, double time, const std::vector<VectorXd>& temperature, double dt,
                    const StepOptions& options, SolidStepMatrix& matrix) {
  const SolidSystem system = make_solid_system(problem, temperature);
  if (std::string reason = why_not_solvable(system); !reason.empty()) return failed_step(std::move(reason));
  prepare(matrix, system);
  SpaceStages stages(system, matrix, options);
  return advance_in_substeps(stages, time, temperature, dt);
}

}  // namespace parison::thermal
