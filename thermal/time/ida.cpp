// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/time/ida.hpp"

#include <fmt/format.h>
#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/math/numbers.hpp"
#include "thermal/time/step_matrix.hpp"

namespace parison::thermal {

namespace {

Eigen::Map<Eigen::VectorXd> view(N_Vector vector) {
  return {N_VGetArrayPointer(vector), static_cast<Eigen::Index>(N_VGetLength(vector))};
}

/// Largest of the weighted values, in place of IDA's root mean square: a thin skin is few of many nodes, and its error
/// is that of the heat.
double largest(N_Vector values, N_Vector weights) {
  return view(values).cwiseProduct(view(weights)).lpNorm<Eigen::Infinity>();
}

/// IDA's memory and the data of its callbacks. IDA's own time counts from the start of the integration.
struct Integration {
  Problem problem;
  HeatSystem system;
  StepMatrix matrix;
  double start;             ///< s
  double matrix_scale = 0;  ///< c_j of IDA at the last factorisation, 1/s: its matrix is c_j (C + K/c_j)
  SUNContext context = nullptr;
  N_Vector temperature = nullptr, rate = nullptr;
  SUNMatrix jacobian = nullptr;
  SUNLinearSolver solver = nullptr;
  void* ida = nullptr;
  HeatBalance balance;           ///< since the end of the last call
  Eigen::VectorXd content;       ///< at the end of the last call, J
  double accumulated_until = 0;  ///< end of the balance in IDA's time, s
  std::string message;           ///< last error message of IDA

  Integration(Problem given, double time, const std::vector<Eigen::VectorXd>& start, const IdaOptions& options);
  Integration(const Integration&) = delete;
  Integration& operator=(const Integration&) = delete;
  ~Integration();
};

/// Temperatures of all unknowns at a time of IDA. IDA leaves the prescribed ones at their initial values.
Eigen::VectorXd temperature_at(const Integration& run, double ida_time, N_Vector unknowns) {
  Eigen::VectorXd temperature = view(unknowns);
  impose_prescribed(run.system, run.start + ida_time, temperature);
  return temperature;
}

int residual(double ida_time, N_Vector temperature, N_Vector rate, N_Vector result, void* data) {
  const auto& run = *static_cast<const Integration*>(data);
  const double time = run.start + ida_time;
  Eigen::VectorXd full_rate = view(rate);
  impose_prescribed_rate(run.system, time, full_rate);
  const Response response = evaluate(run.system, time, temperature_at(run, ida_time, temperature), full_rate);
  view(result) = response.content - response.power;
  clear_prescribed(run.system, view(result));
  return view(result).allFinite() ? 0 : 1;
}

int set_matrix(double ida_time, double scale, N_Vector temperature, N_Vector, N_Vector, SUNMatrix, void* data, N_Vector,
               N_Vector, N_Vector) {
  auto& run = *static_cast<Integration*>(data);
  run.matrix_scale = scale;
  const double time = run.start + ida_time;
  return factorise(run.matrix, run.system, time, temperature_at(run, ida_time, temperature), 1 / scale) ? 0 : 1;
}

int solve(SUNLinearSolver solver, SUNMatrix, N_Vector solution, N_Vector rhs, double) {
  const auto& run = *static_cast<const Integration*>(solver->content);
  view(solution) = run.matrix.cholesky.solve(view(rhs)) / run.matrix_scale;
  return 0;
}

void store_message(int, const char*, const char*, char* message, void* data) {
  static_cast<Integration*>(data)->message = message;
}

/// Attaches a linear solver whose matrix lives in `run.matrix`: set_matrix assembles and factorises it, so IDA's own
/// matrix object and the solver's set-up are empty.
void attach_solver(Integration& run) {
  run.jacobian = SUNMatNewEmpty(run.context);
  run.jacobian->ops->getid = [](SUNMatrix) { return SUNMATRIX_CUSTOM; };
  run.jacobian->ops->zero = [](SUNMatrix) { return 0; };
  run.solver = SUNLinSolNewEmpty(run.context);
  run.solver->content = &run;
  run.solver->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; };
  run.solver->ops->getid = [](SUNLinearSolver) { return SUNLINEARSOLVER_CUSTOM; };
  run.solver->ops->initialize = [](SUNLinearSolver) { return 0; };
  run.solver->ops->setup = [](SUNLinearSolver, SUNMatrix) { return 0; };
  run.solver->ops->solve = solve;
  IDASetLinearSolver(run.ida, run.solver, run.jacobian);
  IDASetJacFn(run.ida, set_matrix);
}

/// Imposes the prescribed temperatures, accumulates the heat that this takes, and computes consistent initial rates
/// from capacity(T) dT/dt = power(t, T).
void make_consistent(Integration& run, Eigen::VectorXd temperature) {
  const Eigen::VectorXd before = evaluate(run.system, run.start, temperature).content;
  impose_prescribed(run.system, run.start, temperature);
  const Response response = evaluate(run.system, run.start, temperature);
  accumulate_content(run.balance, run.system, before, response.content);
  accumulate_imposed(run.balance, run.system);
  run.content = response.content;
  Eigen::VectorXd power = response.power;
  if (!run.system.prescribed.empty()) {
    Eigen::VectorXd prescribed_rate = Eigen::VectorXd::Zero(run.system.size());
    impose_prescribed_rate(run.system, run.start, prescribed_rate);
    power -= evaluate(run.system, run.start, temperature, prescribed_rate).content;
  }
  clear_prescribed(run.system, power);
  view(run.temperature) = temperature;
  if (factorise(run.matrix, run.system, run.start, temperature, 0)) view(run.rate) = run.matrix.cholesky.solve(power);
}

Integration::Integration(Problem given, double time, const std::vector<Eigen::VectorXd>& initial,
                         const IdaOptions& options)
    : problem(std::move(given)), system(make_heat_system(problem)), start(time), balance(zero_balance(system)) {
  prepare(matrix, system);
  SUNContext_Create(nullptr, &context);
  temperature = N_VNew_Serial(system.size(), context);
  temperature->ops->nvwrmsnorm = largest;  // its clones, all vectors of IDA, have it too
  rate = N_VNew_Serial(system.size(), context);
  N_VConst(0, rate);
  make_consistent(*this, join(system, initial));
  ida = IDACreate(context);
  IDASetErrHandlerFn(ida, store_message, this);
  IDASetUserData(ida, this);
  IDAInit(ida, residual, 0, temperature, rate);
  IDASStolerances(ida, 0, options.tolerance);
  IDASetNonlinConvCoef(ida, 0.01);  // the algebraic error of Newton's method enters the heat balance
  attach_solver(*this);
}

Integration::~Integration() {
  IDAFree(&ida);
  SUNLinSolFreeEmpty(solver);
  SUNMatFreeEmpty(jacobian);
  N_VDestroy(temperature);
  N_VDestroy(rate);
  SUNContext_Free(&context);
}

/// Accumulates the flows from `accumulated_until` to `end`, both in IDA's time and inside its last step, by Gauss
/// quadrature on the dense output.
void accumulate_until(Integration& run, double end) {
  const double duration = end - run.accumulated_until;
  for (const auto& at : core::edge_rule(3)) {
    const double ida_time = run.accumulated_until + at.s * duration, part = at.weight * duration;
    IDAGetDky(run.ida, ida_time, 0, run.temperature);
    const Eigen::VectorXd temperature = temperature_at(run, ida_time, run.temperature);
    if (run.system.prescribed.empty()) {
      accumulate(run.balance, evaluate_flows(run.system, run.start + ida_time, temperature), part);
      continue;
    }
    const Response response = evaluate(run.system, run.start + ida_time, temperature);
    accumulate(run.balance, response.flows, part);
    for (const PrescribedUnknown& given : run.system.prescribed)
      accumulate_prescribed(run.balance, given, -part * response.power[given.unknown]);
  }
  run.accumulated_until = end;
}

/// The first time after `time`, s, at which a given curve bends; infinite for none.
double next_corner(const Problem& problem, double time) {
  double next = std::numeric_limits<double>::infinity();
  const auto include = [&](const core::TimeFunction& curve) {
    next = std::min(next, curve.next_corner(time + core::same_time));
  };
  for (const BodyView& body : problem.bodies) {
    include(body.source_factor);
    for (const auto& exchange : body.exchange)
      if (exchange) include(exchange->h), include(exchange->air_temperature), include(exchange->ambient_temperature);
    for (const auto& prescribed : body.prescribed)
      if (prescribed) include(*prescribed);
  }
  return next;
}

/// Accumulates the content change since the last call and returns the balance, leaving a zero one.
HeatBalance finish_balance(Integration& run, const Eigen::VectorXd& content) {
  accumulate_content(run.balance, run.system, run.content, content);
  for (const PrescribedUnknown& at : run.system.prescribed)
    accumulate_prescribed(run.balance, at, content[at.unknown] - run.content[at.unknown]);
  run.content = content;
  return std::exchange(run.balance, zero_balance(run.system));
}

}  // namespace

