// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "forming/flow/contact/active_set.hpp"
#include "forming/flow/linear/schur_update.hpp"

namespace parison::flow {

using core::dim;

namespace {

constexpr int max_iterations = 200;
/// Componentwise backward error above which the solution is refined once.
constexpr double residual_tolerance = 1e-12;
/// Relative change of the velocities below which viscosity and friction, where they depend on the flow, are converged.
constexpr double velocity_tolerance = 1e-6;

/// Whether neither viscosity nor friction depends on the flow.
bool is_linear(const Problem& problem) {
  return !problem.material->shear_thinning &&
         std::none_of(problem.tools.begin(), problem.tools.end(),
                      [](const ToolMotion& tool) { return tool.friction.coulomb.has_value(); });
}

/// Why a problem cannot be solved whatever its contacts are; empty where it can.
std::string failed_precondition(const Problem& problem) {
  const std::string reason = free_motion(problem);
  if (!reason.empty()) return reason;
  return driven_tools(problem).size() > max_driven_tools ? "more than four tools are driven by force at a time" : "";
}

/// Gauge pressures of trapped air at the step's start, Pa.
Eigen::VectorXd initial_air_pressures(const Problem& problem) {
  if (!problem.air) return {};
  Eigen::VectorXd pressures(static_cast<Index>(problem.air->pockets.size()));
  for (Index j = 0; j < pressures.size(); ++j)
    pressures[j] = problem.air->pockets[j].energy / problem.air->pockets[j].volume - problem.air->ambient;
  return pressures;
}

/// The tools as boundary conditions of a dilatation added to a solved problem: tools in force balance yield without a
/// force, tools at their speed limit and tools of given velocity do not move. Trapped air keeps its pressure.
Problem tools_for_dilatation(Problem problem, const std::vector<double>& tool_velocity) {
  problem.air.reset();
  for (std::size_t t = 0; t < problem.tools.size(); ++t) {
    ToolMotion& tool = problem.tools[t];
    tool.velocity = 0;
    if (!tool.force) continue;
    tool.force = 0;
    tool.speed_limit = std::abs(tool_velocity[t]) < tool.speed_limit ? std::numeric_limits<double>::infinity() : 0;
  }
  return problem;
}

/// One solve of the flow equations with contact. Each call of `advance` is one iteration of the active set.
class ActiveSetIteration {
 public:
  ActiveSetIteration(const Problem& problem, const std::vector<bool>& initial_active, Corrector& corrector);

  /// Iterates once; false when the problem has no solution, for `failure`.
  bool advance();
  bool converged() const { return result_.converged; }
  Equilibrium finish();
  Equilibrium failure() { return std::move(result_); }

 private:
  bool fail(const char* reason);
  bool constrain_nodes();
  bool solve_linearised();
  bool add_air_columns(Eigen::MatrixXd& correction);
  const AirLoads* air() const { return air_ ? &*air_ : nullptr; }
  void balance_driven_tools();
  bool linearise_viscosity();
  bool update_contacts();
  bool is_accurate();
  std::optional<Response> dilatation_response();

  const Problem& problem_;
  const core::Mesh& mesh_;
  const Index velocities_;  ///< number of velocity unknowns
  const bool linear_;
  Corrector& corrector_;
  Equilibrium result_;

  Iterate iterate_;               ///< of the Newton iteration, with its force
  Eigen::VectorXd load_;          ///< right-hand side with the loads on the free surface
  Eigen::VectorXd contact_area_;  ///< per node, m2
  std::optional<AirLoads> air_;   ///< of trapped air, where there is some
  ToolSuperposition columns_;     ///< the last linear solution
  double velocity_change_ = 0;    ///< relative, by the last linear solution
  bool has_response_ = false;     ///< `result_.response` is that of an iteration
  bool refined_ = false;          ///< the next iteration is a refinement of the last one

