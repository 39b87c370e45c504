// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/summary.hpp"

#include <fmt/format.h>

#include <limits>

#include "core/io/files.hpp"
#include "core/io/json.hpp"
#include "core/io/written_files.hpp"
#include "core/process/build_id.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/report/container/container_report.hpp"
#include "forming/report/contour/contour.hpp"
#include "forming/report/cooling/residual_stress.hpp"
#include "forming/report/error_bars.hpp"
#include "forming/report/files/interface_rows.hpp"
#include "forming/report/files/solid_files.hpp"
#include "forming/report/process/mould_filling.hpp"
#include "forming/report/summary_parts.hpp"
#include "forming/report/wall/solid_quantities.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/state/fingerprint.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/cooling/cooling_step.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {
namespace {

using core::JsonWriter;

double celsius(double kelvin) {
  return kelvin - thermal::content_reference;
}

void add_run(JsonWriter& json, const Scene& scene, const State& state, const Summary& summary) {
  json.add("case", scene.name);
  json.add("geometry", scene.geometry == core::Geometry::axisymmetric ? "axisymmetric" : "planar");
  json.add("accuracy", scene.accuracy_name);
  json.open_list("overrides");
  for (const std::string& assignment : scene.overrides) json.add("", assignment);
  json.close();
  json.open_object("dimensions");
  for (const core::NamedDimension& dimension : scene.dimensions) {
    json.open_object(dimension.name);
    json.add("given", dimension.given);
    json.add("value_SI", dimension.measure.value);
    json.close();
  }
  json.close();
  json.add("completed", summary.run.completed);
  json.add("stopped", summary.run.stopped || summary.run.interrupted);
  json.add("reason", summary.run.reason);
  json.add("time_s", state.time);
  json.add("wall_seconds", summary.run.wall_seconds);
  json.add("cpu_seconds", summary.run.cpu_seconds);
  json.add("steps", static_cast<long>(state.totals.steps));
  json.add("rejected_steps", static_cast<long>(summary.run.diagnostics.steps.rejected));
  json.add("case_fingerprint", core::fingerprint_text(scene.fingerprint));
  json.add("state_fingerprint", core::fingerprint_text(fingerprint(state)));
  json.add("program_build", core::build_id());
  json.add("remeshes", static_cast<long>(remeshes(state)));
  json.open_object("timing");
  for (const char* part : timed_parts) {
    const auto found = summary.run.timing.find(part);
    json.add(part, found == summary.run.timing.end() ? 0.0 : found->second);
  }
  json.close();
}

void add_numerics(JsonWriter& json, const Accuracy& accuracy) {
  json.open_object("numerics");
  for (const Setting& setting : settings()) json.add(setting.key, accuracy.*setting.value);
  json.close();
}

/// The model of radiation in the glass and, where it was chosen, by what.
void add_radiation(JsonWriter& json, const Scene& scene) {
  if (!scene.has_heat()) return;
  json.open_object("radiation");
  json.add("model", model_name(scene.glass.thermal->radiation));
  json.add("enclosure", scene.enclosure);
  json.add("chosen", scene.radiation_choice.has_value());
  if (const auto& choice = scene.radiation_choice) {
    json.add("error_asked_for", choice->within);
    json.add("expected_error",
             choice->model.error > 0 ? choice->model.error : std::numeric_limits<double>::quiet_NaN());
    json.add("measured_scenes", static_cast<long>(calibration().radiation.scenes.size()));
    json.add("measured_by", calibration().radiation.commit);
    json.add("measured_on", calibration().radiation.date);
  }
  json.close();
}

void add_hottest_glass(JsonWriter& json, const Scene& scene, const HotGlass& hottest) {
  json.open_object("glass_above_sources");
  json.add("kelvin", hottest.above);
  json.add("stage", scene.stages[hottest.stage].name);
  json.add("time_s", hottest.time);
  json.add("r_mm", 1e3 * hottest.r);
  json.add("z_mm", 1e3 * hottest.z);
  json.add("volume_share_above_5_K", hottest.volume_share);
  json.close();
}

void add_balance(JsonWriter& json, const Scene& scene, const State& state, const Summary& summary) {
  const Diagnostics& seen = summary.run.diagnostics;
  json.add("volume_drift", summary.glass.volume_drift);
  json.add("energy_imbalance", summary.glass.energy_imbalance);
  json.add("max_volume_drift", seen.max_drift);
  json.add("max_penetration_mm", 1e3 * seen.in_tools.node.depth);
  json.add("max_edge_penetration_mm", 1e3 * seen.in_tools.edge.depth);
  json.add("outer_within_0.2mm_of_tools", summary.outer_within_02mm);
  json.add("heat_to_air_J", summary.heat_lost.to_air);
  if (scene.has_light()) json.add("light_to_surroundings_J", summary.heat_lost.light_to_air);
  if (scene.enclosure) json.add("light_from_enclosure_J", state.totals.from_enclosure);
  json.add("dissipation_J", state.totals.dissipation);
  json.add("max_reynolds", seen.work.max_reynolds);
  json.add("max_flux_mismatch", seen.max_flux_mismatch);
  json.add("temperature_overshoot_K", seen.hot_glass.overshoot);
  json.add("clamped_table_lookups", seen.clamped_lookups);
}

void add_remeshing(JsonWriter& json, const State& state, const Summary& summary) {
  const RemeshStatistics& statistics = state.totals.remeshing;
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double heat = state.glass.initial_heat != 0 ? state.glass.initial_heat : none;
  json.open_object("remeshing");
  for (std::size_t i = 0; i < statistics.count.size(); ++i)
    json.add(fmt::format("for_{}", remesh_reasons[i]), static_cast<long>(statistics.count[i]));
  json.add("failed", static_cast<long>(statistics.failed));
  json.add("laps", static_cast<long>(statistics.laps));
  json.add("lap_volume_m3", statistics.lap_volume);
  json.add("enclosed_air", static_cast<long>(statistics.enclosed));
  json.add("enclosed_air_volume_m3", statistics.enclosed_volume);
  json.add("torn_pieces", static_cast<long>(statistics.torn));
  json.add("torn_volume_m3", statistics.torn_volume);
  json.add("heat_drift", statistics.heat / heat);
  json.add("max_heat_change", statistics.max_heat / heat);
  json.add("volume_drift", statistics.volume / state.glass.initial_volume);
  json.add("max_volume_change", statistics.max_volume / state.glass.initial_volume);
  json.add("transfer_overshoot_K", statistics.transfer_overshoot);
  json.add("min_quality", remeshes(state) > 0 ? statistics.min_quality : none);
  json.add("min_median_quality", remeshes(state) > 0 ? statistics.min_median : none);
  const auto seconds = summary.run.timing.find("remesh");
  json.add("seconds", seconds == summary.run.timing.end() ? 0.0 : seconds->second);
  json.close();
}

void add_bodies(JsonWriter& json, const Summary& summary) {
  json.open_object("glass");
  json.add("mass_kg", summary.glass.mass);
  json.add("volume_m3", summary.glass.volume);
  json.add("temperature_mean_degC", celsius(summary.glass.mean));
  json.add("temperature_min_degC", celsius(summary.glass.lowest));
  json.add("temperature_max_degC", celsius(summary.glass.highest));
  json.close();
  json.open_object("tools");
  for (const ToolSummary& tool : summary.tools) {
    json.open_object(tool.name);
    json.add("heat_received_J", tool.heat_received);
    if (tool.radiated) json.add("heat_radiated_J", *tool.radiated);
    if (tool.from_enclosure) json.add("heat_from_enclosure_J", *tool.from_enclosure);
    if (tool.energy_imbalance) json.add("energy_imbalance", *tool.energy_imbalance);
    json.add("surface_temperature_max_degC", celsius(tool.hottest.temperature));
    json.add("hottest_time_s", tool.hottest.time);
    json.add("hottest_r_mm", 1e3 * tool.hottest.at[0]);
    json.add("hottest_z_mm", 1e3 * tool.hottest.at[1]);
    json.open_object("heat_through_faces_J");
    for (const auto& [face, heat] : tool.faces) json.add(face, heat);
    json.close();
    json.close();
  }
  json.close();
}

void add_stages(JsonWriter& json, const Scene& scene, const RunFacts& run) {
  json.open_list("stages");
  for (std::size_t i = 0; i < run.stages.size(); ++i) {
    const StageRecord& stage = run.stages[i];
    json.open_object("");
    json.add("name", stage.name);
    json.add("upright", is_upright(scene, i));
    json.add("start_s", stage.start);
    json.add("end_s", stage.end);
    json.add("end_reason", stage.end_reason);
    add_work(json, stage.work);
    json.close();
  }
  json.close();
}

/// Without a wall the reason alone.
void add_thickness(JsonWriter& json, const Summary& summary) {
  const ThicknessRange& range = summary.thickness;
  json.open_object("thickness");
  if (summary.no_wall.empty()) {
    json.add("min_mm", 1e3 * range.lowest);
    json.add("mean_mm", 1e3 * range.mean);
    json.add("max_mm", 1e3 * range.highest);
    json.add("min_r_mm", 1e3 * range.lowest_at[0]);
    json.add("min_z_mm", 1e3 * range.lowest_at[1]);
    json.add("max_r_mm", 1e3 * range.highest_at[0]);
    json.add("max_z_mm", 1e3 * range.highest_at[1]);
    if (const ThicknessRange& beside = summary.beside_finish; std::isfinite(beside.mean)) {
      json.add("beside_finish_min_mm", 1e3 * beside.lowest);
      json.add("beside_finish_min_r_mm", 1e3 * beside.lowest_at[0]);
      json.add("beside_finish_min_z_mm", 1e3 * beside.lowest_at[1]);
    }
  } else {
    json.add("absent", summary.no_wall);
  }
  json.close();
}

void add_container_in_space(JsonWriter& json, const Summary& summary) {
  json.open_object("container");
  json.add("weight_g", 1e3 * summary.glass.mass);
  json.add("capacity_ml", 1e6 * *summary.capacity_in_space);
  if (summary.cold) {
    json.add("height_mm", 1e3 * summary.cold->height);
    json.add("diameter_mm", 1e3 * summary.cold->diameter);
  }
  json.close();
}

std::string summary_json(const Scene& scene, const State& state, const Summary& summary, const ErrorBars* bars) {
  JsonWriter json;
  add_run(json, scene, state, summary);
  add_numerics(json, scene.accuracy);
  add_radiation(json, scene);
  add_balance(json, scene, state, summary);
  if (scene.has_heat()) add_hottest_glass(json, scene, summary.run.diagnostics.hot_glass);
  add_work(json, state.totals.work);
  json.add("max_work_imbalance", max_work_imbalance(scene, state, summary.run));
  add_solver_statistics(json, summary.run.diagnostics.steps);
  add_remeshing(json, state, summary);
  add_bodies(json, summary);
  add_stages(json, scene, summary.run);
  add_cavities(json, scene, state);
  add_thickness(json, summary);
  add_flags(json, summary.flags);
  add_checks(json, summary.run.checks, summary.run.completed);
  if (summary.capacity_in_space)
    add_container_in_space(json, summary);
  else
    add_container(json, scene, state, summary.no_wall.empty());
  add_cooling(json, summary);
  if (bars) add_errors(json, *bars);
  if (bars && bars->control) add_control(json, *bars->control);
  add_quantities(json, summary.quantities);
  json.open_list("warnings");
  for (const std::string& warning : summary.run.warnings) json.add("", warning);
  return json.finish();
}

/// The wall of the parison is not that of a container that is formed in space.
void leave_out_wall(const Scene& scene, Summary& summary) {
  summary.thickness = summary.beside_finish = thickness_range({});
  summary.no_wall = fmt::format("the glass is a body in space from stage \"{}\" on: see the folder solid",
                                scene.stages[scene.solid->from_stage].name);
}

/// Leaves a file in a result folder that says so where its results are not trustworthy.
void mark(const std::string& directory, const Checks& checks) {
  const std::string path = directory + "/NOT_TRUSTWORTHY.txt";
  if (trustworthy(checks)) {
    core::remove_own(path);
    return;
  }
  core::replace_file(path, fmt::format("The results in this folder are not trustworthy.\n{}\n{}\n",
                                       verdict_sentence(checks), fmt::join(complaints(checks), "\n")));
}

}  // namespace

