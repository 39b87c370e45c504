#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "forming/solid/solid_state.hpp"

namespace parison::forming {

/// Lists the values of glass in space that change while it is formed, as visit_state does; what stays is that of the
/// hand-over. Tools of `without`, indices into Scene::tools, are left out.
template <typename Visitor, typename Solid>
void visit_solid(Visitor visit, Solid& solid, const std::vector<Index>& without = {}) {
  visit("nodes", solid.glass.mesh.nodes);
  visit("temperature", solid.glass.temperature);
  visit("cell_mass", solid.glass.cell_mass);
  visit("velocity", solid.glass.velocity);
  visit("velocity_before", solid.glass.velocity_before);
  visit("glass_last_step", solid.glass.last_step);
  visit("glass_step_before", solid.glass.step_before);
  visit("pressure", solid.glass.pressure);
  visit("contact", solid.glass.contact);
  visit("point_mass", solid.point_mass);
  visit("temperature_rate", solid.temperature_rate);
  visit("contact_opening", solid.contact_opening);
  visit("branch_stress", solid.branch_stress);
  visit("fictive_temperature", solid.fictive_temperature);
  visit("last_step", solid.last_step);
  visit("next_step", solid.next_step);
  visit("heat_substep", solid.heat_substep);
  auto& totals = solid.totals;
  visit("steps", totals.steps);
  visit("rejected", totals.rejected);
  visit("factors", totals.factors);
  visit("solutions", totals.solutions);
  visit("to_air", totals.to_air);
  visit("to_tools", totals.to_tools);
  visit("light_to_air", totals.light_to_air);
  visit("light_to_tools", totals.light_to_tools);
  visit("start_heat", totals.start_heat);
  visit("volume_error", totals.volume_error);
  visit("heat_imbalance", totals.heat_imbalance);
  for (auto& tool : solid.tools) {
    if (std::find(without.begin(), without.end(), tool.tool) != without.end()) continue;
    Visitor part = visit.part(fmt::format("tool_{}", tool.tool));
    part("temperature", tool.temperature);
    part("mass", tool.mass);
    part("heat_received", tool.heat_received);
    for (int axis = 0; axis < 3; ++axis) part(fmt::format("force_{}", axis).c_str(), tool.force[axis]);
  }
}

}  // namespace parison::forming
