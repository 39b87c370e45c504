#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/linear/cholesky.hpp"
#include "core/linear/sparse_matrix.hpp"
#include "thermal/unknowns.hpp"

namespace parison::thermal {

/// Error control of TR-BDF2.
struct StepOptions {
  double tolerance = 0.1;           ///< max estimated local error of a substep at any node, K
  double newton_tolerance = 1e-10;  ///< max algebraic error of a stage at any node, K
  double initial_substep = 0;       ///< s; 0: the whole step
  double max_substep = std::numeric_limits<double>::infinity();  ///< s
  double min_substep = 1e-12;                                    ///< s; the step fails where less would be needed
};

/// Result of a step; when it did not converge, temperature and balance are those after the last accepted substep.
struct StepOutcome {
  bool converged = false;
  std::string reason;                        ///< why it did not converge
  std::vector<Eigen::VectorXd> temperature;  ///< by body and node, K
  HeatBalance balance;                       ///< over the step
  double next_substep = 0;                   ///< proposed initial substep of the next call, s
  Index substeps = 0, rejected = 0, factorisations = 0, solves = 0;
};

inline StepOutcome failed_step(std::string reason) {
  StepOutcome outcome;
  outcome.reason = std::move(reason);
  return outcome;
}

/// Updates of modified Newton that Anderson's acceleration remembers.
inline constexpr std::size_t anderson_depth = 4;

/// Matrix C + step K of the stage equations and its Cholesky factor, kept from step to step: C the heat capacity, K the
/// stiffness of conduction, exchange and interface.
struct HeatMatrix {
  core::Assembly assembly;
  core::Cholesky cholesky;
  Eigen::VectorXd diagonal;         ///< by unknown, of the factored matrix, J/K
  std::vector<char> is_prescribed;  ///< by unknown; their rows and columns are those of the identity
  double factored_step = 0;         ///< s; 0 without a factor
  Index factorisations = 0;         ///< since the start
};

/// Equation of an implicit stage: content(T) - step power(time, T) = target at every unknown that is not prescribed.
struct StageEquation {
  double time;             ///< of the stage, s
  double step;             ///< s
  Eigen::VectorXd target;  ///< by unknown, J
};

/// Solution at the time of a stage.
struct StageValue {
  bool solved = false;
  double time = 0;              ///< s
  Eigen::VectorXd temperature;  ///< by unknown, K
  Response response;            ///< at that time and temperature
  Eigen::VectorXd content;      ///< as integrated in time: that of the response up to the algebraic error, J
  bool slow = false;            ///< the factor is not to serve beyond this substep
};

/// Rates of change from one stage to another, per second.
struct Rate {
  Eigen::VectorXd temperature, content, power;
};
Rate rate_between(const StageValue& first, const StageValue& second, double duration);

/// What a substep of TR-BDF2 asks of heat equations. A stage that is not solved is returned as such; `content` of one
/// that is need not be set.
struct HeatStages {
  const HeatUnknowns& unknowns;
  HeatMatrix& matrix;
  const StepOptions& options;
  Index solves = 0;  ///< with the factor

  HeatStages(const HeatUnknowns& of, HeatMatrix& with, const StepOptions& by)
      : unknowns(of), matrix(with), options(by) {}
  virtual ~HeatStages() = default;
  virtual Response response(double time, const Eigen::VectorXd& temperature) const = 0;
  /// The stage `duration` s after `start`, with the rate of the substep before for the initial guess.
  virtual StageValue solve_middle(const StageEquation& equation, const StageValue& start, const Rate& rate,
                                  double duration) = 0;
  /// The stage at the end of a substep of `dt` s.
  virtual StageValue solve_end(const StageEquation& equation, const StageValue& start, const StageValue& middle,
                               double dt) = 0;
  /// Substep after one of `substep` s, where `fitting` would just meet the tolerance and `remaining` is to go.
  virtual double next_size(double substep, double fitting, double remaining, bool rejected_before) const = 0;
  /// The algebraic error of the last stage leaves a body with a little more or less heat than was integrated. One
  /// change of all its temperatures that are not prescribed, within the error that the stage may have, makes that good,
  /// so that the balance closes whatever that tolerance is.
  virtual void restore_content(HeatBalance& balance, StageValue& end) const = 0;
};

/// Where the stage in the middle of a substep is, as a share of it: gamma = 2 - sqrt(2).
double middle_of_substep();

/// Advances nodal temperatures, by body, K, from `time` over `dt`, s, in substeps that meet the tolerance.
StepOutcome advance_in_substeps(HeatStages& stages, double time, const std::vector<Eigen::VectorXd>& temperature,
                                double dt);

}  // namespace parison::thermal