Summary summarise(const Scene& scene, const State& state, const RunFacts& run, const ThicknessProfile& profile,
                  const SolidState* solid) {
  Summary summary;
  summary.run = run;
  summary.glass = glass_facts(scene, state);
  summary.heat_lost = {state.totals.to_tools, state.totals.to_air, state.totals.light_to_air};
  summary.thickness = thickness_range(profile.rows);
  summary.beside_finish = thickness_beside_finish(scene, state, profile);
  summary.no_wall = profile.no_wall;
  summary.wall_stress = wall_stress(state.glass, profile.rows);
  const bool in_space = scene.solid && state.stage >= scene.solid->from_stage;
  if (in_space) leave_out_wall(scene, summary);
  summary.outer_within_02mm =
      remembers(state) ? std::numeric_limits<double>::quiet_NaN() : share_near_tools(scene, state, profile.outer_edges);
  const std::vector<Extreme>& hottest = run.diagnostics.extremes.tools;
  for (std::size_t i = 0; i < scene.tools.size(); ++i) {
    const ToolState& body = state.tools[i];
    const auto radiated = scene.has_light() ? std::optional(body.heat_radiated) : std::nullopt;
    summary.tools.push_back({scene.tools[i].name,
                             body.heat_received,
                             scene.enclosure ? std::optional(body.heat_from_enclosure) : std::nullopt,
                             radiated,
                             scene.has_heat() && scene.tools[i].thermal
                                 ? std::optional(energy_imbalance(scene, state, static_cast<Index>(i)))
                                 : std::nullopt,
                             i < hottest.size() ? hottest[i] : Extreme{},
                             body.offset,
                             body.end_force,
                             {}});
    if (scene.tools[i].thermal)
      for (const std::size_t face : reported_faces(scene.tools[i]))
        summary.tools.back().faces.emplace_back(scene.tools[i].boundaries[face].name, body.heat_through[face]);
  }
  const auto wall = solid ? std::optional(solid_wall(*solid)) : std::nullopt;
  summary.cold = wall ? cooled_container(scene, *solid, wall->capacity, state.time)
                      : cooled_container(scene, state, summary.no_wall.empty());
  if (wall) put_solid(*solid, *wall, summary);
  summary.flags = raised_flags(scene, run.diagnostics.extremes, state.time, summary.thickness);
  if (const auto flag = mould_not_filled(run.filling); flag && run.completed) summary.flags.push_back(*flag);
  summary.quantities = wall ? solid_quantities(scene, state, summary, *solid, *wall)
                            : quantities(scene, state, summary, in_space ? ThicknessProfile{} : profile);
  return summary;
}

