// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/solid_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/process/run_error.hpp"
#include "core/solid/hex_geometry.hpp"
#include "forming/solid/flow/step_parts.hpp"
#include "forming/solid/solid_memory.hpp"
#include "forming/solid/solid_openings.hpp"

namespace parison::forming {

namespace {

using core::Vector3;

const StageTool* active_entry(const Scene& scene, const State& clock, Index tool) {
  for (const StageTool& entry : scene.stages[clock.stage].tools)
    if (entry.tool == tool) return &entry;
  return nullptr;
}

/// The flow of the present stage over dt, s. Its tools are those of the solid in place; `places` says which.
flow::SolidProblem flow_problem(const Scene& scene, const State& clock, const SolidState& solid, double dt,
                                std::vector<std::size_t>& places) {
  const Stage& stage = scene.stages[clock.stage];
  flow::SolidProblem problem;
  problem.material = &*scene.glass.flow;
  problem.gravity = stage.gravity;
  problem.planes = solid.planes;
  if (const auto pressure = stage.pressure.find(inner_side); pressure != stage.pressure.end())
    problem.pressures.push_back({faces_of(solid, SolidSide::inner), pressure->second(clock.stage_time + 0.5 * dt)});
  problem.open_faces = solid.faces;
  problem.contact_faces = solid.faces;
  for (std::size_t t = 0; t < solid.tools.size(); ++t) {
    const Index tool = solid.tools[t].tool;
    if (!active_entry(scene, clock, tool)) continue;
    const double now = tool_offset(scene, clock, tool, clock.stage_time);
    const double after = tool_offset(scene, clock, tool, clock.stage_time + dt);
    problem.tools.push_back({solid.tools[t].surface.get(), now * Vector3::UnitZ(),
                             dt > 0 ? Vector3((after - now) / dt * Vector3::UnitZ()) : Vector3::Zero(),
                             scene.tools[tool].friction});
    places.push_back(t);
  }
  return problem;
}

/// Contact counts the tools of a flow problem; here those of the solid.
void count_tools_of_solid(const std::vector<std::size_t>& places, SolidState& solid) {
  for (flow::SolidContact& contact : solid.glass.contact)
    if (contact.tool >= 0) contact.tool = static_cast<Index>(places[contact.tool]);
}
void count_tools_of_flow(const std::vector<std::size_t>& places, SolidState& solid) {
  for (flow::SolidContact& contact : solid.glass.contact) {
    const auto found = std::find(places.begin(), places.end(), static_cast<std::size_t>(contact.tool));
    contact.tool = found == places.end() ? -1 : static_cast<Index>(found - places.begin());
    if (contact.tool < 0) contact.touches = false;
  }
}

/// The temperatures expected in the middle of a step, at which the glass flows.
Eigen::VectorXd middle_temperature(const SolidState& solid, double dt) {
  if (solid.temperature_rate.size() == 0) return solid.glass.temperature;
  constexpr double farthest = 20;  // K: beyond it a rate of one step says little about the next
  const Eigen::ArrayXd change = 0.5 * dt * solid.temperature_rate.array();
  return solid.glass.temperature + change.max(-farthest).min(farthest).matrix();
}

/// Why a step was not accepted.
std::string rejection(const flow::SolidStep& step, const SolidState& solid) {
  constexpr double settled = 1e-8;  // share of a volume, ten times what a step that is accepted may be off
  if (step.volume_error > settled)
    return fmt::format("the volumes of cells do not settle in a step: one is off by {:.1g} of it", step.volume_error);
  Index worst = 0;
  double least = core::least_jacobian(solid.glass.mesh, 0);
  for (Index cell = 1; cell < solid.glass.mesh.cell_count(); ++cell)
    if (const double own = core::least_jacobian(solid.glass.mesh, cell); own < least) least = own, worst = cell;
  const Vector3 at = 1e3 * core::cell_nodes(solid.glass.mesh, worst).rowwise().mean();
  return fmt::format("a step would fold a cell of the glass, the worst of which is at ({:.1f}, {:.1f}, {:.1f}) mm",
                     at[0], at[1], at[2]);
}

/// Moves the glass with the temperatures expected in the middle of the step, then conducts heat.
void step_forming(const Scene& scene, const State& clock, double dt, const flow::SolidProblem& problem,
                  const std::vector<std::size_t>& places, SolidState& solid, SolidWorkspace& workspace,
                  SolidStepOutcome& outcome) {
  const flow::SolidGlass before = solid.glass;
  count_tools_of_flow(places, solid);
  const Eigen::VectorXd temperature = std::exchange(solid.glass.temperature, middle_temperature(solid, dt));
  try {
    outcome.flow = flow::step_flow(problem, *workspace.flow, solid.glass, dt);
  } catch (const core::RunError& error) {
    outcome.reason = error.what();
  }
  solid.glass.temperature = temperature;
  if (outcome.flow.accepted) {
    count_tools_of_solid(places, solid);
    outcome.reason = advance_solid_heat(scene, clock, dt, solid, workspace.heat);
    if (outcome.reason.empty()) {
      advance_openings(scene, clock, dt, before, solid);
      return;
    }
  }
  solid.glass = before;
  if (outcome.reason.empty()) outcome.reason = rejection(outcome.flow, solid);
}

/// The largest change of temperature in a step, K, with its weight.
double weighted_change(const cooling::GlassLaw& law, const SolidMemoryStep& step, const SolidState& before,
                       const SolidState& solid) {
  const Eigen::VectorXd change = (solid.glass.temperature - before.glass.temperature).cwiseAbs();
  double largest = 0;
  for (std::size_t cell = 0; cell < solid.glass.mesh.cells.size(); ++cell) {
    double of_cell = 0;
    for (const Index node : solid.glass.mesh.cells[cell]) of_cell = std::max(of_cell, change[node]);
    const auto* points = &step.relaxation[flow::memory_points * cell];
    largest = std::max(largest, of_cell * cooling::weight_of_change(law, points, flow::memory_points));
  }
  return largest;
}

/// How far cooling glass that nothing holds sinks in a step, m: without such a drag no balance would be found. As it
/// moves by micrometres, the drag is less than a hundredth of its weight.
constexpr double free_fall = 1e-3;
constexpr double standard_gravity = 9.81;  ///< m/s2

/// Of what the glass rests on, Pa/m. Belts and plates give way, and what bears a container decides no stress: under the
/// weight of a column of its height it sinks in by micrometres.
double bedding(const flow::SolidProblem& problem, const flow::SolidGlass& glass) {
  constexpr double depth = 1e-6;  // m
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vector3& at : glass.mesh.nodes) low = std::min(low, at[2]), high = std::max(high, at[2]);
  return problem.material->density * std::abs(problem.gravity) * (high - low) / depth;
}

/// The same of glass that remembers its stress: heat, then the balance of forces at the temperatures that it gave.
void step_cooling(const Scene& scene, const State& clock, double dt, flow::SolidProblem& problem,
                  const std::vector<std::size_t>& places, SolidState& solid, SolidWorkspace& workspace,
                  SolidStepOutcome& outcome) {
  const cooling::GlassLaw& law = *scene.glass.annealing;
  const SolidState before = solid;
  outcome.reason = advance_solid_heat(scene, clock, dt, solid, workspace.heat);
  if (outcome.reason.empty()) {
    if (problem.tools.empty()) problem.gravity = 0;  // glass that nothing carries floats, as in the section
    SolidMemoryStep memory = start_memory_step(law, solid, before.glass.temperature, dt);
    memory.flow.bedding = bedding(problem, solid.glass);
    memory.flow.drag = problem.material->density * standard_gravity * dt / free_fall;
    problem.memory = &memory.flow;
    count_tools_of_flow(places, solid);
    try {
      outcome.flow = flow::step_cooling(problem, *workspace.flow, solid.glass, dt);
    } catch (const core::RunError& error) {
      outcome.reason = error.what();
    }
    if (outcome.flow.accepted) {
      end_memory_step(memory, flow::moved(before.glass.mesh, solid.glass.velocity, 0.5 * dt), dt, solid);
      count_tools_of_solid(places, solid);
      advance_openings(scene, clock, dt, before.glass, solid);
      outcome.temperature_change = weighted_change(law, memory, before, solid);
      return;
    }
    if (outcome.reason.empty()) outcome.reason = "a step would fold a cell of the glass";
  }
  solid = before;
}

}  // namespace

