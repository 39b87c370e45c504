// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/convergence_study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/case/case_file.hpp"
#include "forming/study/model_variants.hpp"

namespace parison::forming {
namespace {

const Setting& setting(const std::string& key) {
  return *std::find_if(settings().begin(), settings().end(), [&](const Setting& s) { return s.key == key; });
}

const char* si_unit(const Setting& setting) {
  return setting.dimension.length ? " m" : setting.dimension.time ? " s" : setting.dimension.temperature ? " K" : "";
}

/// One setting `factor` times its value at the base; coarsening multiplies the settings of a case.
std::string scaled(const Scene& scene, const std::string& key, double factor) {
  const Setting& s = setting(key);
  const double wanted = scene.accuracy.*s.value * factor / std::pow(scene.accuracy_choice.coarsening_factor, s.order);
  const double value = std::clamp(wanted, s.min, s.max);
  return fmt::format("numerics.{}={:.10g}{}", key, value, si_unit(s));
}

/// Divisions of a body's mapped mesh for edges `factor` times as long.
void scale_mapped(const Scene& scene, const Body& body, const std::string& path, double factor,
                  std::vector<std::string>& overrides) {
  if (!body.mesh.mapped) return;
  const auto divisions = [&](Index n) {
    return std::max(1L, std::lround(n * scene.accuracy_choice.coarsening_factor / factor));
  };
  overrides.push_back(fmt::format("{}.mesh.mapped=[{}, {}]", path, divisions(body.mesh.mapped->along_first),
                                  divisions(body.mesh.mapped->along_second)));
}

std::vector<std::string> scaled_mesh(const Scene& scene, double factor) {
  std::vector<std::string> overrides;
  for (const char* key : {"surface_size", "skin_size", "viscosity_per_edge", "elements_across", "tool_contact_size"})
    overrides.push_back(scaled(scene, key, std::pow(factor, setting(key).order)));
  scale_mapped(scene, scene.glass, "glass", factor, overrides);
  for (const Tool& tool : scene.tools) scale_mapped(scene, tool, "tool." + tool.name, factor, overrides);
  return overrides;
}

std::vector<Variant> accuracy_variants(const std::string& reference) {
  const double finest = accuracy_preset(reference).surface_size;
  std::vector<Variant> variants;
  for (const char* text : {"draft coarser 2.8", "draft coarser 2", "draft coarser 1.4", "draft", "draft coarser 0.7",
                           "standard", "standard coarser 0.7", "fine"}) {
    std::string name = text;
    std::replace(name.begin(), name.end(), ' ', '_');
    if (accuracy_preset(text).surface_size > 1.001 * finest) variants.push_back({name, "accuracy", text, {}, ""});
  }
  return variants;
}

std::vector<Variant> numerical_variants(const Scene& scene) {
  std::vector<Variant> variants;
  const auto add = [&](const std::string& name, const char* group, std::vector<std::string> overrides) {
    variants.push_back({name, group, scene.accuracy_name, std::move(overrides), ""});
  };
  const auto add_key = [&](const char* group, const std::string& key, double factor) {
    add(fmt::format("{}_x{:g}", key, factor), group, {scaled(scene, key, factor)});
  };
  for (const double factor : {2.0, 1.4, 0.7})
    add(fmt::format("mesh_x{:g}", factor), "mesh", scaled_mesh(scene, factor));
  if (scene.has_flow()) {
    for (const char* key : {"skin_size", "tool_contact_size"})
      add_key("mesh", key, key == std::string("skin_size") ? 0.5 : 2);
    add_key("mesh", "elements_across", 0.7);
    for (const double factor : {2.0, 0.5}) add_key("time", "strain_per_step", factor);
    for (const double factor : {4.0, 0.25}) add_key("time", "motion_tolerance", factor);
    add_key("time", "max_step", 2);
    for (const int passes : {1, 2, 3})
      if (passes != scene.accuracy.passes)
        add(fmt::format("passes_{}", passes), "coupling", {fmt::format("numerics.passes={}", passes)});
  }
  if (scene.has_heat()) {
    for (const double factor : {4.0, 0.25}) add_key("time", "temperature_tolerance", factor);
    if (scene.has_flow())
      for (const double factor : {2.0, 0.5}) add_key("time", "temperature_per_step", factor);
    const int other = 3 - scene.accuracy.temperature_order;
    add(fmt::format("temperature_order_{}", other), "order", {fmt::format("numerics.temperature_order={}", other)});
  }
  return variants;
}

}  // namespace

std::string usual_reference(const Scene& scene) {
  return scene.glass.mesh.mapped ? "fine coarser 0.5" : "fine";
}

std::vector<Variant> standard_study(const Scene& scene, const std::string& reference) {
  std::vector<Variant> study = accuracy_variants(reference);
  for (auto variants : {numerical_variants(scene), model_variants(scene)})
    study.insert(study.end(), variants.begin(), variants.end());
  return study;
}

std::vector<Variant> read_study(const std::string& path, const std::string& base) {
  const auto file = core::read_case_file(path);
  const core::CaseTable root(file.root, {"variant"});
  std::vector<Variant> study;
  for (const auto* node : root.tables("variant")) {
    const core::CaseTable table(*node, {"name", "group", "accuracy", "set", "what"});
    Variant variant{core::identifier(table.get("name")), core::identifier(table.get("group")), base, {}, ""};
    if (const auto* item = table.find("accuracy")) variant.accuracy = core::text(*item);
    if (const auto* item = table.find("what")) variant.what = core::text(*item);
    if (const auto* item = table.find("set"))
      for (const auto& assignment : core::list(*item)) variant.overrides.push_back(core::text(assignment));
    for (const Variant& other : study)
      if (other.name == variant.name)
        core::refuse(table.get("name"),
                     fmt::format("\"{}\" was found twice, allowed are different names", variant.name));
    study.push_back(std::move(variant));
  }
  return study;
}

std::string base_variant(std::vector<Variant>& study, const std::string& base) {
  for (const Variant& variant : study)
    if (variant.accuracy == base && variant.overrides.empty()) return variant.name;
  study.insert(study.begin(), {"base", "accuracy", base, {}, ""});
  return "base";
}

}  // namespace parison::forming