Summary write_summary(const std::string& directory, const Scene& scene, const RunOutcome& outcome) {
  const State& state = outcome.state;
  const ThicknessProfile profile = thickness_profile(scene, state);
  const Summary summary = summarise(scene, state, outcome.facts, profile, outcome.solid.get());
  if (outcome.solid) {
    write_solid_summary(scene, directory, *outcome.solid, solid_wall(*outcome.solid));
    mark(directory, outcome.facts.checks);
    core::replace_file(directory + "/summary.json", summary_json(scene, state, summary, nullptr));
    return summary;
  }
  write_thickness(directory + "/thickness.csv", profile.rows);
  const std::string stress = directory + "/residual_stress.csv";
  if (remembers(state))
    core::replace_file(stress, wall_stress_text(summary.wall_stress));
  else
    core::remove_own(stress);
  const std::vector<ContourPoint> points = contour(scene, state, profile);
  core::replace_file(directory + "/contour.csv", contour_text(scene, state, points), core::Reach::system);
  core::replace_file(directory + "/heights.csv", heights_text(height_rows(scene, state, points)), core::Reach::system);
  mark(directory, outcome.facts.checks);
  for (const char* name : {"/thickness.csv", "/contour.csv", "/heights.csv"}) core::sync_to_disk(directory + name);
  core::replace_file(directory + "/summary.json", summary_json(scene, state, summary, nullptr));  // last: it says done
  return summary;
}

void add_error_bars(const std::string& directory, const Scene& scene, const State& state, const ErrorBars& bars,
                    Summary& summary) {
  summary.quantities = bars.quantities;
  core::replace_file(directory + "/summary.json", summary_json(scene, state, summary, &bars));
}

}  // namespace parison::forming