  NewtonGuard newton_;
  CoulombSliding sliding_;
  std::vector<int> releases_;  ///< how often each candidate was opened
};

ActiveSetIteration::ActiveSetIteration(const Problem& problem, const std::vector<bool>& initial_active,
                                       Corrector& corrector)
    : problem_(problem),
      mesh_(*problem.mesh),
      velocities_(dim * mesh_.node_count()),
      linear_(is_linear(problem)),
      corrector_(corrector),
      sliding_(problem.candidates.size()),
      releases_(problem.candidates.size(), 0) {
  const Index size = velocities_ + mesh_.vertex_count();
  result_.active = initial_active_set(problem, initial_active);
  result_.discretisation = discretise(problem);
  iterate_ = {Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size),
              Eigen::VectorXd::Zero(Index(driven_tools(problem).size())), initial_air_pressures(problem)};
  corrector_.start(problem.with_dilatation_mode ? result_.discretisation.dilatation_load : Eigen::VectorXd());
}

bool ActiveSetIteration::fail(const char* reason) {
  result_.reason = reason;
  return false;
}

bool ActiveSetIteration::advance() {
  if (result_.iterations++ == max_iterations) return fail("the contact set did not converge");
  if (!constrain_nodes())
    return fail(
        "the glass is not constrained: no tool, symmetry plane or fixed boundary supports it (free fall is not "
        "computed; a tool must hold the glass against gravity and pressure)");
  if (!solve_linearised()) return fail("the flow matrix is singular: the glass is not constrained");
  balance_driven_tools();
  const bool steady = linearise_viscosity();
  const bool same_contacts = update_contacts();
  if (steady && same_contacts) {
    result_.converged = refined_ || is_accurate();
    refined_ = true;
  } else {
    iterate_.force = product(mesh_, result_.discretisation.cells, iterate_.x);
    refined_ = false;
  }
  return true;
}

/// Assembles the load of the surface that is not in contact, and the constraints and friction of the active contacts.
/// A contact is closed where nothing would carry the glass; false where there is none to close.
bool ActiveSetIteration::constrain_nodes() {
  const Discretisation& discretisation = result_.discretisation;
  const auto in_contact = nodes_in_contact(problem_, result_.active);
  load_ = discretisation.load;
  if (discretisation.expansion_load.size() > 0) load_ += discretisation.expansion_load;
  load_.head(velocities_) += surface_load(mesh_, discretisation.surface, in_contact);
  if (problem_.air) {
    air_ = air_loads(problem_, in_contact);
    load_.head(velocities_) += air_->suction + air_->unit * iterate_.air_pressure;
  }
  result_.constraints = make_constraints(problem_, result_.active);
  if (!support(problem_, load_, result_.active, result_.constraints)) return false;
  contact_area_ = contact_areas(mesh_, discretisation.surface, in_contact);
  add_friction(problem_, result_.active, contact_area_, has_response_ ? &result_.response : nullptr, sliding_,
               result_.constraints);
  return true;
}

/// Solves for the correction of the iterate, with the driven tools at their velocities and for each m/s of them. False
/// where the matrix is singular.
bool ActiveSetIteration::solve_linearised() {
  const CellMatrices& jacobian = result_.discretisation.jacobian();
  auto correction = corrector_.correct(problem_, jacobian, result_.constraints, load_, iterate_);
  result_.factorisations = corrector_.factorisations;
  if (!correction || !add_air_columns(*correction) || !correction->allFinite()) return false;
  columns_ = superpose(problem_, jacobian, result_.constraints, load_, std::move(*correction), iterate_, air());
  return true;
}

/// Appends the response to each Pa of each pocket of trapped air; false where the matrix is singular.
bool ActiveSetIteration::add_air_columns(Eigen::MatrixXd& correction) {
  for (Index j = 0; air_ && j < air_->unit.cols(); ++j) {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(load_.size());
    force.head(velocities_) = air_->unit.col(j);
    const auto response = corrector_.response_to(problem_, result_.constraints, force);
    if (!response) return false;
    correction.conservativeResize(Eigen::NoChange, correction.cols() + 1);
    correction.rightCols(1) = *response;
  }
  return true;
}

/// The next iterate: that superposition of the columns with which driven tools and trapped air are in balance.
void ActiveSetIteration::balance_driven_tools() {
  const Eigen::VectorXd before = iterate_.x.head(velocities_);
  result_.response = balance_tools(problem_, result_.constraints.nodes, columns_, air(), iterate_.air_pressure);
  has_response_ = true;
  if (air_) {
    load_.head(velocities_) += air_->unit * (result_.response.air_pressure - iterate_.air_pressure);
    iterate_.air_pressure = result_.response.air_pressure;
  }
  iterate_.x = result_.response.unknowns;
  const auto tools = driven_tools(problem_);
  for (std::size_t k = 0; k < tools.size(); ++k) iterate_.driven[Index(k)] = result_.response.tool_velocity[tools[k]];
  velocity_change_ = (iterate_.x.head(velocities_) - before).norm() / iterate_.x.head(velocities_).norm();
}

/// Updates a viscosity that depends on the flow, with Newton's or Picard's matrices for the next iteration. True where
/// the velocities have settled, so that neither viscosity nor friction would change; always where both are linear.
bool ActiveSetIteration::linearise_viscosity() {
  const bool steady = linear_ || !(velocity_change_ > velocity_tolerance);
  if (!problem_.material->shear_thinning) return steady;
  Discretisation& discretisation = result_.discretisation;
  update_viscosity(problem_, iterate_.x.head(velocities_), discretisation);
  if (steady) return true;
  discretisation.shear_thinning_jacobian = discretisation.cells;
  if (newton_.accepts(velocity_change_))
    add_thinning_derivative(problem_, discretisation.geometry, discretisation.viscosity, iterate_.x.head(velocities_),
                            discretisation.shear_thinning_jacobian);
  corrector_.forget();
  return false;
}

/// True where the active set has not changed.
bool ActiveSetIteration::update_contacts() {
  Response response = result_.response;
  if (air_)  // a contact opens where its force falls below that of the air behind it
    response.forces.normal -= opening_forces(problem_, *air_, iterate_.air_pressure,
                                             nodes_in_contact(problem_, result_.active), result_.active);
  const auto change = update_active_set(problem_, response, contact_area_, result_.active, releases_);
  result_.contact_changes += change.changed;
  result_.locked = change.locked;
  return change.changed == 0;
}

/// Whether the backward error of the iterate is that of round-off. Evaluates its force.
bool ActiveSetIteration::is_accurate() {
  return !(backward_error(problem_, result_.discretisation.cells, result_.constraints, load_, iterate_) >
           residual_tolerance);
}

/// Response of the glass to div v = 1/s with the active contacts closed and at rest.
std::optional<Response> ActiveSetIteration::dilatation_response() {
  const Problem at_rest = tools_for_dilatation(problem_, result_.response.tool_velocity);
  const auto velocity = corrector_.additional_solution(at_rest, result_.constraints);
  if (!velocity || !velocity->allFinite()) return std::nullopt;
  const Index without_air = 1 + Index(iterate_.driven.size());
  columns_.unknowns.conservativeResize(Eigen::NoChange, without_air);
  columns_.reaction.conservativeResize(Eigen::NoChange, without_air);
  columns_.unknowns.col(0) = *velocity;
  columns_.reaction.col(0) =
      product(mesh_, result_.discretisation.jacobian(), *velocity, constrained_batches(mesh_, result_.constraints))
          .topRows(velocities_);
  Response response = balance_tools(at_rest, result_.constraints.nodes, columns_, nullptr, {});
  if (!response.unknowns.allFinite()) return std::nullopt;
  return response;
}

/// The converged equilibrium. The prescribed dilatation is taken out of its pressures and forces, so that it leaves no
/// trace in the stress.
Equilibrium ActiveSetIteration::finish() {
  result_.air = air_;
  const auto mode = problem_.with_dilatation_mode ? dilatation_response() : std::nullopt;
  if (mode) {
    result_.dilatation_mode = mode->unknowns.head(velocities_);
    result_.tool_dilatation_mode = mode->tool_velocity;
    result_.dilatation_rate = problem_.dilatation_rate;
    result_.response.unknowns.tail(mesh_.vertex_count()) -=
        problem_.dilatation_rate * mode->unknowns.tail(mesh_.vertex_count());
    result_.response.forces.add(-problem_.dilatation_rate, mode->forces);
  }
  return std::move(result_);
}

}  // namespace

Solver::Solver(const core::Mesh& mesh) : corrector_(std::make_unique<Corrector>(mesh)) {}
Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

Equilibrium Solver::find_equilibrium(const Problem& problem, const std::vector<bool>& initial_active) {
  Equilibrium impossible;
  impossible.reason = failed_precondition(problem);
  if (!impossible.reason.empty()) return impossible;
  ActiveSetIteration iteration(problem, initial_active, *corrector_);
  while (!iteration.converged())
    if (!iteration.advance()) return iteration.failure();
  return iteration.finish();
}

Solution Solver::solve(const Problem& problem, const std::vector<bool>& initial_active) {
  return evaluate(problem, find_equilibrium(problem, initial_active));
}

}  // namespace parison::flow
