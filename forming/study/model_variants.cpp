// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/model_variants.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "core/case/case_file.hpp"
#include "forming/scene/describe/model_sensitivity.hpp"
#include "forming/scene/materials/material_library.hpp"

namespace parison::forming {
namespace {

const ContainerGlass usual;

struct Parts {
  const Scene& scene;
  std::string glass;  ///< name of its material in the case
  std::set<std::string> tool_materials;
  std::vector<std::string> still_air;  ///< overrides that take the air's h
  std::vector<std::string> vents;      ///< overrides that vent the cavities
  std::vector<Variant> variants;

  void add(const char* name, const std::string& what, std::vector<std::string> overrides) {
    variants.push_back({name, "model", scene.accuracy_name, std::move(overrides), what});
  }
  std::string of_glass(const std::string& value) const { return fmt::format("material.{}.{}", glass, value); }
};

/// Names of the materials, which the scene itself does not keep.
void find_materials(Parts& parts) {
  auto file = core::read_case_file(parts.scene.file);
  add_library_materials(file);
  for (const auto& assignment : parts.scene.overrides) core::override_value(file, assignment);
  const auto member = [](const core::CaseNode& node, const std::string& name) -> const core::CaseNode* {
    for (const auto& item : node.items)
      if (item.name == name) return &item;
    return nullptr;
  };
  const auto material = [&](const core::CaseNode& body) {
    const auto* item = member(body, "material");
    return item ? item->text : "";
  };
  parts.glass = material(*member(file.root, "glass"));
  if (const auto* tools = member(file.root, "tool"))
    for (const auto& tool : tools->items) parts.tool_materials.insert(material(tool));
  parts.tool_materials.erase("");
  const auto still = [&](const core::CaseNode& owner, const std::string& path) {
    if (member(owner, "air")) parts.still_air.push_back(path + "air.h=0 W/m2/K");
    if (member(owner, "trapped_air")) parts.vents.push_back(path + "trapped_air={law=\"vented\"}");
  };
  still(file.root, "");
  if (const auto* stages = member(file.root, "stage"))
    for (const auto& stage : stages->items) still(stage, fmt::format("stage.{}.", member(stage, "name")->text));
}

void add_heat_parts(Parts& parts) {
  const Scene& scene = parts.scene;
  if (const auto& radiation = scene.glass.thermal->radiation; !radiation) {
    parts.add("with_radiation",
              "radiation inside the glass, which the case neglects: added with the values of container glass",
              {parts.of_glass(fmt::format("radiation={{refractive_index={}, absorption=\"{} 1/m\", thin_wall={}}}",
                                          usual.radiation.refractive_index, usual.radiation.absorption,
                                          usual.radiation.thin_wall))});
  } else if (scene.has_light()) {
    const auto without = [&](const char* model) {
      return std::vector<std::string>{parts.of_glass(fmt::format("radiation.model={}", model)),
                                      parts.of_glass(fmt::format("emissivity={}", scene.glass.emissivity))};
    };
    parts.add("no_radiation", "radiation inside the glass (light in bands): opaque glass", without("none"));
    if (radiation->model == thermal::Radiation::Model::transfer)
      parts.add("p1_cones", "radiative transfer: P1 in cones in its place", without("p1_cones"));
    if (radiation->model == thermal::Radiation::Model::p1_cones)
      parts.add("no_cones", "cones of directions: P1 without them", without("p1"));
    if (radiation->absorption > 0)
      parts.add("rosseland", "radiation inside the glass as conduction (Rosseland) in place of light in bands",
                without("rosseland"));
  } else {
    // An opaque glass carries no heat by radiation.
    parts.add("no_radiation", "radiation inside the glass (Rosseland)",
              {parts.of_glass("radiation.absorption=1e12 1/m")});
    if (radiation->thin_wall)
      parts.add("no_thin_wall", "thin-wall limit of that radiation", {parts.of_glass("radiation.thin_wall=false")});
  }
  if (scene.glass.emissivity > 0 && !scene.has_light())
    parts.add("no_emission", "radiation of the glass to its surroundings", {parts.of_glass("emissivity=0")});
  if (scene.enclosure)
    parts.add("no_enclosure", "light between surfaces: each sees the surroundings alone", {"enclosure=false"});
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
  Parts parts{scene, {}, {}, {}, {}, {}};
  find_materials(parts);
  if (scene.has_heat()) add_heat_parts(parts);
  if (scene.has_flow()) add_flow_parts(parts);
  return parts.variants;
}

}  // namespace parison::forming
