// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/solver_statistics.hpp"

#include <algorithm>

namespace parison::forming {

void add_step(const StepReport& report, bool taken, Effort& effort) {
  effort.sweeps += report.sweeps;
  effort.flow_solves += report.flow_solves;
  effort.flow_factorisations += report.flow_factorisations;
  effort.contact_changes += report.contact_changes;
  effort.heat_substeps += report.heat_substeps;
  effort.latched_contacts += report.latched_contacts;
  effort.most_sweeps = std::max(effort.most_sweeps, report.sweeps);
  effort.most_flow_solves = std::max(effort.most_flow_solves, report.flow_solves);
  effort.most_contact_changes = std::max(effort.most_contact_changes, report.contact_changes);
  effort.most_heat_substeps = std::max(effort.most_heat_substeps, report.heat_substeps);
  if (taken) ++effort.limited_by[static_cast<std::size_t>(report.limit)];
}

}  // namespace parison::forming
