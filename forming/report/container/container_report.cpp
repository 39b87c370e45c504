// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/container/container_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/math/numbers.hpp"
#include "forming/report/files/history.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/container/hollow.hpp"
#include "forming/step/balance/cold_glass.hpp"

namespace parison::forming {
namespace {

/// The surface of a mesh as straight lines between its nodes.
core::Profile surface_of(const core::Mesh& mesh) {
  core::Profile profile;
  for (const auto& edge : mesh.boundary_edges()) {
    const Point a = mesh.nodes[edge.nodes[0]], b = mesh.nodes[edge.nodes[1]], middle = mesh.nodes[edge.nodes[2]];
    profile.segments.push_back({a, middle});
    profile.segments.push_back({middle, b});
  }
  return profile;
}

/// The end of a surface against gravity, m along the axis; `up` is 1 where it stands along the axis, -1 against it.
double highest_place(const core::Profile& surface, int up) {
  double highest = -HUGE_VAL;
  for (const core::Segment& segment : surface.segments) highest = std::max(highest, up * segment.start[1]);
  return up * highest;
}

OuterSize size_of(const core::Profile& surface) {
  double radius = 0;
  for (const core::Segment& segment : surface.segments) radius = std::max(radius, segment.start[0]);
  return {highest_place(surface, 1) - highest_place(surface, -1), 2 * radius};
}

void add_optional(core::JsonWriter& json, const char* key, const std::optional<double>& value, double unit) {
  if (value) json.add(key, *value / unit);
}

void add_volumes(core::JsonWriter& json, const std::optional<double>& capacity, const std::optional<double>& filled) {
  add_optional(json, "capacity_ml", capacity, core::millilitre);
  add_optional(json, "to_fill_level_ml", filled, core::millilitre);
  if (capacity && filled) json.add("ullage_ml", (*capacity - *filled) / core::millilitre);
}

void add_size(core::JsonWriter& json, const OuterSize& size) {
  json.add("height_mm", size.height / core::millimetre);
  json.add("diameter_mm", size.diameter / core::millimetre);
}

std::string millilitres(double volume) {
  return figures(volume / core::millilitre, 2);
}

/// The mesh of the glass as it would be cold, against that of the run's end; it stands as `up` says.
ColdContainer cold_container(const Scene& scene, const core::Mesh& hot, const core::Mesh& cold, int up) {
  const core::Profile surface = surface_of(cold);
  ColdContainer container{
      size_of(surface), std::cbrt(core::volume(hot, scene.geometry) / core::volume(cold, scene.geometry)) - 1, {}, {}};
  const auto glass = slices_of({&surface, {true}, 0});
  const auto hollow = glass ? hollow_of(*glass, up) : std::nullopt;
  if (!hollow) return container;
  container.capacity = hollow->capacity;
  if (const auto level = scene.output.fill_level) container.filled = hollow->to_depth(*level);
  return container;
}

/// Whether a volume of the container is not that of the drawings, by a share that is worth a word.
bool differs(double volume, const std::optional<double>& drawn) {
  constexpr double notable = 1e-3;
  return drawn && std::abs(volume / *drawn - 1) > notable;
}

void add_cold(core::JsonWriter& json, const ContainerReport& report) {
  if (!report.cold) return;
  json.open_object("cold");
  add_volumes(json, report.cold->capacity, report.cold->filled);
  add_size(json, report.cold->size);
  json.add("contraction", report.cold->contraction);
  json.close();
}

/// What the table of results says about the cold container; empty without one that holds something.
std::string cold_text(const ContainerReport& report) {
  if (!report.cold || !report.cold->capacity) return "";
  const OuterSize &hot = report.size, &cold = report.cold->size;
  return fmt::format(
      "; {:.5g} mm high and {:.4g} mm wide, at 20 degC {:.5g} and {:.4g} mm, {} ml, contraction {:.2f} %",
      hot.height / core::millimetre, hot.diameter / core::millimetre, cold.height / core::millimetre,
      cold.diameter / core::millimetre, millilitres(*report.cold->capacity), 100 * report.cold->contraction);
}

}  // namespace

std::optional<ContainerReport> container_report(const Scene& scene, const State& state, bool is_wall) {
  const auto& plan = scene.container;
  const double gravity = scene.stages.back().gravity;
  if (!plan || !(plan->capacity || is_wall)) return {};
  ContainerReport report;
  report.weight = glass_facts(scene, state).mass;
  if (gravity == 0) {
    report.absent = "not computed: the last stage has no gravity, so it is not known which way up the container stands";
    return report;
  }
  const int up = gravity > 0 ? -1 : 1;
  const core::Profile surface = surface_of(state.glass.mesh);
  report.size = size_of(surface);
  const auto glass = slices_of({&surface, {true}, 0});
  const auto hollow = glass ? hollow_of(*glass, up) : std::nullopt;
  if (hollow) {
    report.rim = hollow->rim;
    report.capacity = hollow->capacity;
    const double sunk = plan->rim ? up * (*plan->rim - hollow->rim) : 0;
    if (const auto below = hollow->to_depth(std::abs(sunk)))  // above the rim the mouth is as wide as below it
      report.to_drawn_rim = sunk > 0 ? 2 * hollow->capacity - *below : *below;
    if (const auto level = scene.output.fill_level) report.filled = hollow->to_depth(*level);
  } else {
    report.rim = highest_place(surface, up);
    report.absent =
        "not computed: as the glass stands, no hollow was found that would hold a liquid; it is open below, or its "
        "wall too thin or its mesh too fine to tell";
  }
  if (const auto cold = cold_glass(scene, state)) report.cold = cold_container(scene, state.glass.mesh, *cold, up);
  if (plan->press && plan->press->is_driven && state.stage >= plan->press->stage)
    report.plunger_stop = state.tools[plan->press->tool].offset;
  return report;
}

void add_container(core::JsonWriter& json, const Scene& scene, const State& state, bool is_wall) {
  const auto report = container_report(scene, state, is_wall);
  if (!report) return;
  json.open_object("container");
  json.add("weight_g", 1e3 * report->weight);
  json.add("rim_mm", report->rim / core::millimetre);
  if (report->size.height > 0) add_size(json, report->size);
  add_volumes(json, report->capacity, report->filled);
  if (!report->absent.empty()) json.add("capacity_absent", report->absent);
  add_optional(json, "plunger_stop_mm", report->plunger_stop, core::millimetre);
  add_optional(json, "fill_level_mm", scene.output.fill_level, core::millimetre);
  add_cold(json, *report);
  const ContainerPlan& plan = *scene.container;
  json.open_object("from_drawings");
  json.add("weight_g", 1e3 * plan.mass);
  add_volumes(json, plan.capacity, plan.filled);
  if (plan.press) json.add("press_cavity_ml", plan.press->cavity / core::millilitre);
  if (plan.press) json.add("plunger_stop_mm", plan.press->stop / core::millimetre);
  add_optional(json, "mould_ml", plan.outside, core::millilitre);
  json.close();
  json.close();
}

std::string capacity_text(const Scene& scene, const State& state, bool is_wall) {
  const auto report = container_report(scene, state, is_wall);
  if (!report) return "";
  if (!report->capacity) return report->absent;
  const ContainerPlan& plan = *scene.container;
  std::string text = fmt::format("{} ml to the rim", millilitres(*report->capacity));
  const bool is_as_drawn = !differs(*report->capacity, plan.capacity);
  if (!is_as_drawn)
    text += fmt::format(" at {} mm, drawn {} ml at {} mm", place_in_mm(report->rim), millilitres(*plan.capacity),
                        place_in_mm(*plan.rim));
  if (!report->filled) return text + cold_text(*report);
  text += fmt::format("{} {} ml to {:.4g} mm below it", is_as_drawn ? "," : ";", millilitres(*report->filled),
                      *scene.output.fill_level / core::millimetre);
  if (differs(*report->filled, plan.filled)) text += fmt::format(", drawn {} ml", millilitres(*plan.filled));
  return text + cold_text(*report);
}

}  // namespace parison::forming
