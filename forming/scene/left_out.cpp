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
/// Container glass and its surroundings, as the bundled jar has them.
constexpr double usual_tension = 0.315, usual_emissivity = 0.89, usual_air = 20;
constexpr thermal::Radiation usual_radiation{1.518, 150, true};

/// What a part did in the ladder of the jar at draft, and the number it had there.
struct Measured {
  double number, thickness, heat;
};
constexpr Measured radiation_measured{0.89, 0.234, 0.211};
constexpr Measured thin_wall_measured{0.28, 0.105, 0.125};
constexpr Measured emission_measured{13, 0.086, 0.063};
constexpr Measured air_measured{0.44, 0.0135, 0.0093};
constexpr Measured warming_measured{0.62, 0.055, 0.063};
constexpr Measured tension_measured{0.19, 0.0073, 3.7e-4};
constexpr Measured gravity_measured{11, 0.159, 0.0128};
constexpr Measured slip_measured{1, 0.27, 0.035};
/// Tools on both sides leave the wall little freedom and cover it: what changes it, and the heat of its open surface, in the ladder
/// of the tumbler over those of the jar.
constexpr double pressed_share = 0.02, pressed_open = 0.1;
/// Heat into the tools over the strain of glass that nothing forms, in the README's short example.
constexpr double heat_of_strain = 0.008;

/// Who gives the glass its last shape.
enum class Shaped { blown, pressed, unformed };

Shaped shaped(const Scene& scene) {
  const auto any = [&](auto has) { return std::any_of(scene.stages.begin(), scene.stages.end(), has); };
  if (any([](const Stage& stage) {
        return std::any_of(stage.pressure.begin(), stage.pressure.end(), [](const auto& entry) { return entry.second != 0; });
      }))
    return Shaped::blown;
  const auto moves = [](const StageTool& tool) { return !std::holds_alternative<std::monostate>(tool.motion); };
  if (any([&](const Stage& stage) { return std::any_of(stage.tools.begin(), stage.tools.end(), moves); })) return Shaped::pressed;
  return Shaped::unformed;
}

struct Estimator {
  const Scene& scene;
  SceneNumbers numbers;
  Shaped shape;
  std::vector<PartEstimate> parts;

  void add(const char* name, bool in_scene, const char* number_name, double number, double thickness, double heat) {
    const double free = !scene.has_flow() ? 0 : shape == Shaped::pressed ? pressed_share : 1;
    parts.push_back({name, in_scene, number_name, number, std::min(1.0, free * thickness), scene.has_heat() ? std::min(1.0, heat) : 0});
  }
  void scale(const char* name, bool in_scene, const char* number_name, double number, const Measured& jar) {
    const double ratio = number / jar.number;
    add(name, in_scene, number_name, number, ratio * jar.thickness, ratio * jar.heat);
  }
};

double lasting(const Scene& scene) {
  double whole = 0;
  for (const Stage& stage : scene.stages) whole += stage.duration;
  return whole;
}

/// Strain by which a stress would draw the glass out over the run, were it as hot as at the start.
double hot_strain(const Estimator& e, double stress) { return stress * lasting(e.scene) / (3 * *e.numbers.viscosity); }

/// Pa.
double highest_pressure(const Scene& scene) {
  double highest = 0;
  for (const Stage& stage : scene.stages)
    for (const auto& entry : stage.pressure) highest = std::max(highest, std::abs(entry.second));
  return highest;
}

/// The shortest stage in which a tool or a pressure drives the glass; the whole run where none does.
double quickest_drive(const Scene& scene) {
  double quickest = lasting(scene);
  for (const Stage& stage : scene.stages) {
    const auto moves = [](const StageTool& tool) { return !std::holds_alternative<std::monostate>(tool.motion); };
    if (!stage.pressure.empty() || std::any_of(stage.tools.begin(), stage.tools.end(), moves))
      quickest = std::min(quickest, stage.duration);
  }
  return quickest;
}

