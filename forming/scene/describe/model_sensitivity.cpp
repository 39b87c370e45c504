// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/describe/model_sensitivity.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "forming/scene/calibration.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "thermal/radiation/planck.hpp"

namespace parison::forming {
namespace {

constexpr double earth = 9.81;  ///< m/s2
const ContainerGlass container_glass;

/// What was measured of a part, by its name.
const MeasuredPart& measured(const char* part) {
  return calibration().model_parts.parts.at(part);
}

double lasting(const Scene& scene) {
  double whole = 0;
  for (const Stage& stage : scene.stages) whole += stage.duration;
  return whole;
}

double max_pressure(const Stage& stage) {
  double highest = 0;
  for (const auto& entry : stage.pressure) highest = std::max(highest, entry.second.max_size());
  return highest;
}

bool has_moving_tools(const Stage& stage) {
  return std::any_of(stage.tools.begin(), stage.tools.end(), [](const StageTool& tool) { return fastest(tool) > 0; });
}

/// What a stress would strain hot glass in a time.
double hot_strain(double stress, double time, double viscosity) {
  return stress * time / (3 * viscosity);
}

/// What shapes the glass last.
enum class Shaped { blown, pressed, unformed };

Shaped shaped(const Scene& scene, const DimensionlessNumbers& numbers) {
  constexpr double noticed = 0.3;  // strain that a pressure would make in hot glass
  Shaped shape = Shaped::unformed;
  if (!scene.has_flow()) return shape;
  for (const Stage& stage : scene.stages) {
    if (has_moving_tools(stage)) shape = Shaped::pressed;
    if (hot_strain(max_pressure(stage), stage.duration, *numbers.viscosity) > noticed) shape = Shaped::blown;
  }
  return shape;
}

struct Estimator {
  const Scene& scene;
  DimensionlessNumbers numbers;
  Shaped shape;
  double freedom;  ///< over the jar's, of the wall or the shape to change
  std::vector<PartSensitivity> parts;

