// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/left_out.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "forming/scene/checkup.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {
namespace {

constexpr double stefan_boltzmann = 5.670374419e-8;  ///< W/m2/K4
constexpr double earth = 9.81;                       ///< m/s2
/// Container glass, as the bundled jar has it.
constexpr double usual_tension = 0.315, usual_emissivity = 0.89;
constexpr thermal::Radiation usual_radiation{1.518, 150, true};

/// What a part did in the ladder of the jar (draft coarser 1.4), and the number it had there.
struct Measured {
  double number, thickness, heat;
};
constexpr Measured radiation_measured{0.89, 0.201, 0.213};
constexpr Measured emission_measured{13, 0.085, 0.062};
constexpr Measured warming_measured{0.42, 0.053, 0.062};
constexpr Measured tension_measured{3.2e-4, 0.012, 5e-4};
constexpr Measured gravity_measured{0.019, 0.156, 0.013};

PartEstimate scaled(const char* name, bool in_scene, const char* number_name, double number, const Measured& jar) {
  const double ratio = number / jar.number;
  return {name, in_scene, number_name, number, std::min(1.0, ratio * jar.thickness), std::min(1.0, ratio * jar.heat)};
}

/// The stress that forms the glass: pressure and weight, Pa; tools come with whatever force they need.
double forming_stress(const Scene& scene, double length) {
  double stress = scene.glass.flow->density * earth * length;
  for (const Stage& stage : scene.stages)
    for (const auto& entry : stage.pressure) stress = std::max(stress, std::abs(entry.second));
  return stress;
}

void add_flow(const Scene& scene, const SceneNumbers& numbers, std::vector<PartEstimate>& parts) {
  const auto& flow = *scene.glass.flow;
  const double stress = forming_stress(scene, numbers.length);
  const double tension = flow.surface_tension > 0 ? flow.surface_tension : usual_tension;
  parts.push_back(scaled("surface tension", flow.surface_tension > 0, "tension over forming stress",
                         tension / (stress * numbers.length), tension_measured));
  const bool weight = std::any_of(scene.stages.begin(), scene.stages.end(), [](const Stage& s) { return s.gravity != 0; });
  parts.push_back(scaled("gravity", weight, "weight over forming stress",
                         flow.density * earth * numbers.length / stress, gravity_measured));
  // Inertia delays the flow by the time in which the slowest motion across a wall dies out, here a
  // slab held on both sides; no run measures what that changes at most.
  const auto quickest = std::min_element(scene.stages.begin(), scene.stages.end(),
                                         [](const Stage& a, const Stage& b) { return a.duration < b.duration; });
  const double across = numbers.length / M_PI;
  const double delay = flow.density * across * across / (*numbers.viscosity * quickest->duration);
  parts.push_back({"inertia", false, "its delay over the shortest stage", delay, std::min(1.0, delay), 0});
}

double effusivity(const thermal::Material& material, double temperature, double conductivity) {
  return std::sqrt(conductivity * material.density * material.heat_capacity(temperature));
}

/// Share of the way to the glass's temperature by which a tool's surface warms in perfect contact: two half-spaces.
double warming(const Scene& scene, double glass_conductivity) {
  const double hot = scene.glass.initial_temperature, glass = effusivity(*scene.glass.thermal, hot, glass_conductivity);
  double most = 0;
  for (const Tool& tool : scene.tools)
    if (tool.thermal) {
      const double cold = tool.initial_temperature;
      most = std::max(most, glass / (glass + effusivity(*tool.thermal, cold, tool.thermal->conductivity(cold))));
    }
  return most;
}

void add_heat(const Scene& scene, const SceneNumbers& numbers, std::vector<PartEstimate>& parts) {
  thermal::Material material = *scene.glass.thermal;
  const double hot = scene.glass.initial_temperature;
  const bool radiates = material.radiation.has_value(), emits = scene.glass.emissivity > 0;
  const double alone = material.conductivity(hot);
  if (!radiates) material.radiation = usual_radiation;
  const double wall = material.radiation->thin_wall ? thermal::thin_wall_factor(*material.radiation, numbers.length) : 1.0;
  const double both = thermal::conductivity(material, hot, wall);
  parts.push_back(scaled("internal radiation", radiates, "its share of the conductivity", 1 - alone / both,
                         radiation_measured));
  const double emissivity = emits ? scene.glass.emissivity : usual_emissivity;
  parts.push_back(scaled("emission to around", emits, "its Biot number",
                         4 * emissivity * stefan_boltzmann * hot * hot * hot * numbers.length / alone, emission_measured));
  if (scene.tools.empty()) return;
  const double share = warming(scene, radiates ? both : alone);
  parts.push_back(scaled("warming of tools", share > 0, "share of the way to the glass", share, warming_measured));
}

}  // namespace

std::vector<PartEstimate> estimate_parts(const Scene& scene) {
  const SceneNumbers numbers = scene_numbers(scene);
  std::vector<PartEstimate> parts;
  if (scene.has_flow()) add_flow(scene, numbers, parts);
  if (scene.has_heat()) add_heat(scene, numbers, parts);
  return parts;
}

std::string describe_parts(const Scene& scene) {
  const auto parts = estimate_parts(scene);
  if (parts.empty()) return {};
  const double asked = scene.accuracy_choice.target.value_or(expected_error(scene.accuracy_choice.level));
  std::string text = "\nwhat a part of the model changes, estimated from the bundled jar's ladder by one number\n";
  for (const PartEstimate& part : parts) {
    text += fmt::format("  {:<20}{:<9}thickness {:>6.2g} %, heat {:>6.2g} %   {} {:.2g}\n", part.name,
                        part.in_scene ? "in" : "left out", scene.has_flow() ? 100 * part.thickness : 0.0,
                        scene.has_heat() ? 100 * part.heat : 0.0, part.number_name, part.number);
  }
  for (const PartEstimate& part : parts) {
    const double change = std::max(scene.has_flow() ? part.thickness : 0, scene.has_heat() ? part.heat : 0);
    if (!part.in_scene && change > asked)
      text += fmt::format("  warning: {} is left out and may change the result by up to {:.2g} %, more than the {:.2g} % asked for\n",
                          part.name, 100 * change, 100 * asked);
  }
  return text;
}

}  // namespace parison::forming
