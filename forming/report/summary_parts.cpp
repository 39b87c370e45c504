// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/summary_parts.hpp"

#include <cmath>
#include <limits>

#include "forming/report/cavity_report.hpp"
#include "forming/report/checks/check.hpp"
#include "forming/step/balance/work.hpp"

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

void add_errors(core::JsonWriter& json, const ErrorBars& bars) {
  json.open_object("error_bars");
  json.open_list("coarser_runs");
  for (const CoarserRun& run : bars.coarser) {
    json.open_object("");
    json.add("coarser", run.factor);
    json.add("cpu_seconds", run.cpu_seconds);
    json.close();
  }
  json.close();
  json.add("thickness_profile_mean", bars.profile_mean);
  json.add("thickness_profile_max", bars.profile_max);
  json.add("heat_into_tools", bars.heat);
  json.close();
}

void add_control(core::JsonWriter& json, const AccuracyRecord& control) {
  json.open_object("accuracy_control");
  json.add("target", control.target);
  json.add("reached", control.reached());
  json.open_list("runs");
  for (const ControlledRun& run : control.runs) {
    json.open_object("");
    json.add("coarser_than_draft", run.factor);
    json.add("completed", run.completed);
    json.add("cpu_seconds", run.cpu_seconds);
    if (std::isfinite(run.estimate)) json.add("estimated_error", run.estimate);
    json.open_list("condemned_by");
    for (const std::string& check : run.condemned_by) json.add("", check);
    json.close();
    json.close();
  }
  json.close();
  json.open_list("not_mended");
  for (const std::string& check : control.not_mended) json.add("", check);
  json.close();
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
