// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "forming/diagnostics/table_excess.hpp"
#include "forming/report/checks/checks.hpp"

namespace parison::forming {

namespace {

/// The property that is furthest from its table, and of which body.
struct Worst {
  TableExcess excess;
  std::string property = "a property", body = "any body";
};

void include(const TableExcess& excess, const char* property, const std::string& body, Worst& worst) {
  if (is_worse(excess.error, worst.excess.error)) worst = {excess, property, body};
}

void include(const TablesExcess& tables, const char* of_flow, const std::string& body, Worst& worst) {
  include(tables.conductivity, "the conductivity", body, worst);
  include(tables.heat_capacity, "the heat capacity", body, worst);
  include(tables.flow, of_flow, body, worst);
}

}  // namespace

void add_table_check(const Scene& scene, const std::vector<TablesExcess>& tables, Checks& checks) {
  if (!has_property_tables(scene)) return;
  Worst worst;
  for (std::size_t b = 0; b < tables.size(); ++b)
    include(tables[b], b == glass_body ? "the viscosity" : "the friction",
            b == glass_body ? "the glass" : body_of(scene, Index(b)).name, worst);
  checks.push_back({"property_tables", worst.excess.error, 0.02, 0.5, "%",
                    fmt::format("{} of {} may be wrong by about this, in the mean over the body or its surface when it "
                                "was worst: temperatures were beyond the table for {:.3g} s, by up to {:.3g} K; a "
                                "table over a wider range of temperatures helps",
                                worst.property, worst.body, worst.excess.seconds, worst.excess.furthest)});
}

}  // namespace parison::forming
