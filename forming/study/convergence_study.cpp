// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/convergence_study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/case/case_file.hpp"
#include "core/math/numbers.hpp"
#include "forming/study/model_variants.hpp"

namespace parison::forming {

namespace {

double level_of(const Variant& variant) {
  return read_accuracy(variant.accuracy).effective_level();
}

bool on_plot(const VariantResult& result) {
  return result.completed && result.variant.group != "model" && result.variant.group != "reference" &&
         result.error() > 0;
}

}  // namespace

double VariantResult::error() const {
  return std::fmax(profile.mean, heat);
}

void compare_variants(std::vector<VariantResult>& results, const std::string& base) {
  const auto found =
      std::find_if(results.begin(), results.end(), [&](const VariantResult& r) { return r.variant.name == base; });
  for (VariantResult& result : results) {
    const VariantResult& other = result.variant.group == "model" ? *found : results.front();
    result.profile = compare_profiles(result.quantities.profile, other.quantities.profile);
    result.heat = heat_difference(result.quantities, other.quantities);
  }
}

void mark_front(std::vector<VariantResult>& results) {
  for (VariantResult& result : results)
    result.on_front = on_plot(result) && std::none_of(results.begin(), results.end(), [&](const VariantResult& other) {
                        return on_plot(other) && other.cpu <= result.cpu && other.error() <= result.error() &&
                               (other.cpu < result.cpu || other.error() < result.error());
                      });
}

double over_front(const std::vector<VariantResult>& results, const VariantResult& variant) {
  std::vector<const VariantResult*> line;
  for (const VariantResult& result : results)
    if (result.on_front) line.push_back(&result);
  std::sort(line.begin(), line.end(), [](const auto* a, const auto* b) { return a->error() < b->error(); });
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i]->error() < variant.error()) continue;
    if (i == 0) return line[0]->error() == variant.error() ? variant.cpu / line[0]->cpu : core::none;
    const VariantResult &a = *line[i - 1], &b = *line[i];
    const double t = std::log(variant.error() / a.error()) / std::log(b.error() / a.error());
    return variant.cpu / std::exp((1 - t) * std::log(a.cpu) + t * std::log(b.cpu));
  }
  return line.empty() ? core::none : variant.cpu / line.back()->cpu;
}

ErrorLaw fit_error_law(const std::vector<VariantResult>& results, double (*error)(const VariantResult&)) {
  const double reference = level_of(results.front().variant);
  std::vector<std::pair<double, double>> points;  // level, error
  for (const VariantResult& result : results)
    if (result.completed && result.variant.group == "accuracy" && error(result) > 0)
      points.emplace_back(level_of(result.variant), error(result));
  ErrorLaw best{core::none, core::none};
  if (points.size() < 2) return best;
  double least = std::numeric_limits<double>::infinity();
  // Below the first order nothing here converges; only scatter looks so.
  constexpr double min_order = 1, max_order = 3, step = 0.01;
  for (double order = min_order; order <= max_order; order += step) {
    std::vector<double> logs;
    logs.reserve(points.size());
    for (const auto& [level, size] : points)
      logs.push_back(std::log(size / (std::exp2(-order * level) - std::exp2(-order * reference))));
    double mean = 0, spread = 0;
    for (const double value : logs) mean += value / double(logs.size());
    for (const double value : logs) spread += (value - mean) * (value - mean);
    if (spread < least) least = spread, best = {std::exp(mean), order};
  }
  return best;
}

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
    for (const double factor : {4.0, 0.25}) add_key("time", "work_per_step", factor);
    for (const double factor : {4.0, 0.25}) add_key("time", "motion_tolerance", factor);
    add_key("time", "max_step", 2);
  }
  if (scene.has_heat())
    for (const double factor : {4.0, 0.25}) add_key("time", "temperature_tolerance", factor);
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
