// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/flow/flow_step.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/mesh/tolerances.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/state/sample.hpp"
#include "forming/step/balance/volume_conservation.hpp"
#include "forming/step/balance/work.hpp"
#include "forming/step/cavities/trapped_air.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/contact/penetration.hpp"
#include "forming/step/flow/flow_solve.hpp"
#include "forming/step/flow/predictor.hpp"
#include "forming/step/step_control.hpp"
#include "remesh/sizing/recovery.hpp"

namespace parison::forming {

using core::dim;

void move_glass_probes(const Scene& scene, const core::Mesh& mesh, const Eigen::VectorXd& velocity, double dt,
                       State& state) {
  std::vector<std::size_t> inside;
  std::vector<Point> points;
  for (std::size_t p = 0; p < scene.probes.size(); ++p)
    if (scene.probes[p].body == 0) {
      inside.push_back(p);
      points.push_back(state.probes[p]);
    }
  const Eigen::MatrixXd moving = sample(mesh, velocity, dim, points);
  for (std::size_t i = 0; i < inside.size(); ++i)
    state.probes[inside[i]] += dt * moving.row(static_cast<Index>(i)).transpose();
}

namespace {

/// Largest number of flow solves in one step.
constexpr int max_coupling_iterations = 4;

/// Shares of the volume that a step may miss, before another coupling iteration is made and before it is rejected after
/// the last one. Where contacts hold the whole surface the volume cannot be corrected: a prediction from the last
/// iteration has to make it good, or a shorter step.
constexpr double iterated_missed_volume = 2e-7, rejected_missed_volume = 5e-7;

/// Share of the work dissipated in a step that its correction of the volume may do without another coupling iteration:
/// what a midpoint off the glass's own takes from the volume costs work where the glass is under pressure.
/// At accuracies coarser than draft it is more, as the error of the run is.
constexpr double iterated_correction = 5e-3;

/// Factor on the motion tolerance in the first step of a stage, which is predicted from rest.
constexpr double initial_fraction = 0.1;

/// Edges of a contact front that closed smaller gaps, in units of numerics.surface_size, did not land: contact was
/// resumed.
constexpr double min_landing_gap = 1e-3;

/// Penetration into a tool, m, above which another coupling iteration is made, and increase of the penetration above
/// which the step is rejected after the last one.
struct DepthLimits {
  double iterate, reject;

  explicit DepthLimits(const Scene& scene)
      : iterate(core::tolerance::penetration * core::size(scene.glass.profile)),
        reject(core::tolerance::rejected_penetration * core::size(scene.glass.profile)) {}
};

/// Largest length of surface, m, that a contact front passes in a step: the length of neighbouring edges whose middles
/// come into contact in it, times the relative difference of the gaps that they closed. A flat surface that lands on a
/// flat tool all at once has no front; next to glass in contact the gap is 0.
double landed_length(const StepStart& start, const FlowPass& pass, const State& updated) {
  const core::Mesh& mesh = start.state.glass.mesh;
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(mesh.node_count());  // closed in the step, m
  for (std::size_t i = 0; i < pass.candidates.size(); ++i)
    if (pass.solution.active[i]) {  // a node in a corner touches two tools, and may have touched one of them before
      double& closed = gap[pass.candidates[i].node];
      closed = std::max(closed, -start.dt * pass.candidates[i].rate);
    }
  const double counts = min_landing_gap * start.scene.accuracy.surface_size;
  const auto lands = [&](const core::BoundaryEdge& edge) {
    return start.state.glass.contact_tool[edge.nodes[2]] < 0 && updated.glass.contact_tool[edge.nodes[2]] >= 0;
  };
  std::vector<core::BoundaryEdge> edges = mesh.boundary_edges();  // from one on that no front goes through
  std::rotate(edges.begin(), std::find_if_not(edges.begin(), edges.end(), lands), edges.end());
  double largest = 0, length = 0, widest = 0, narrowest = 0;
  for (const auto& edge : edges) {
    const Index middle = edge.nodes[2];
    if (!lands(edge)) {
      length = 0;
      continue;
    }
    if (length == 0) widest = narrowest = gap[middle];
    for (const Index node : edge.nodes) {
      widest = std::max(widest, gap[node]);
      narrowest = std::min(narrowest, gap[node]);
    }
    length += (mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]]).norm();
    if (widest > counts) largest = std::max(largest, length * (1 - narrowest / widest));
  }
  return largest;
}

