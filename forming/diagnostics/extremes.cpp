// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/diagnostics/extremes.hpp"

#include <algorithm>
#include <cmath>

#include "forming/state/tool_surface.hpp"

namespace parison::forming {
namespace {

/// Whether glass touches a tool; without flow, where contact is not computed, whether the stage uses it.
bool touches_glass(const Scene& scene, const State& state, Index tool) {
  if (scene.has_flow()) {
    const std::vector<Index>& touched = state.glass.contact_tool;
    return std::find(touched.begin(), touched.end(), tool) != touched.end();
  }
  return scene.stages.at(state.stage).uses(tool);
}

/// Raises the hottest surfaces and lowers the coldest glass to those of a state.
void include(const State& state, Extremes& extremes) {
  extremes.tools.resize(state.tools.size());
  for (std::size_t i = 0; i < state.tools.size(); ++i) {
    const HottestPoint hottest = hottest_surface_point(state.tools[i]);
    Extreme& extreme = extremes.tools[i];
    if (hottest.temperature > extreme.temperature || std::isnan(extreme.temperature))
      extreme.set(hottest.temperature, state.time, hottest.at);
  }
  Eigen::Index coldest = 0;
  const double temperature = state.glass.temperature.minCoeff(&coldest);
  if (!(temperature >= extremes.glass.temperature))
    extremes.glass.set(temperature, state.time, state.glass.mesh.nodes[coldest]);
}

}  // namespace

Extremes first_extremes(const Scene& scene, const State& start) {
  Extremes extremes;
  if (scene.has_heat()) include(start, extremes);
  return extremes;
}

void follow_extremes(const Scene& scene, const State& before, const State& state, Extremes& extremes) {
  if (!scene.has_heat()) return;
  include(state, extremes);
  const Flags& flags = scene.output.flags;
  for (std::size_t i = 0; i < state.tools.size(); ++i)
    if (hottest_surface_point(state.tools[i]).temperature > flags.tool_surface_above &&
        touches_glass(scene, state, static_cast<Index>(i)))
      extremes.tools[i].add_beyond(state.time, state.time - before.time);
  if (flags.glass_below && state.glass.temperature.minCoeff() < *flags.glass_below)
    extremes.glass.add_beyond(state.time, state.time - before.time);
}

}  // namespace parison::forming
