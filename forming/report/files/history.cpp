// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/files/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/io/files.hpp"
#include "core/math/numbers.hpp"
#include "core/mesh/element.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/state/sample.hpp"
#include "forming/state/start_temperature.hpp"
#include "forming/step/balance/volume_conservation.hpp"
#include "forming/step/cooling/cooling_step.hpp"
#include "forming/step/heat/heat_step.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {
namespace {

/// Heat that no entry of a balance explains, relative to what the glass has lost.
double relative_to_heat_lost(const State& state, double unexplained) {
  const Totals& totals = state.totals;
  const double lost = std::abs(totals.to_tools + totals.to_air), round_off = 1e-9 * std::abs(state.glass.initial_heat);
  return std::abs(unexplained) / std::max(lost, round_off);
}

/// From the present heat content itself, not from the changes that the heat solver reports.
double energy_imbalance(const Scene& scene, const State& state) {
  const Totals& totals = state.totals;
  return relative_to_heat_lost(state, glass_heat(scene, state) - state.glass.initial_heat + totals.to_tools +
                                          totals.to_air - totals.dissipation);
}

/// Edges that a tool presses at all three nodes.
double active_contact_area(const Scene& scene, const State& state) {
  const core::Mesh& mesh = state.glass.mesh;
  const auto& tool = state.glass.contact_tool;
  double area = 0;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    if (std::any_of(edge.nodes.begin(), edge.nodes.end(), [&](Index node) { return tool.at(node) < 0; })) continue;
    for (const core::EdgeRulePoint& at : core::edge_rule(3))
      area += core::map_edge_point(mesh, edge.nodes, scene.geometry, at).area;
  }
  return area;
}

double weighted_contact_area(const std::vector<core::InterfacePoint>& interface) {
  double area = 0;
  for (const core::InterfacePoint& point : interface) area += point.contact_weight * point.area;
  return area;
}

double probe_temperature(const Scene& scene, const State& state, std::size_t probe) {
  const Index body = scene.probes[probe].body;
  if (temperature_of(state, body).size() == 0) return core::none;
  return sample(mesh_of(state, body), temperature_of(state, body), state.probes.at(probe));
}

std::vector<double> in_cubic_millimetres(std::vector<double> volumes) {
  for (double& volume : volumes) volume *= 1e9;
  return volumes;
}

double mean_temperature(const Scene& scene, const State& state) {
  const GlassState& glass = state.glass;
  const core::Mesh mass = mass_mesh(state);
  if (!scene.expands()) return core::volume_mean(mass, scene.geometry, glass.temperature);
  const core::Table density = scene.glass.relative_density();
  return core::integral(mass, scene.geometry, glass.temperature, glass.mass_temperature,
                        [&](double T, double then) { return density(then) * T; }) /
         relative_mass(scene, glass);
}

}  // namespace

GlassFacts glass_facts(const Scene& scene, const State& state) {
  const GlassState& glass = state.glass;
  GlassFacts facts;
  facts.volume = core::volume(glass.mesh, scene.geometry);
  facts.mass = state.glass.density * relative_mass(scene, state.glass);
  // Cooled glass has the volume that its structure gives it.
  facts.volume_drift = remembers(state) ? 0 : excess_volume(scene, state) / state.glass.initial_volume;
  facts.mean = facts.lowest = facts.highest = core::none;
  facts.energy_imbalance = 0;
  if (!scene.has_heat()) return facts;
  facts.mean = mean_temperature(scene, state);
  facts.lowest = glass.temperature.minCoeff();
  facts.highest = glass.temperature.maxCoeff();
  facts.energy_imbalance = energy_imbalance(scene, state);
  return facts;
}

double energy_imbalance(const Scene& scene, const State& state, Index tool) {
  const ToolState& body = state.tools[tool];
  const thermal::BodyView view = body_view(scene, state, body_of_tool(tool), body.mesh);
  const double change =
      thermal::heat_content(view, scene.geometry, body.temperature) -
      thermal::heat_content(view, scene.geometry, start_temperature(scene, body_of_tool(tool), body.mesh));
  const double given = std::accumulate(body.heat_through.begin(), body.heat_through.end(), 0.0);
  return relative_to_heat_lost(state, change - body.heat_received + given);
}

