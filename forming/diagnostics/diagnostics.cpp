// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/diagnostics/diagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "forming/step/balance/volume_conservation.hpp"

namespace parison::forming {

namespace {

void follow_heat(const Scene& scene, const State& before, const StepResult& step, Diagnostics& seen) {
  follow_hot_glass(scene, before, step, seen.hot_glass);
  for (std::size_t b = 0; b < seen.bounds.size(); ++b)
    follow_bounds(scene, step, Index(b), b == glass_body ? seen.hot_glass.viscous_heating : 0, seen.bounds[b]);
  follow_contact_skins(scene, before, step, seen.skins);
  follow_light(scene, before, step, seen.light);
  follow_extremes(scene, before, step.state, seen.extremes);
  seen.max_flux_mismatch = std::max(seen.max_flux_mismatch, step.report.flux_mismatch);
  seen.clamped_lookups += step.report.clamped_lookups;
}

void follow_flow(const Scene& scene, const State& before, const StepResult& step, Diagnostics& seen) {
  follow_flow_work(scene, before, step, seen.work);
  seen.max_drift = std::max(seen.max_drift, std::abs(volume_drift(scene, step.state)));
  seen.off_axis = std::max(seen.off_axis, step.report.off_axis);
}

void follow_forces(const Scene& scene, const State& after, std::vector<double>& peak_force) {
  for (const StageTool& tool : scene.stages[after.stage].tools) {
    const ToolState& body = after.tools[tool.tool];
    if (tool.is_driven() || body.velocity != 0)
      peak_force[tool.tool] = std::max(peak_force[tool.tool], std::abs(body.force));
  }
}

/// Whether glass or tools have moved.
bool has_moved(const Scene& scene, const State& before, const State& after) {
  for (std::size_t t = 0; t < after.tools.size(); ++t)
    if (after.tools[t].offset != before.tools[t].offset) return true;
  return scene.has_flow();
}

}  // namespace

void resize(Diagnostics& seen, std::size_t tools) {
  seen.bounds.resize(1 + tools);
  seen.tables.resize(1 + tools);
  seen.skins.resize(tools);
  seen.peak_force.resize(tools);
  seen.extremes.tools.resize(tools);
}

Diagnostics first_diagnostics(const Scene& scene, const State& start) {
  Diagnostics seen;
  resize(seen, start.tools.size());
  seen.extremes = first_extremes(scene, start);
  return seen;
}

void follow(const Scene& scene, const State& before, const StepResult& step, Diagnostics& seen) {
  if (scene.has_heat()) follow_heat(scene, before, step, seen);
  const bool cools = scene.stages[before.stage].cools;
  if (cools) follow_cooling(surface_tension(step.state), seen.cooling);
  if (scene.has_flow() && !cools) follow_flow(scene, before, step, seen);
  if (has_moved(scene, before, step.state)) follow_glass_in_tools(scene, step.state, seen.in_tools);
  for (std::size_t b = 0; b < seen.tables.size(); ++b)
    follow_tables(scene, step.state, Index(b), step.report.dt, seen.tables[b]);
  follow_forces(scene, step.state, seen.peak_force);
}

}  // namespace parison::forming