void add_friction(Estimator& e) {
  double slipping = 0;
  for (const Tool& tool : e.scene.tools) slipping += tool.friction.law == flow::Friction::Law::slip;
  if (e.scene.tools.empty()) return;
  const double share = slipping / double(e.scene.tools.size());
  e.scale("friction on tools", slipping == 0, slipping > 0 ? "share of tools that slip" : "share of tools that hold",
          slipping > 0 ? share : 1, slip_measured);
}

void add_flow(Estimator& e) {
  const auto& flow = *e.scene.glass.flow;
  const double length = e.numbers.length;
  const double tension = flow.surface_tension > 0 ? flow.surface_tension : usual_tension;
  const bool weight = std::any_of(e.scene.stages.begin(), e.scene.stages.end(), [](const Stage& s) { return s.gravity != 0; });
  const auto stressed = [&](const char* name, bool in_scene, double stress, const Measured& jar) {
    // Glass that nothing forms takes the strain as it is; what forms the jar, and its cooling, hold most of it back.
    const double strain = hot_strain(e, stress), ratio = strain / jar.number, blown = stress / highest_pressure(e.scene);
    constexpr const char* number_name = "strain it would make in hot glass";
    if (e.shape == Shaped::unformed) e.add(name, in_scene, number_name, strain, strain, heat_of_strain * strain);
    else if (e.shape == Shaped::pressed || ratio * jar.thickness > blown) e.scale(name, in_scene, number_name, strain, jar);
    else e.add(name, in_scene, "its stress over the pressure", blown, blown, ratio * jar.heat);
  };
  stressed("surface tension", flow.surface_tension > 0, tension / length, tension_measured);
  stressed("gravity", weight, flow.density * earth * length, gravity_measured);
  add_friction(e);
  // Inertia delays the flow by the time in which the slowest motion across a wall dies out, here a
  // slab held on both sides; no run measures what that changes at most.
  const double across = length / M_PI;
  const double delay = flow.density * across * across / (*e.numbers.viscosity * quickest_drive(e.scene));
  e.add("inertia", false, "its delay over the shortest drive", delay, delay, 0);
}

double effusivity(const thermal::Material& material, double temperature, double conductivity) {
  return std::sqrt(conductivity * material.density * material.heat_capacity(temperature));
}

/// Heat over 1 K that two half-spaces exchange through h in a time, J/m2/K; `resistance` is the sum of 1 over their effusivities.
double exchanged(double h, double resistance, double time) {
  const double H = h * resistance, x = H * std::sqrt(time);
  // exp(x^2) erfc(x), by its leading terms where that would overflow.
  const double tail = x < 20 ? std::exp(x * x) * std::erfc(x) : (1 - 0.5 / (x * x)) / (x * std::sqrt(M_PI));
  return h / (H * H) * (tail - 1 + 2 * x / std::sqrt(M_PI));
}

double highest_conductance(const Scene& scene, Index tool) {
  double h = 0;
  for (const Interface& interface : scene.interfaces)
    if (interface.tool == tool) h = std::max(h, contact::highest(interface.law));
  return h;
}

/// By how much more heat the glass would give to tools that stay as cold as they start, a share; the tool with the most counts.
double warming(const Scene& scene, double glass_conductivity) {
  const double hot = scene.glass.initial_temperature, glass = effusivity(*scene.glass.thermal, hot, glass_conductivity);
  double most = 0;
  for (std::size_t i = 0; i < scene.tools.size(); ++i) {
    const Tool& tool = scene.tools[i];
    const double h = highest_conductance(scene, static_cast<Index>(i));
    if (!tool.thermal || h == 0) continue;
    double time = 0;
    for (const Stage& stage : scene.stages)
      for (const StageTool& placed : stage.tools)
        if (placed.tool == static_cast<Index>(i)) time += stage.duration;
    if (time == 0) continue;
    const double cold = tool.initial_temperature;
    const double held = exchanged(h, 1 / glass, time);
    const double both = exchanged(h, 1 / glass + 1 / effusivity(*tool.thermal, cold, tool.thermal->conductivity(cold)), time);
    most = std::max(most, held / both - 1);
  }
  return most;
}