/// Increase of the largest penetration by the velocities, m; 0 where the penetration is allowed. The next coupling
/// iteration has other candidates; those of nodes that penetrate too deep are added to them, so that such a node does
/// not alternate between two tools in a re-entrant corner.
double penetration_gained(const StepStart& start, const FlowPass& pass, const State& updated,
                          MidpointPredictor& predictor) {
  std::vector<bool> deep(start.state.glass.mesh.nodes.size(), false);
  const double known = start.max_penetration, allowed = std::max(DepthLimits(start.scene).iterate, known);
  double found_depth = known;
  for (const auto& inside : penetrations(start.scene, updated, start.dt)) {
    found_depth = std::max(found_depth, inside.depth);
    if (inside.depth > allowed) deep[inside.node] = true;
  }
  for (const auto& bound : pass.candidates)
    if (deep[bound.node]) predictor.bounds.push_back(bound);
  return found_depth > allowed ? found_depth - known : 0;
}

/// A sentence that names the tool which a step drives into a boundary of the glass without contact; empty where there
/// is none.
std::string collision_without_contact(const StepStart& start, const State& updated) {
  const core::Mesh& glass = start.state.glass.mesh;
  const auto may_touch = touching_nodes(glass);
  Eigen::VectorXd known = Eigen::VectorXd::Zero(glass.node_count());
  for (const auto& inside : start.penetrations) known[inside.node] = std::max(known[inside.node], inside.depth);
  const double tolerance = DepthLimits(start.scene).reject;
  Eigen::VectorXi entered = Eigen::VectorXi::Constant(glass.node_count(), -1);  // the tool
  for (const auto& inside : penetrations(start.scene, updated, start.dt))
    if (!may_touch[inside.node] && inside.depth > known[inside.node] + tolerance) entered[inside.node] = inside.tool;
  for (const auto& edge : glass.boundary_edges())
    for (const Index node : edge.nodes)
      if (entered[node] >= 0 && glass.kind_of(edge) != BoundaryKind::symmetry)  // nodes of a line follow its end
        return fmt::format("tool {} runs into {} of the glass, which cannot touch: its condition is not contact",
                           start.scene.tools[entered[node]].name, glass.boundaries()[edge.boundary_id].name);
  return "";
}

/// Difference of the midpoint meshes that two velocities give, m: sqrt(3) times the root mean square over the nodes,
/// which is the largest value of a linear field, so that a few nodes at an edge of contact do not decide. A translation
/// along the axis changes no shape and does not count.
double predictor_corrector_difference(const Eigen::VectorXd& velocity, const Eigen::VectorXd& predicted, double dt) {
  const Eigen::VectorXd change = 0.5 * dt * (velocity - predicted);
  const double nodes = double(change.size()) / dim;
  Point mean = Point::Zero();
  for (Index n = 0; n < change.size() / dim; ++n) mean += flow::node_velocity(change, n) / nodes;
  const double shift = mean.dot(core::axis_direction());
  return std::sqrt(3 * std::max(0.0, change.squaredNorm() / nodes - shift * shift));
}

/// One coupling iteration: the flow on the predicted midpoint mesh gives the velocities of glass and tools, and these
/// the next prediction. `result.reason` tells why a solve failed.
std::optional<flow::Solution> flow_iteration(const StepStart& start, MidpointPredictor& predictor, Workspace& workspace,
                                             StepResult& result, double& gained) {
  auto pass = solve_flow(start, result.state.glass.active_contacts, predictor, workspace);
  ++result.report.coupling_iterations;
  result.report.flow_solves += pass.solution.iterations;
  result.report.flow_factorisations += pass.solution.factorisations;
  result.report.contact_changes += pass.solution.contact_changes;
  result.report.locked_contacts = pass.solution.locked;
  if (!pass.solution.converged) {
    result.reason = pass.solution.reason;
    return std::nullopt;
  }
  const std::vector<Index> touched = result.state.glass.contact_tool;
  store_flow(start.scene, pass, start.dt, result.state);
  // Glass that lands or leaves makes it another problem, and the pressure of trapped air is of another step.
  if (start.air || result.state.glass.contact_tool != touched) predictor.iteration.forget();
  result.report.contacts = static_cast<Index>(result.state.glass.active_contacts.node.size());
  if (start.air) store_air(start, pass.solution, result.state);
  result.report.strain = pass.solution.high_rate * start.dt;
  result.report.predictor_corrector_difference =
      predictor_corrector_difference(result.state.glass.velocity, predictor.velocity, start.dt);
  result.report.landed_length = landed_length(start, pass, result.state);
  gained = penetration_gained(start, pass, result.state, predictor);
  predictor.velocity = predictor.iteration.next(predictor.velocity, result.state.glass.velocity);
  predictor.trusted = true;
  return std::move(pass.solution);
}