  void add(const char* name, bool in_scene, const char* number_name, double number, double thickness, double heat) {
    parts.push_back({name, in_scene, number_name, number, scene.has_flow() ? std::min(1.0, thickness) : 0,
                     scene.has_heat() ? std::min(1.0, heat) : 0});
  }
  void scale(const char* name, bool in_scene, const char* number_name, double number, const MeasuredPart& jar) {
    const double ratio = number / jar.number;
    add(name, in_scene, number_name, number, freedom * ratio * jar.thickness, ratio * jar.heat);
  }
};

double weight(const Estimator& e) {
  return e.scene.glass.flow->density * earth * e.numbers.length;
}

/// Glass that nothing forms changes its shape no more than its weight draws it out.
double freedom_of(const Estimator& e) {
  if (e.shape == Shaped::pressed) return calibration().model_shapes.pressed_freedom;
  if (e.shape == Shaped::blown || !e.scene.has_flow()) return 1;
  return std::min(1.0, hot_strain(weight(e), lasting(e.scene), *e.numbers.viscosity));
}

/// The shortest stage in which a tool or a pressure drives the glass; the whole run where none does.
double quickest_drive(const Scene& scene) {
  double quickest = lasting(scene);
  for (const Stage& stage : scene.stages)
    if (max_pressure(stage) > 0 || has_moving_tools(stage)) quickest = std::min(quickest, stage.duration);
  return quickest;
}

void add_friction(Estimator& e) {
  double slipping = 0, placed = 0;
  for (std::size_t i = 0; i < e.scene.tools.size(); ++i) {
    if (active_time(e.scene, i) == 0) continue;
    ++placed;
    slipping += e.scene.tools[i].friction.law == flow::Friction::Law::slip;
  }
  if (placed == 0) return;
  if (slipping > 0)
    e.scale("friction on tools", false, "share of tools that slip", slipping / placed, measured("friction on tools"));
  else
    e.scale("friction on tools", true, "share of tools with friction", 1, measured("friction on tools"));
}

/// A stress that acts in addition to those that form the glass.
void add_stress(Estimator& e, const char* name, bool in_scene, double stress, const MeasuredPart& jar) {
  const double strain = hot_strain(stress, lasting(e.scene), *e.numbers.viscosity);
  constexpr const char* number_name = "its stress times duration over viscosity";
  if (e.shape == Shaped::unformed)
    return e.add(name, in_scene, number_name, strain, strain, calibration().model_shapes.heat_of_strain * strain);
  // The loads that form the jar, and its cooling, suppress most of the strain. Where only a pressure forms the glass,
  // the stress is also compared with that pressure.
  double pressure = 0;
  for (const Stage& stage : e.scene.stages) pressure = std::max(pressure, max_pressure(stage));
  const double ratio = strain / jar.number, relative_stress = e.shape == Shaped::blown ? stress / pressure : 0;
  e.add(name, in_scene, number_name, strain,
        std::min(strain, e.freedom * std::max(ratio * jar.thickness, relative_stress)), ratio * jar.heat);
}

void add_flow(Estimator& e) {
  const auto& flow = *e.scene.glass.flow;
  const bool tense = flow.surface_tension > 0;
  const bool heavy =
      std::any_of(e.scene.stages.begin(), e.scene.stages.end(), [](const Stage& s) { return s.gravity != 0; });
  add_stress(e, "surface tension", tense,
             (tense ? flow.surface_tension : container_glass.surface_tension) / e.numbers.length,
             measured("surface tension"));
  add_stress(e, "gravity", heavy, weight(e), measured("gravity"));
  add_friction(e);
  // Inertia delays the flow by the time in which the slowest motion across a wall dies out, here a
  // slab held on both sides; no run measures what that changes at most.
  const double across = e.numbers.length / M_PI;
  const double delay = flow.density * across * across / (*e.numbers.viscosity * quickest_drive(e.scene));
  e.add("inertia", false, "its delay over the shortest drive", delay, e.freedom * delay, 0);
  e.parts.back().in_the_model = false;
}

/// Parts that act through the heat between glass and tools; for glass that nothing forms the exact solution itself
/// is the estimate.
void add_exchange(Estimator& e, const char* name, bool in_scene, double more_heat, const MeasuredPart& jar) {
  constexpr const char* number_name = "change of the heat between half-spaces";
  if (e.shape != Shaped::unformed) return e.scale(name, in_scene, number_name, more_heat, jar);
  e.add(name, in_scene, number_name, more_heat, e.freedom * more_heat / jar.number * jar.thickness, more_heat);
}

/// Whether the scene gives the surroundings of the glass.
bool has_air(const Stage& stage) {
  const thermal::SurfaceExchange unsaid;
  const auto differ = [](const core::TimeFunction& a, const core::TimeFunction& b) {
    return a.min() != b.min() || a.max() != b.max();
  };
  return stage.air.h.max() > 0 || differ(stage.air.air_temperature, unsaid.air_temperature) ||
         differ(stage.air.ambient_temperature, unsaid.ambient_temperature);
}

/// Parts that act on the open surface; their heat grows with the time.
void add_surface(Estimator& e, double conductivity) {
  double h = 0, air = 0, around = 0;
  bool open = false;
  for (const Stage& stage : e.scene.stages) {
    if (!has_air(stage)) continue;
    open = true;
    h = std::max(h, stage.air.h.max());
    air = stage.air.air_temperature.min(), around = stage.air.ambient_temperature.min();
  }
  if (!open) return;
  const double hot = e.scene.glass.initial_temperature, lasts = lasting(e.scene) / calibration().model_parts.duration;
  const auto cooling = [&](const char* name, bool in_scene, double flux, MeasuredPart jar) {
    jar.heat *= lasts * (e.shape == Shaped::pressed ? calibration().model_shapes.pressed_open_heat : 1);
    e.scale(name, in_scene, "its Biot number", std::abs(flux) * e.numbers.length / (conductivity * hot), jar);
  };
  const bool emits = e.scene.glass.emissivity > 0;
  cooling("surface radiation", emits,
          4 * thermal::stefan_boltzmann * (emits ? e.scene.glass.emissivity : container_glass.emissivity) *
              (std::pow(hot, 4) - std::pow(around, 4)),
          measured("surface radiation"));
  cooling("cooling by air", h > 0, (h > 0 ? h : container_glass.air) * (hot - air), measured("cooling by air"));
}

void add_heat(Estimator& e) {
  const auto& radiation = e.scene.glass.thermal->radiation;
  const auto [alone, limited, unlimited] = conductivities(e.scene, e.numbers.length);
  const double own = !thermal::is_rosseland(*e.scene.glass.thermal) ? alone
                     : radiation->thin_wall                         ? limited
                                                                    : unlimited;
  if (!e.scene.tools.empty()) {
    const double more = heat_gain(e.scene, {limited}, {alone});
    // Of the heat that the scene gives: what it would lose without, or gain with.
    add_exchange(e, "internal radiation", radiation.has_value(), radiation ? more / (1 + more) : more,
                 measured("internal radiation"));
    if (thermal::is_rosseland(*e.scene.glass.thermal))
      add_exchange(e, "thin-wall limit", radiation->thin_wall, heat_gain(e.scene, {unlimited}, {limited}),
                   measured("thin-wall limit"));
    add_exchange(e, "warming of tools", true, heat_gain(e.scene, {own, true}, {own}), measured("warming of tools"));
  }
  add_surface(e, alone);
}

}  // namespace

std::vector<PartSensitivity> model_sensitivity(const Scene& scene) {
  const DimensionlessNumbers numbers = dimensionless_numbers(scene);
  Estimator estimator{scene, numbers, shaped(scene, numbers), 1, {}};
  estimator.freedom = freedom_of(estimator);
  if (scene.has_flow()) add_flow(estimator);
  if (scene.has_heat()) add_heat(estimator);
  return std::move(estimator.parts);
}

std::string describe_sensitivity(const Scene& scene) {
  const auto parts = model_sensitivity(scene);
  if (parts.empty()) return {};
  std::string text =
      "\nparts of the model with the number that governs each (`parison tradeoff CASE --parts` runs the case with and "
      "without "
      "each)\n";
  for (const PartSensitivity& part : parts)
    text += fmt::format("  {:<20}{:<11}{} {:.2g}\n", part.name, part.in_scene ? "in" : "neglected", part.number_name,
                        part.number);
  constexpr double noticed = 0.01;
  for (const PartSensitivity& part : parts)
    if (!part.in_the_model && part.number > noticed)
      text += fmt::format("  warning: {} is neglected and no run can tell what it changes; {} is {:.2g}\n", part.name,
                          part.number_name, part.number);
  return text;
}

}  // namespace parison::forming
