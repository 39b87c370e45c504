#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "forming/scene/scene.hpp"
#include "forming/step/step_result.hpp"

namespace parison::forming {

/// Cost of the steps of a run. Sums include rejected steps, `limited_by` counts accepted ones only.
struct SolverStatistics {
  long coupling_iterations = 0, flow_solves = 0, flow_factorisations = 0, contact_changes = 0, heat_substeps = 0;
  long contacts = 0;         ///< active, summed over all steps
  long locked_contacts = 0;  ///< contacts, over all steps, that pulled but stayed closed
  Index max_coupling_iterations = 0, max_flow_solves = 0, max_contact_changes = 0,
        max_heat_substeps = 0;          ///< in one step
  Index rejected = 0, short_steps = 0;  ///< steps refused; accepted ones nearly as short as numerics.min_step
  Index unconverged = 0;                ///< accepted steps whose coupling iteration ended at its limit
  std::array<Index, step_limits.size()> limited_by{};  ///< steps by StepLimit
};

/// Adds a step that was tried; one that was `accepted` counts for its limit.
void add_step(const Scene& scene, const StepReport& report, bool accepted, SolverStatistics& statistics);

template <typename Visitor, typename Counts>
void visit_statistics(Visitor visit, Counts& statistics) {
  visit("coupling_iterations", statistics.coupling_iterations);
  visit("flow_solves", statistics.flow_solves);
  visit("flow_factorisations", statistics.flow_factorisations);
  visit("contact_changes", statistics.contact_changes);
  visit("heat_substeps", statistics.heat_substeps);
  visit("contacts", statistics.contacts);
  visit("locked_contacts", statistics.locked_contacts);
  visit("rejected", statistics.rejected);
  visit("short_steps", statistics.short_steps);
  visit("unconverged", statistics.unconverged);
  visit("max_coupling_iterations_per_step", statistics.max_coupling_iterations);
  visit("max_flow_solves_per_step", statistics.max_flow_solves);
  visit("max_contact_changes_per_step", statistics.max_contact_changes);
  visit("max_heat_substeps_per_step", statistics.max_heat_substeps);
  Visitor limits = visit.part("steps_limited_by");
  for (std::size_t i = 0; i < step_limits.size(); ++i) limits(step_limits[i], statistics.limited_by[i]);
}

}  // namespace parison::forming