/// Viscous heat at the quadrature points, W: the dissipation without that of impacts and corrections, to which no
/// physical work corresponds. It matters in nearly solid glass.
std::vector<double> heating(const flow::Solution& solution) {
  std::vector<double> heat = solution.dissipation;
  const double whole = std::accumulate(heat.begin(), heat.end(), 0.0);
  const double unphysical = std::max(0.0, -solution.impact_power) + std::max(0.0, solution.correction_power);
  if (unphysical > 0)
    for (double& power : heat) power *= std::max(0.0, 1 - unphysical / whole);
  return heat;
}

/// Whether the correction of the volume does more work in a step than another coupling iteration costs: of what the
/// step dissipates, or of a usual step where that is more. `before` is the work until this step.
bool is_much_corrected(const Scene& scene, const flow::Solution& solution, double dt, const Work& before) {
  const double dissipated = dt * std::accumulate(solution.dissipation.begin(), solution.dissipation.end(), 0.0);
  const double corrected = dt * std::abs(solution.correction_power - solution.recovery_power);
  static const double of_draft = accuracy_preset("draft").work_per_step;
  const double allowed = iterated_correction * std::sqrt(std::max(1.0, scene.accuracy.work_per_step / of_draft));
  return corrected > allowed * std::max(dissipated, before.dissipation / usual_steps);
}

}  // namespace

bool iterate_until_converged(const StepStart& start, MidpointPredictor& predictor, Workspace& workspace,
                             StepResult& result) {
  const Scene& scene = start.scene;
  const State& state = start.state;
  const double dt = start.dt;
  double gained = 0;
  double tolerance = (state.last_step > 0 ? 1 : initial_fraction) * scene.accuracy.motion_tolerance;
  std::optional<flow::Solution> solution;
  const auto missed = [&] {
    return missed_volume(scene, state, result.state.glass.velocity, dt, predictor.expansion.end_temperature);
  };
  const auto converged = [&] {
    // What has left the tolerance would leave it again in the next step.
    if (!start.air && result.report.predictor_corrector_difference > tolerance)
      tolerance = initial_fraction * scene.accuracy.motion_tolerance;
    return gained == 0 && result.report.predictor_corrector_difference <= tolerance &&
           !rejected_for_work(scene, result.report) && !is_much_corrected(scene, *solution, dt, state.totals.work) &&
           missed() <= iterated_missed_volume;
  };
  int iteration = 0;
  for (; iteration == 0 || (iteration < max_coupling_iterations && !converged()); ++iteration) {
    solution = flow_iteration(start, predictor, workspace, result, gained);
    if (!solution) return false;
    result.state.totals.work = state.totals.work;
    accumulate_work(scene, state, *solution, dt, result.state.totals.work);
    // The pressure of trapped air is that of the step's end: its work is of first order in the step and not resolved.
    if (solution->edge_pressure.empty())
      result.report.work_error =
          work_error(scene, state, state.totals.work, result.state.totals.work, dt * solution->recovery_power);
  }
  result.report.unconverged = iteration == max_coupling_iterations && !converged();
  if (gained > DepthLimits(scene).reject && dt > min_step_ratio * scene.accuracy.initial_step) {
    result.reason = collision_without_contact(start, result.state);
    result.unrecoverable = !result.reason.empty() && dt <= scene.accuracy.initial_step;
    if (result.reason.empty()) result.reason = fmt::format("the step moves glass {:.2g} um into a tool", 1e6 * gained);
    return false;
  }
  if (missed() > rejected_missed_volume && dt > min_step_ratio * scene.accuracy.initial_step) {
    result.reason = fmt::format("the step changes the volume of the glass by {:.2g}", missed());
    return false;
  }
  result.dissipation = heating(*solution);
  result.flow = std::move(*solution);
  result.flow_temperature = predictor.temperature;
  move_glass_probes(scene, state.glass.mesh, result.state.glass.velocity, dt, result.state);
  return true;
}

}  // namespace parison::forming
