#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "forming/state/state.hpp"

namespace parison::forming {

/// Lists every value of a state with its name: one list serves writing, reading and comparing. A visitor takes a name
/// and a value, and gives a visitor for a named part.
template <typename Visitor, typename Body>
void visit_body(Visitor visit, Body& body) {
  visit("mesh", body.mesh);
  visit("temperature", body.temperature);
  visit("offset", body.offset);
  visit("velocity", body.velocity);
  visit("force", body.force);
  visit("peak_force", body.peak_force);
  visit("heat_received", body.heat_received);
  visit("hottest_surface", body.hottest_surface);
}

template <typename Visitor, typename Ledger>
void visit_remeshing(Visitor visit, Ledger& remeshing) {
  for (std::size_t i = 0; i < remeshing.count.size(); ++i) visit(remesh_reasons[i], remeshing.count[i]);
  visit("heat", remeshing.heat);
  visit("largest_heat", remeshing.largest_heat);
  visit("volume", remeshing.volume);
  visit("largest_volume", remeshing.largest_volume);
  visit("new_extreme", remeshing.new_extreme);
  visit("worst_quality", remeshing.worst_quality);
  visit("lowest_median", remeshing.lowest_median);
  visit("failed", remeshing.failed);
  visit("laps", remeshing.laps);
  visit("lap_volume", remeshing.lap_volume);
  visit("coarser", remeshing.coarser);
}

template <typename Visitor, typename Sums>
void visit_work(Visitor visit, Sums& work) {
  visit("tools", work.tools);
  visit("gravity", work.gravity);
  visit("air", work.air);
  visit("dissipation", work.dissipation);
  visit("friction", work.friction);
  visit("arrival", work.arrival);
  visit("surface", work.surface);
  visit("corrections", work.corrections);
}

template <typename Visitor, typename Sums>
void visit_totals(Visitor visit, Sums& totals) {
  visit("to_air", totals.to_air);
  visit("to_tools", totals.to_tools);
  visit("dissipation", totals.dissipation);
  visit("steps", totals.steps);
  visit("rejected", totals.rejected);
  visit("table_holds", totals.table_holds);
  visit("deepest", totals.deepest);
  visit("largest_drift", totals.largest_drift);
  visit("largest_reynolds", totals.largest_reynolds);
  visit("overshoot", totals.overshoot);
  visit("largest_flux_mismatch", totals.largest_flux_mismatch);
  visit_work(visit.part("work"), totals.work);
  visit_remeshing(visit.part("remeshing"), totals.remeshing);
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
  visit("last_step", state.last_step);
  visit("mass_nodes", state.mass_nodes);
  visit("density", state.density);
  visit("first_volume", state.first_volume);
  visit("first_heat", state.first_heat);
  visit("velocity", state.velocity);
  visit("acceleration", state.acceleration);
  visit("swelling", state.swelling);
  visit("moves_smoothly", state.moves_smoothly);
  visit("temperature_rate", state.temperature_rate);
  visit("contact_tool", state.contact.tool);
  visit("contact_tool_before", state.contact.tool_before);
  visit("contact_pressure", state.contact.pressure);
  visit("contact_closed_node", state.contact.closed.node);
  visit("contact_closed_tool", state.contact.closed.tool);
  visit("contact_closed_normal", state.contact.closed.normal);
  visit("probes", state.probes);
  visit_totals(visit.part("totals"), state.totals);
  for (std::size_t i = 0; i < state.bodies.size(); ++i)
    visit_body(visit.part(fmt::format("body_{}", i)), state.bodies[i]);
}

}  // namespace parison::forming