double tool_offset(const Scene& scene, const State& clock, Index tool, double stage_time) {
  const StageTool* entry = active_entry(scene, clock, tool);
  const auto* motion = entry ? std::get_if<PositionMotion>(&entry->motion) : nullptr;
  return motion ? motion->offset(stage_time) : clock.tools[tool].offset;
}

SolidStepOutcome step_solid(const Scene& scene, const State& clock, double dt, SolidState& solid,
                            SolidWorkspace& workspace) {
  SolidStepOutcome outcome;
  std::vector<std::size_t> places;
  flow::SolidProblem problem = flow_problem(scene, clock, solid, dt, places);
  if (!workspace.flow)
    workspace.flow = std::make_unique<flow::FlowMatrix>(solid.first_mesh, problem.planes, problem.fixed);
  if (remembers(solid))
    step_cooling(scene, clock, dt, problem, places, solid, workspace, outcome);
  else
    step_forming(scene, clock, dt, problem, places, solid, workspace, outcome);
  if (!outcome.flow.accepted || !outcome.reason.empty()) return outcome;
  for (std::size_t i = 0; i < places.size(); ++i) solid.tools[places[i]].force = outcome.flow.tool_forces[i];
  outcome.accepted = true;
  ++solid.totals.steps;
  solid.totals.factors += outcome.flow.factors;
  solid.totals.solutions += outcome.flow.solutions;
  solid.totals.volume_error = std::max(solid.totals.volume_error, outcome.flow.volume_error);
  return outcome;
}

