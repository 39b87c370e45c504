// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/describe/dimensionless_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/erfcx.hpp"
#include "forming/scene/describe/model_sensitivity.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {

namespace {

double effusivity(const thermal::Material& material, double temperature, double conductivity) {
  return std::sqrt(conductivity * material.density * material.heat_capacity(temperature));
}

/// Heat over 1 K that two half-spaces exchange through h in a time, over h, s; `resistance` is the sum of 1 over their
/// effusivities.
double exchanged(double h, double resistance, double time) {
  const double H = h * resistance, x = H * std::sqrt(time);
  if (x < 1e-3) return time * (1 - 4 * x / (3 * std::sqrt(M_PI)));  // else cancelled away
  return (core::erfcx(x) - 1 + 2 * x / std::sqrt(M_PI)) / (H * H);
}

double max_conductance(const Scene& scene, std::size_t tool) {
  double h = 0;
  for (const Interface& interface : scene.interfaces)
    if (interface.tool == static_cast<Index>(tool)) h = std::max(h, contact::highest(interface.law));
  return h;
}

}  // namespace

double active_time(const Scene& scene, std::size_t tool) {
  double time = 0;
  for (const Stage& stage : scene.stages)
    for (const StageTool& placed : stage.tools)
      if (placed.tool == static_cast<Index>(tool)) time += stage.duration;
  return time;
}

Conductivities conductivities(const Scene& scene, double length) {
  thermal::Material material = *scene.glass.thermal;
  const double hot = scene.glass.initial_temperature, alone = material.conductivity(hot);
  if (!thermal::is_rosseland(material)) material.radiation = ContainerGlass{}.radiation;
  material.radiation->thin_wall = true;
  return {alone, thermal::conductivity(material, hot, thermal::thin_wall_factor(*material.radiation, length)),
          thermal::conductivity(material, hot, 1)};
}

double heat_gain(const Scene& scene, const HalfSpaces& more, const HalfSpaces& less) {
  const double hot = scene.glass.initial_temperature;
  double most = 0;
  for (std::size_t i = 0; i < scene.tools.size(); ++i) {
    const Tool& tool = scene.tools[i];
    const double h = max_conductance(scene, i), time = active_time(scene, i), cold = tool.initial_temperature;
    if (!tool.thermal || h == 0 || time == 0) continue;
    const double warming = 1 / effusivity(*tool.thermal, cold, tool.thermal->conductivity(cold));
    const auto heat = [&](const HalfSpaces& pair) {
      return exchanged(
          h, 1 / effusivity(*scene.glass.thermal, hot, pair.conductivity) + (pair.isothermal ? 0 : warming), time);
    };
    most = std::max(most, heat(more) / heat(less) - 1);
  }
  return most;
}

