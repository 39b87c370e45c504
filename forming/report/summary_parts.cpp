// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/summary_parts.hpp"

#include <cmath>
#include <limits>

#include "forming/report/cavity_report.hpp"
#include "forming/report/checks/check.hpp"
#include "forming/step/work.hpp"

namespace parison::forming {

namespace {

/// Writes numbers under the names that a visit gives them.
struct JsonNumbers {
  core::JsonWriter& json;
  void operator()(const char* name, Index value) { json.add(name, static_cast<long>(value)); }
  void operator()(const char* name, long value) { json.add(name, value); }
  JsonNumbers part(const std::string& name) {
    json.open_object(name);
    return *this;
  }
};

}  // namespace

void add_solver_statistics(core::JsonWriter& json, const SolverStatistics& statistics) {
  json.open_object("solver_statistics");
  visit_statistics(JsonNumbers{json}, statistics);
  json.close();
  json.close();
}

void add_work(core::JsonWriter& json, const Work& work) {
  json.open_object("work");
  json.add("tools_J", work.tools);
  json.add("gravity_J", work.gravity);
  json.add("air_J", work.air);
  json.add("dissipation_J", work.dissipation);
  json.add("friction_J", work.friction);
  json.add("impact_loss_J", work.impact_loss);
  json.add("surface_J", work.surface);
  json.add("correction_J", work.correction);
  json.add("imbalance", work_imbalance(work));
  json.close();
}

void add_cavities(core::JsonWriter& json, const Scene& scene, const State& state) {
  if (!seals_cavities(scene)) return;
  const CavityReport report = cavity_report(scene, state);
  json.open_list("cavities");
  for (std::size_t i = 0; i < report.size(); ++i) {
    json.open_object("");
    json.add("volume_m3", report.volume[i]);
    json.add("pressure_Pa", report.pressure[i]);
    json.add("mass_kg", report.mass[i]);
    json.close();
  }
  json.close();
}

double max_work_imbalance(const Scene& scene, const State& state, const RunFacts& run) {
  if (!scene.has_flow() || run.stages.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double least = least_loss(scene, state);
  double largest = 0;
  for (const StageRecord& stage : run.stages)
    if (const double found = std::abs(work_imbalance(stage.work, least)); is_worse(found, largest)) largest = found;
  return largest;
}

}  // namespace parison::forming
