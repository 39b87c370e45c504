// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/model_variants.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/case/case_error.hpp"
#include "core/case/case_file.hpp"
#include "forming/scene/describe/model_sensitivity.hpp"
#include "forming/scene/materials/material_library.hpp"

namespace parison::forming {
namespace {

const ContainerGlass usual;
constexpr double oxidised_iron = 0.8;  ///< its emissivity

struct Parts {
  const Scene& scene;
  std::string glass;  ///< name of its material in the case
  std::set<std::string> tool_materials;
  std::vector<std::string> still_air;    ///< overrides that take the air's h
  std::vector<std::string> vents;        ///< overrides that vent the cavities
  std::set<std::string> dark_materials;  ///< of tools, without emissivity
  std::vector<Variant> variants;

  void add(const char* name, const std::string& what, std::vector<std::string> overrides) {
    // No variant has another model of radiation chosen for it.
    if (scene.radiation_choice)
      overrides.insert(overrides.begin(), of_glass("radiation.model=" + scene.radiation_choice->model.name));
    variants.push_back({name, "model", scene.accuracy_name, std::move(overrides), what});
  }
  std::string of_glass(const std::string& value) const { return fmt::format("material.{}.{}", glass, value); }
  /// An assignment, with an emissivity for every tool, so that light can reach it.
  std::vector<std::string> with_grey_tools(const std::string& assignment) const {
    std::vector<std::string> overrides{assignment};
    for (const std::string& material : dark_materials)
      overrides.push_back(fmt::format("material.{}.emissivity={}", material, oxidised_iron));
    return overrides;
  }
};

/// Names of the materials, which the scene itself does not keep.
void find_materials(Parts& parts) {
  const auto file = read_case(parts.scene.file, parts.scene.overrides);
  const auto material = [&](const core::CaseNode& body) {
    const auto* item = member(body, "material");
    return item ? item->text : "";
  };
  parts.glass = material(*member(file.root, "glass"));
  if (const auto* tools = member(file.root, "tool"))
    for (const auto& tool : tools->items) parts.tool_materials.insert(material(tool));
  parts.tool_materials.erase("");
  for (std::size_t i = 0; i < parts.scene.tools.size(); ++i)
    if (parts.scene.tools[i].thermal && parts.scene.tools[i].emissivity == 0)
      parts.dark_materials.insert(material(member(file.root, "tool")->items[i]));
  const auto still = [&](const core::CaseNode& owner, const std::string& path) {
    if (member(owner, "air")) parts.still_air.push_back(path + "air.h=0 W/m2/K");
    if (member(owner, "trapped_air")) parts.vents.push_back(path + "trapped_air={law=\"vented\"}");
  };
  still(file.root, "");
  if (const auto* stages = member(file.root, "stage"))
    for (const auto& stage : stages->items) still(stage, fmt::format("stage.{}.", member(stage, "name")->text));
}

/// Sets the bands of a glass to one.
std::string one_band(const Scene& scene) {
  const thermal::Band band = merged_bands(scene.glass.thermal->radiation->bands, scene.glass.initial_temperature);
  const std::string up_to = std::isfinite(band.up_to) ? fmt::format("up_to=\"{:.9g} um\", ", 1e6 * band.up_to) : "";
  return fmt::format("radiation.bands=[{{ {}absorption=\"{:.6g} 1/m\" }}]", up_to, band.absorption);
}

/// Parts of a glass whose light is computed in bands.
void add_light_parts(Parts& parts) {
  const Scene& scene = parts.scene;
  const thermal::Radiation& radiation = *scene.glass.thermal->radiation;
  using Model = thermal::Radiation::Model;
  const auto with_model = [&](const char* model) {
    return std::vector<std::string>{parts.of_glass(fmt::format("radiation.model={}", model)),
                                    parts.of_glass(fmt::format("emissivity={}", scene.glass.emissivity))};
  };
  parts.add("no_radiation", "radiation inside the glass (light in bands): opaque glass", with_model("none"));
  if (radiation.model == Model::transfer && !scene.enclosure)
    parts.add("p1_cones", "radiative transfer: P1 in cones in its place", with_model("p1_cones"));
  if (radiation.model == Model::p1_cones)
    parts.add("no_cones", "cones of directions: P1 without them", with_model("p1"));
  if (radiation.model != Model::transfer)
    parts.add("transfer", "the approximation of the light: radiative transfer in its place", with_model("transfer"));
  if (radiation.absorption > 0)
    parts.add("rosseland", "radiation inside the glass as conduction (Rosseland) in place of light in bands",
              with_model("rosseland"));
  if (radiation.bands.size() > 1)
    parts.add("one_band", "bands of the spectrum: one in their place, with their mean absorption",
              {parts.of_glass(one_band(scene))});
}

/// Parts of a glass whose radiation is conduction.
void add_rosseland_parts(Parts& parts) {
  const Scene& scene = parts.scene;
  const thermal::Radiation& radiation = *scene.glass.thermal->radiation;
  // An opaque glass carries no heat by radiation.
  parts.add("no_radiation", "radiation inside the glass (Rosseland)",
            {parts.of_glass("radiation.absorption=1e12 1/m")});
  if (radiation.thin_wall)
    parts.add("no_thin_wall", "thin-wall limit of that radiation", {parts.of_glass("radiation.thin_wall=false")});
  if (radiation.bands.empty() || scene.glass.emissivity == 0) return;
  parts.add("transfer", "radiation inside the glass as conduction: radiative transfer in bands in its place",
            parts.with_grey_tools(parts.of_glass("radiation.model=transfer")));
}

/// Whether the case can be read as a variant has it.
bool is_allowed(const Scene& scene, const Variant& variant) {
  auto all = scene.overrides;
  all.insert(all.end(), variant.overrides.begin(), variant.overrides.end());
  try {
    read_scene(scene.file, scene.accuracy_name, all);
    return true;
  } catch (const core::CaseError&) {
    return false;
  }
}

void add_enclosure(Parts& parts) {
  if (parts.scene.enclosure)
    return parts.add("no_enclosure", "light between surfaces: each sees the surroundings alone", {"enclosure=false"});
  parts.add("with_enclosure", "light between surfaces, which the case neglects: they see each other",
            parts.with_grey_tools("enclosure=true"));
  if (!is_allowed(parts.scene, parts.variants.back())) parts.variants.pop_back();
}

void add_heat_parts(Parts& parts) {
  const Scene& scene = parts.scene;
  if (!scene.glass.thermal->radiation)
    parts.add("with_radiation",
              "radiation inside the glass, which the case neglects: added with the values of container glass",
              {parts.of_glass(fmt::format("radiation={{refractive_index={}, absorption=\"{} 1/m\", thin_wall={}}}",
                                          usual.radiation.refractive_index, usual.radiation.absorption,
                                          usual.radiation.thin_wall))});
  else if (scene.has_light())
    add_light_parts(parts);
  else
    add_rosseland_parts(parts);
  if (scene.glass.emissivity > 0 && !scene.has_light())
    parts.add("no_emission", "radiation of the glass to its surroundings", {parts.of_glass("emissivity=0")});
  add_enclosure(parts);
  const bool blows =
      std::any_of(scene.stages.begin(), scene.stages.end(), [](const Stage& stage) { return stage.air.h.max() > 0; });
  if (blows && !parts.still_air.empty()) parts.add("no_air_cooling", "cooling by moving air", parts.still_air);
  std::vector<std::string> fixed;
  for (const std::string& material : parts.tool_materials)
    if (material != parts.glass) fixed.push_back(fmt::format("material.{}.heat_capacity=1e9 J/kg/K", material));
  const bool hot_tools =
      std::any_of(scene.tools.begin(), scene.tools.end(), [](const Tool& t) { return bool(t.thermal); });
  if (hot_tools && !fixed.empty()) parts.add("fixed_tools", "warming of the tools: they keep their temperature", fixed);
}

void add_friction(Parts& parts) {
  using Law = flow::Friction::Law;
  for (const auto& [name, law] : {std::pair{"slip", Law::slip}, std::pair{"stick", Law::stick}}) {
    std::vector<std::string> overrides;
    for (const Tool& tool : parts.scene.tools)
      if (tool.friction.law != law && tool.friction.law != Law::grip)  // what grips holds the glass
        overrides.push_back(fmt::format("tool.{}.friction={}", tool.name, name));
    if (!overrides.empty())
      parts.add(law == Law::slip ? "all_slip" : "all_stick", fmt::format("friction laws of the tools: all {}", name),
                overrides);
  }
}

void add_trapped_air(Parts& parts) {
  const auto& stages = parts.scene.stages;
  const bool sealed =
      std::any_of(stages.begin(), stages.end(), [](const Stage& stage) { return stage.trapped_air.has_value(); });
  if (sealed)
    parts.add("no_trapped_air", "air in sealed cavities: vented", parts.vents);
  else if (!parts.scene.tools.empty())
    parts.add("with_trapped_air",
              "air in sealed cavities, which the case vents: isothermal at 500 degC, each with a vent of 20 mm2",
              {"trapped_air={law=\"isothermal\", temperature=\"500 degC\", vent_area=\"20 mm2\"}"});
}

void add_flow_parts(Parts& parts) {
  const Scene& scene = parts.scene;
  if (scene.glass.flow->surface_tension > 0)
    parts.add("no_tension", "surface tension", {parts.of_glass("surface_tension=0 N/m")});
  else
    parts.add("with_tension", "surface tension, which the case neglects: added with the value of container glass",
              {parts.of_glass(fmt::format("surface_tension={} N/m", usual.surface_tension))});
  if (scene.glass.flow->shear_thinning)
    parts.add("no_thinning", "shear thinning", {parts.of_glass("shear_thinning.time=1e-12 s")});
  constexpr double gravity_fraction = 0.01;
  std::vector<std::string> weightless;
  for (const Stage& stage : scene.stages)
    if (stage.gravity != 0)
      weightless.push_back(fmt::format("stage.{}.gravity={:.6g} m/s2", stage.name, gravity_fraction * stage.gravity));
  if (!weightless.empty())
    parts.add("no_gravity", "gravity, reduced to 1 % so that the glass stays in position", weightless);
  add_friction(parts);
  add_trapped_air(parts);
}

}  // namespace

std::vector<Variant> model_variants(const Scene& scene) {
  Parts parts{scene, {}, {}, {}, {}, {}, {}};
  find_materials(parts);
  if (scene.has_heat()) add_heat_parts(parts);
  if (scene.has_flow()) add_flow_parts(parts);
  if (scene.solid) {  // trapped air is not computed there
    const auto refused = [&](const Variant& variant) { return !is_allowed(scene, variant); };
    parts.variants.erase(std::remove_if(parts.variants.begin(), parts.variants.end(), refused), parts.variants.end());
  }
  return parts.variants;
}

}  // namespace parison::forming
