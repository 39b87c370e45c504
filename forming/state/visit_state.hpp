#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "forming/state/state.hpp"

namespace parison::forming {

/// Lists every value of a state with its name: one list serves writing, reading and comparing. A visitor takes a name
/// and a value, and gives a visitor for a named part.
template <typename Visitor, typename Tool>
void visit_tool(Visitor visit, Tool& tool) {
  visit("mesh", tool.mesh);
  visit("temperature", tool.temperature);
  visit("offset", tool.offset);
  visit("velocity", tool.velocity);
  visit("slowing", tool.slowing);
  visit("force", tool.force);
  visit("end_force", tool.end_force);
  visit("heat_received", tool.heat_received);
  visit("heat_radiated", tool.heat_radiated);
  visit("heat_from_enclosure", tool.heat_from_enclosure);
  visit("heat_through", tool.heat_through);
}

template <typename Visitor, typename Glass>
void visit_glass(Visitor visit, Glass& glass) {
  visit("mesh", glass.mesh);
  visit("mass_nodes", glass.mass_nodes);
  visit("density", glass.density);
  visit("mass_temperature", glass.mass_temperature);
  visit("mass", glass.mass);
  visit("initial_volume", glass.initial_volume);
  visit("initial_heat", glass.initial_heat);
  for_each_glass_field([&](const auto& field) { visit(field.name, glass.*field.values); });
  visit("active_contact_node", glass.active_contacts.node);
  visit("active_contact_tool", glass.active_contacts.tool);
  visit("active_contact_normal", glass.active_contacts.normal);
}

template <typename Visitor, typename Statistics>
void visit_remeshing(Visitor visit, Statistics& remeshing) {
  for (std::size_t i = 0; i < remeshing.count.size(); ++i) visit(remesh_reasons[i], remeshing.count[i]);
  visit("heat", remeshing.heat);
  visit("max_heat", remeshing.max_heat);
  visit("volume", remeshing.volume);
  visit("max_volume", remeshing.max_volume);
  visit("transfer_overshoot", remeshing.transfer_overshoot);
  visit("min_quality", remeshing.min_quality);
  visit("min_median", remeshing.min_median);
  visit("before_step", remeshing.before_step);
  visit("failed", remeshing.failed);
  visit("laps", remeshing.laps);
  visit("lap_volume", remeshing.lap_volume);
  visit("enclosed", remeshing.enclosed);
  visit("enclosed_volume", remeshing.enclosed_volume);
  visit("torn", remeshing.torn);
  visit("torn_volume", remeshing.torn_volume);
  visit("coarsening_factor", remeshing.coarsening_factor);
}

template <typename Visitor, typename Sums>
void visit_work(Visitor visit, Sums& work) {
  visit("tools", work.tools);
  visit("gravity", work.gravity);
  visit("air", work.air);
  visit("dissipation", work.dissipation);
  visit("friction", work.friction);
  visit("impact_loss", work.impact_loss);
  visit("surface", work.surface);
  visit("expansion", work.expansion);
  visit("correction", work.correction);
}

template <typename Visitor, typename Sums>
void visit_totals(Visitor visit, Sums& totals) {
  visit("to_air", totals.to_air);
  visit("light_to_air", totals.light_to_air);
  visit("from_enclosure", totals.from_enclosure);
  visit("to_tools", totals.to_tools);
  visit("dissipation", totals.dissipation);
  visit("steps", totals.steps);
  visit_work(visit.part("work"), totals.work);
  visit_remeshing(visit.part("remeshing"), totals.remeshing);
}

template <typename Visitor, typename Air>
void visit_cavity_air(Visitor visit, Air& air) {
  visit("volume", air.volume);
  visit("energy", air.energy);
  visit("amount", air.amount);
  visit("marker", air.marker);
  visit("marker_cavity", air.marker_cavity);
}

template <typename Visitor, typename Places>
void visit_light(Visitor visit, Places& light) {
  visit("rays", light.rays);
  visit("surfaces", light.surfaces);
  visit("absorption", light.absorption);
  visit("views", light.views);
  visit("open_area", light.open_area);
  visit("area", light.area);
}

template <typename Visitor, typename Whole>
void visit_state(Visitor visit, Whole& state) {
  visit("time", state.time);
  visit("stage", state.stage);
  visit("stage_time", state.stage_time);
  visit("stage_start", state.stage_start);
  visit("has_moved", state.has_moved);
  visit("next_step", state.next_step);
  visit("next_limit", state.next_limit);
  visit("heat_substep", state.heat_substep);
  visit("heat_couplings", state.heat_couplings);
  visit_light(visit.part("light"), state.light);
  visit("last_step", state.last_step);
  visit("last_landed", state.last_landed);
  visit("last_work_error", state.last_work_error);
  visit("moves_smoothly", state.moves_smoothly);
  visit("probes", state.probes);
  visit_cavity_air(visit.part("cavity_air"), state.cavity_air);
  visit_totals(visit.part("totals"), state.totals);
  visit_glass(visit.part("glass"), state.glass);
  for (std::size_t i = 0; i < state.tools.size(); ++i)
    visit_tool(visit.part(fmt::format("tool_{}", i)), state.tools[i]);
}

}  // namespace parison::forming
