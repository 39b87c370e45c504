#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "forming/state/state.hpp"

namespace parison::forming {

/// What the steps of a run took. Sums hold rejected steps too, `limited_by` those that were taken.
struct Effort {
  long sweeps = 0, flow_solves = 0, flow_factorisations = 0, contact_changes = 0, heat_substeps = 0;
  long latched_contacts = 0;  ///< contacts, over all steps, that pulled but stayed closed
  Index most_sweeps = 0, most_flow_solves = 0, most_contact_changes = 0, most_heat_substeps = 0;  ///< in one step
  std::array<Index, step_limits.size()> limited_by{};  ///< steps by StepLimit
};

/// Adds a step that was tried; one that was `taken` counts for its limit.
void add_step(const StepReport& report, bool taken, Effort& effort);

template <typename Visitor, typename Counts>
void visit_effort(Visitor visit, Counts& effort) {
  visit("sweeps", effort.sweeps);
  visit("flow_solves", effort.flow_solves);
  visit("flow_factorisations", effort.flow_factorisations);
  visit("contact_changes", effort.contact_changes);
  visit("heat_substeps", effort.heat_substeps);
  visit("latched_contacts", effort.latched_contacts);
  visit("most_sweeps_in_a_step", effort.most_sweeps);
  visit("most_flow_solves_in_a_step", effort.most_flow_solves);
  visit("most_contact_changes_in_a_step", effort.most_contact_changes);
  visit("most_heat_substeps_in_a_step", effort.most_heat_substeps);
  Visitor limits = visit.part("steps_limited_by");
  for (std::size_t i = 0; i < step_limits.size(); ++i) limits(step_limits[i], effort.limited_by[i]);
}

}  // namespace parison::forming