HistoryRow history_row(const Scene& scene, const State& state, const StepReport& report) {
  const GlassFacts facts = glass_facts(scene, state);
  HistoryRow row;
  row.time = state.time;
  row.stage = scene.stages.at(state.stage).name;
  row.dt = report.dt;
  row.volume = facts.volume;
  row.glass_mean = facts.mean;
  row.heat_to_tools = state.totals.to_tools;
  row.heat_to_air = state.totals.to_air;
  row.dissipation = state.totals.dissipation;
  row.energy_imbalance = facts.energy_imbalance;
  const bool has_contact_state = scene.has_flow() && !state.glass.contact_tool.empty();
  row.contact_area = has_contact_state ? active_contact_area(scene, state) : weighted_contact_area(report.interface);
  row.shape = glass_shape(scene, state);
  row.coupling_iterations = report.coupling_iterations;
  row.flow_solves = report.flow_solves;
  row.contact_changes = report.contact_changes;
  row.heat_substeps = report.heat_substeps;
  row.limited_by = step_limits[static_cast<std::size_t>(report.limit)];
  for (std::size_t tool = 0; tool < scene.tools.size(); ++tool) {
    row.tool_force.push_back(state.tools[tool].end_force);
    row.tool_position.push_back(state.tools[tool].offset);
    row.tool_speed.push_back(state.tools[tool].velocity);
  }
  for (std::size_t probe = 0; probe < scene.probes.size(); ++probe)
    row.probe.push_back(probe_temperature(scene, state, probe));
  if (seals_cavities(scene)) row.cavities = cavity_report(scene, state);
  return row;
}

std::string history_header(const Scene& scene) {
  std::string line =
      "time_s,stage,dt_s,volume_mm3,glass_mean_degC,heat_to_tools_J,heat_to_air_J,dissipation_J,energy_imbalance,"
      "contact_area_mm2,lowest_mm,highest_mm,length_mm,sag_mm,skin_mean_degC,skin_min_degC,skin_viscosity_Pa_s";
  for (const Tool& tool : scene.tools) line += ',' + core::csv_text(tool.name + "_force_N");
  for (const Tool& tool : scene.tools) line += ',' + core::csv_text(tool.name + "_position_mm");
  for (const Tool& tool : scene.tools) line += ',' + core::csv_text(tool.name + "_speed_mm_s");
  for (const Probe& probe : scene.probes) line += ',' + core::csv_text(probe.name + "_degC");
  if (seals_cavities(scene)) line += ",cavities,cavity_volumes_mm3,cavity_pressures_Pa,cavity_masses_kg";
  return line + ",coupling_iterations,flow_solves,contact_changes,heat_substeps,limited_by\n";
}

std::string history_line(const HistoryRow& row) {
  const auto celsius = [](double kelvin) { return kelvin - thermal::content_reference; };
  std::string line = fmt::format("{:.12g},{}", row.time, core::csv_text(row.stage));
  for (const double value : {row.dt, 1e9 * row.volume, celsius(row.glass_mean), row.heat_to_tools, row.heat_to_air,
                             row.dissipation, row.energy_imbalance, 1e6 * row.contact_area, 1e3 * row.shape.low,
                             1e3 * row.shape.high, 1e3 * (row.shape.high - row.shape.low), 1e3 * row.sag,
                             celsius(row.shape.skin_mean), celsius(row.shape.skin_min), row.shape.skin_viscosity})
    line += fmt::format(",{:.10g}", value);
  for (const double value : row.tool_force) line += fmt::format(",{:.10g}", value);
  for (const double value : row.tool_position) line += fmt::format(",{:.10g}", 1e3 * value);
  for (const double value : row.tool_speed) line += fmt::format(",{:.10g}", 1e3 * value);
  for (const double value : row.probe) line += fmt::format(",{:.10g}", celsius(value));
  if (row.cavities)
    line += fmt::format(",{},{:.10g},{:.10g},{:.10g}", row.cavities->size(),
                        fmt::join(in_cubic_millimetres(row.cavities->volume), " "),
                        fmt::join(row.cavities->pressure, " "), fmt::join(row.cavities->mass, " "));
  for (const Index count : {row.coupling_iterations, row.flow_solves, row.contact_changes, row.heat_substeps})
    line += fmt::format(",{}", count);
  return line + ',' + row.limited_by + '\n';
}

}  // namespace parison::forming