namespace {

/// Length of the outline without symmetry boundaries, m.
double surface_length(const Body& body) {
  double total = 0;
  for (const core::Segment& segment : body.profile.segments)
    if (body.boundaries.at(segment.boundary_id).kind != BoundaryKind::symmetry) total += core::length(segment);
  return total;
}

/// m/s: the fastest tool, else what the highest pressure or the weight makes of the viscous glass over the length. A
/// pressure drives glass between tools as through a pipe (Poiseuille) as wide as that length and as long as the glass.
std::optional<double> flow_speed(const Scene& scene, double length, double viscosity) {
  if (!scene.has_flow()) return {};
  const double in_pipe = length / (32 * core::size(scene.glass.profile));
  double tool = 0, stress = 0;
  for (const Stage& stage : scene.stages) {
    for (const StageTool& stage_tool : stage.tools) tool = std::max(tool, fastest(stage_tool));
    for (const auto& entry : stage.pressure)
      stress = std::max(stress, entry.second.max_size() * (stage.tools.empty() ? 1 : in_pipe));
    stress = std::max(stress, scene.glass.flow->density * std::abs(stage.gravity) * length);
  }
  if (tool > 0) return tool;
  if (stress > 0) return stress * length / viscosity;
  return {};
}

/// W/m2/K: of the interfaces, else of the air.
std::optional<double> exchange(const Scene& scene) {
  double h = 0;
  for (const Interface& interface : scene.interfaces) h = std::max(h, contact::highest(interface.law));
  if (h == 0)
    for (const Stage& stage : scene.stages) h = std::max(h, stage.air.h.max());
  if (h > 0) return h;
  return {};
}

/// From the glass to the coldest thing around it at the start, K.
std::optional<double> temperature_span(const Scene& scene) {
  double min_temperature = scene.glass.initial_temperature;
  for (const Tool& tool : scene.tools)
    if (tool.thermal) min_temperature = std::min(min_temperature, tool.initial_temperature);
  for (const Stage& stage : scene.stages)
    if (stage.air.h.max() > 0) min_temperature = std::min(min_temperature, stage.air.air_temperature.min());
  const double span = scene.glass.initial_temperature - min_temperature;
  if (span > 0) return span;
  return {};
}

void add_heat_numbers(const Scene& scene, DimensionlessNumbers& numbers) {
  const thermal::Material& material = *scene.glass.thermal;
  const double hot = scene.glass.initial_temperature;
  const double wall = thermal::is_rosseland(material) && material.radiation->thin_wall
                          ? thermal::thin_wall_factor(*material.radiation, numbers.length)
                          : 1.0;
  const double conductivity = thermal::conductivity(material, hot, wall);
  const double diffusivity = conductivity / (material.density * material.heat_capacity(hot));
  if (const auto h = exchange(scene)) numbers.biot = *h * numbers.length / conductivity;
  if (!numbers.speed) return;
  numbers.peclet = *numbers.speed * numbers.length / diffusivity;
  if (const auto span = temperature_span(scene))
    numbers.brinkman = *numbers.viscosity * *numbers.speed * *numbers.speed / (conductivity * *span);
}

}  // namespace

double outline_volume(const core::Profile& profile, core::Geometry geometry) {
  if (geometry == core::Geometry::planar) return std::abs(core::signed_area(profile));
  constexpr int chords = 256;
  double volume = 0;
  for (const core::Segment& segment : profile.segments)
    for (int i = 0; i < chords; ++i) {
      const core::Point a = core::point_at(segment, double(i) / chords),
                        b = core::point_at(segment, double(i + 1) / chords);
      volume += M_PI / 3 * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) * (b[1] - a[1]);
    }
  return std::abs(volume);
}

double fastest(const StageTool& tool) {
  if (const auto* force = std::get_if<ForceMotion>(&tool.motion)) return force->speed_limit.max();
  double speed = 0;
  if (const auto* position = std::get_if<PositionMotion>(&tool.motion))
    for (std::size_t i = 1; i < position->offset.x.size(); ++i)
      speed = std::max(speed, std::abs((position->offset.y[i] - position->offset.y[i - 1]) /
                                       (position->offset.x[i] - position->offset.x[i - 1])));
  return speed;
}

DimensionlessNumbers dimensionless_numbers(const Scene& scene) {
  DimensionlessNumbers numbers;
  numbers.volume = outline_volume(scene.glass.profile, scene.geometry);
  numbers.mass = numbers.volume * (scene.has_flow() ? scene.glass.flow->density : scene.glass.thermal->density);
  numbers.length = 2 * std::abs(core::signed_area(scene.glass.profile)) / surface_length(scene.glass);
  if (scene.has_flow()) {
    const flow::Material& material = *scene.glass.flow;
    numbers.viscosity = material.viscosity(scene.glass.initial_temperature);
    numbers.speed = flow_speed(scene, numbers.length, *numbers.viscosity);
    if (numbers.speed) {
      numbers.reynolds = material.density * *numbers.speed * numbers.length / *numbers.viscosity;
      if (material.surface_tension > 0)
        numbers.capillary = *numbers.viscosity * *numbers.speed / material.surface_tension;
    }
  }
  if (scene.has_heat()) add_heat_numbers(scene, numbers);
  return numbers;
}

}  // namespace parison::forming
