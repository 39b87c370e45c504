#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <map>
#include <string>
#include <vector>

#include "core/mesh/interface_point.hpp"
#include "forming/flow/solution.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// What kept a step from being longer, and the names of these limits.
enum class StepLimit { initial, growth, max_step, strain, landing, work, temperature, motion, event, failure };
inline constexpr std::array step_limits{"initial", "growth",      "max_step", "strain", "landing",
                                        "work",    "temperature", "motion",   "event",  "failure"};

/// What one step did, beyond the new state.
struct StepReport {
  double dt = 0;
  Index coupling_iterations = 0, flow_solves = 0, flow_factorisations = 0, contact_changes = 0,
        heat_substeps = 0;    ///< in all coupling iterations
  Index contacts = 0;         ///< active, in the last coupling iteration
  Index locked_contacts = 0;  ///< that pull but stay closed, in the last coupling iteration
  bool unconverged = false;   ///< the last coupling iteration that is allowed has not met its conditions
  StepLimit limit = StepLimit::initial;
  double temperature_change = 0;              ///< largest of the glass surface, K
  double predictor_corrector_difference = 0;  ///< by which the last coupling iteration still moved the mid-step mesh, m
  double strain = 0;                          ///< largest rate of deformation times dt
  double landed_length = 0;                   ///< largest length of surface that came into contact in one piece, m
  double off_axis = 0;                        ///< largest correction of nodes beyond a line of symmetry, m
  double flux_mismatch = 0;                   ///< between heat out of the glass and into a tool, relative
  long clamped_lookups = 0;                   ///< evaluations of h outside its table
  double work_error = 0;                      ///< by which the work of the step is off, over the work lost in the run
  bool flickers = false;                      ///< a node opens that has closed in the step before, or closes again
  double unforeseen_work = 0;                 ///< by which it would differ at the viscosity that its heat gave, J
  double unforeseen_error = 0;                ///< that over the work lost in the run
  std::vector<core::InterfacePoint> interface;  ///< in the middle of the step, where heat sees it
  std::map<std::string, double> seconds;        ///< by part: flow, heat, contact, remesh, output
};

/// What a step gives: the new state, or the reason why there is none.
struct StepResult {
  State state;
  bool converged = false;
  std::string reason;
  bool unrecoverable = false;  ///< a shorter step fails as well
  double edge_depth = 0;       ///< m, where the step is refused because it moves an edge so deep into a tool
  StepReport report;
  flow::Solution flow;               ///< of the last coupling iteration; empty where nothing flows
  Eigen::VectorXd flow_temperature;  ///< of the glass nodes that it was solved with, K
  std::vector<double> dissipation;   ///< viscous heat, W at each quadrature point: flow::Solution::dissipation
  State at_heat;  ///< with the bodies in the middle of the step and the temperatures of its end; empty without heat
};

}  // namespace parison::forming