double strongest_air(const Scene& scene) {
  double h = 0;
  for (const Stage& stage : scene.stages) h = std::max(h, stage.air.h);
  return h;
}

void add_radiation(Estimator& e, double alone, double both, double unlimited) {
  const auto& radiation = e.scene.glass.thermal->radiation;
  e.scale("internal radiation", radiation.has_value(), "its share of the conductivity", 1 - alone / both, radiation_measured);
  if (radiation)
    e.scale("thin-wall limit", radiation->thin_wall, "conductivity that it takes away", unlimited / both - 1, thin_wall_measured);
}

void add_heat(Estimator& e) {
  const thermal::Material& own = *e.scene.glass.thermal;
  const double hot = e.scene.glass.initial_temperature, length = e.numbers.length;
  thermal::Material material = own;
  if (!material.radiation) material.radiation = usual_radiation;
  material.radiation->thin_wall = true;
  const double alone = own.conductivity(hot);
  const double both = thermal::conductivity(material, hot, thermal::thin_wall_factor(*material.radiation, length));
  const double unlimited = thermal::conductivity(material, hot, 1);
  add_radiation(e, alone, both, unlimited);
  const bool emits = e.scene.glass.emissivity > 0;
  const double emissivity = emits ? e.scene.glass.emissivity : usual_emissivity;
  const double air = strongest_air(e.scene);
  const auto cooling = [&](const char* name, bool in_scene, double h, Measured jar) {
    if (e.shape == Shaped::pressed) jar.heat *= pressed_open;
    e.scale(name, in_scene, "its Biot number", h * length / alone, jar);
  };
  cooling("emission to around", emits, 4 * emissivity * stefan_boltzmann * hot * hot * hot, emission_measured);
  cooling("cooling by air", air > 0, air > 0 ? air : usual_air, air_measured);
  if (e.scene.tools.empty()) return;
  const bool warm = std::any_of(e.scene.tools.begin(), e.scene.tools.end(), [](const Tool& tool) { return tool.thermal.has_value(); });
  const double gain = warming(e.scene, own.radiation ? both : alone);
  constexpr const char* number_name = "more heat into half-spaces held cold";
  // Forming glass touches its tools by and by, with less than the highest conductance.
  if (e.shape == Shaped::unformed) e.add("warming of tools", warm, number_name, gain, gain * warming_measured.thickness / warming_measured.heat, gain);
  else e.scale("warming of tools", warm, number_name, gain, warming_measured);
}

}  // namespace

std::vector<PartEstimate> estimate_parts(const Scene& scene) {
  Estimator estimator{scene, scene_numbers(scene), shaped(scene), {}};
  if (scene.has_flow()) add_flow(estimator);
  if (scene.has_heat()) add_heat(estimator);
  return std::move(estimator.parts);
}

std::string describe_parts(const Scene& scene) {
  const auto parts = estimate_parts(scene);
  if (parts.empty()) return {};
  const double asked = scene.accuracy_choice.target.value_or(expected_error(scene.accuracy_choice.level));
  const char* shape = shaped(scene) == Shaped::unformed ? "shape" : "thickness";
  std::string text =
      "\nwhat a part of the model changes, roughly: from one number each, by the ladders of the bundled jar and tumbler\n"
      "(`parison tradeoff CASE --only model` measures it)\n";
  for (const PartEstimate& part : parts) {
    text += fmt::format("  {:<20}{:<9}", part.name, part.in_scene ? "in" : "left out");
    if (scene.has_flow()) text += fmt::format("{} {:>6.2g} %, ", shape, 100 * part.thickness);
    if (scene.has_heat()) text += fmt::format("heat {:>6.2g} %", 100 * part.heat);
    text += fmt::format("   {} {:.2g}\n", part.number_name, part.number);
  }
  for (const PartEstimate& part : parts) {
    const double change = std::max(part.thickness, part.heat);
    if (!part.in_scene && change > asked)
      text += fmt::format("  warning: {} is left out and may change the result by some {:.2g} %, more than the {:.2g} % asked for\n",
                          part.name, 100 * change, 100 * asked);
  }
  return text;
}

}  // namespace parison::forming
