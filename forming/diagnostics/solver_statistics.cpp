// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/diagnostics/solver_statistics.hpp"

#include <algorithm>

namespace parison::forming {

namespace {

/// Times numerics.min_step: a step below counts as collapsed.
constexpr double short_step = 10;

}  // namespace

void add_step(const Scene& scene, const StepReport& report, bool accepted, SolverStatistics& statistics) {
  statistics.coupling_iterations += report.coupling_iterations;
  statistics.flow_solves += report.flow_solves;
  statistics.flow_factorisations += report.flow_factorisations;
  statistics.contact_changes += report.contact_changes;
  statistics.heat_substeps += report.heat_substeps;
  statistics.contacts += report.contacts;
  statistics.locked_contacts += report.locked_contacts;
  statistics.max_coupling_iterations = std::max(statistics.max_coupling_iterations, report.coupling_iterations);
  statistics.max_flow_solves = std::max(statistics.max_flow_solves, report.flow_solves);
  statistics.max_contact_changes = std::max(statistics.max_contact_changes, report.contact_changes);
  statistics.max_heat_substeps = std::max(statistics.max_heat_substeps, report.heat_substeps);
  if (!accepted) {
    ++statistics.rejected;
    return;
  }
  ++statistics.limited_by[static_cast<std::size_t>(report.limit)];
  if (report.dt < short_step * scene.accuracy.min_step) ++statistics.short_steps;
  if (report.unconverged) ++statistics.unconverged;
}

}  // namespace parison::forming