struct IdaIntegrator::Data : Integration {
  using Integration::Integration;
};

IdaIntegrator::IdaIntegrator(Problem problem, double time, const std::vector<Eigen::VectorXd>& temperature,
                             const IdaOptions& options)
    : data_(std::make_unique<Data>(std::move(problem), time, temperature, options)) {}
IdaIntegrator::~IdaIntegrator() = default;
IdaIntegrator::IdaIntegrator(IdaIntegrator&&) noexcept = default;
IdaIntegrator& IdaIntegrator::operator=(IdaIntegrator&&) noexcept = default;

IdaOutcome IdaIntegrator::advance_to(double time) {
  Data& run = *data_;
  const double end = time - run.start;
  assert(end > run.accumulated_until);
  IdaOutcome outcome;
  outcome.reason = why_not_solvable(run.system);
  if (!outcome.reason.empty()) return outcome;
  long steps_before = 0, steps_after = 0;
  IDAGetNumSteps(run.ida, &steps_before);
  const Index factorisations_before = run.matrix.factorisations;
  double reached = 0;
  IDAGetCurrentTime(run.ida, &reached);
  if (reached > run.accumulated_until) accumulate_until(run, std::min(reached, end));
  while (reached < end) {
    // A step over a bend could pass a short pulse without seeing it.
    if (const double corner = next_corner(run.problem, run.start + reached) - run.start; std::isfinite(corner))
      IDASetStopTime(run.ida, corner);
    const int flag = IDASolve(run.ida, end, &reached, run.temperature, run.rate, IDA_ONE_STEP);
    if (flag < 0) {
      outcome.reason = fmt::format("IDA stopped the heat integration at {:.6g} s: {}",
                                   run.start + run.accumulated_until, run.message);
      return outcome;
    }
    accumulate_until(run, std::min(reached, end));
  }
  IDAGetDky(run.ida, end, 0, run.temperature);
  const Eigen::VectorXd temperature = temperature_at(run, end, run.temperature);
  IDAGetNumSteps(run.ida, &steps_after);
  outcome.converged = true;
  outcome.temperature = split(run.system, temperature);
  outcome.balance = finish_balance(run, evaluate(run.system, time, temperature).content);
  outcome.steps = steps_after - steps_before;
  outcome.factorisations = run.matrix.factorisations - factorisations_before;
  return outcome;
}

}  // namespace parison::thermal