double propose_solid_step(const Scene& scene, const State& clock, const SolidState& solid, double allowed) {
  if (solid.glass.velocity.size() == 0) return scene.accuracy.initial_step;
  std::vector<std::size_t> places;
  const flow::SolidProblem problem = flow_problem(scene, clock, solid, allowed, places);
  flow::SolidStepLimits limits;
  limits.growth *= std::max(1.0, allowed / solid.glass.last_step);
  limits.strain = 0.5 * scene.accuracy.strain_per_step;
  limits.longest = scene.accuracy.max_step;
  return flow::propose_step(problem, solid.glass, limits);
}

SolidOverlap deepest_overlap(const Scene& scene, const State& clock, const SolidState& solid, Index stage,
                             SolidTools tools) {
  SolidOverlap deepest;
  for (const SolidTool& tool : solid.tools) {
    const bool was_there = stage > 0 && scene.stages[stage - 1].uses(tool.tool);
    if (!scene.stages[stage].uses(tool.tool) || (tools == SolidTools::coming && was_there)) continue;
    const Vector3 offset = clock.tools[tool.tool].offset * Vector3::UnitZ();
    for (const core::HexFace& face : solid.faces)
      for (const Index node : core::face_node_numbers(solid.glass.mesh, face)) {
        const Vector3& at = solid.glass.mesh.nodes[node];
        const contact::SurfaceGap gap = tool.surface->gap(at - offset);
        constexpr double along = 0.7;  // of the normal
        if (-gap.distance > deepest.depth) deepest = {-gap.distance, tool.tool, at, std::abs(gap.normal[2]) > along};
      }
  }
  return deepest;
}

}  // namespace parison::forming
