// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/materials/materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/case/case_error.hpp"
#include "core/case/units.hpp"
#include "core/io/files.hpp"
#include "forming/scene/materials/material_library.hpp"
#include "tools/materials/viscosity_picture.hpp"

namespace parison::tools {
namespace {

using forming::NamedMaterial;

constexpr double typical = 500;  // degC, of a tool

/// Temperature at which a falling viscosity has a value, degC.
double temperature_at(const flow::Viscosity& viscosity, double log10_viscosity) {
  double cold = 300 + core::zero_celsius, hot = 2000 + core::zero_celsius;
  while (hot - cold > 1e-3) {
    const double middle = 0.5 * (cold + hot);
    (std::log10(viscosity(middle)) > log10_viscosity ? cold : hot) = middle;
  }
  return hot - core::zero_celsius;
}

std::string glass_lines() {
  std::string text = fmt::format("{:<26}{:>12}{:>12}{:>12}\n", "glass, degC at", "1e3 Pa.s", "1e6.6 Pa.s", "1e12 Pa.s");
  for (const NamedMaterial& material : forming::library_materials())
    if (material.flow) {
      const auto at = [&](double decades) { return temperature_at(material.flow->viscosity, decades); };
      text += fmt::format("{:<26}{:>12.0f}{:>12.0f}{:>12.0f}  {}\n", material.name, at(3), at(6.6), at(11.9999),
                          material.about);
    }
  return text;
}

std::string tool_lines() {
  std::string text = fmt::format("\n{:<26}{:>12}{:>12}{:>12}\n", "tool, at 500 degC", "W/m/K", "J/kg/K", "kg/m3");
  for (const NamedMaterial& material : forming::library_materials())
    if (!material.flow) {
      const double T = typical + core::zero_celsius;
      text += fmt::format("{:<26}{:>12.3g}{:>12.4g}{:>12.4g}  {}\n", material.name, material.thermal->conductivity(T),
                          material.thermal->heat_capacity(T), material.thermal->density, material.about);
    }
  return text;
}

std::string shown(const NamedMaterial& material) {
  std::string text = forming::library_entry(material.name);
  if (!material.flow) return text;
  text += "\n  degC        Pa.s\n";
  for (double T = 500; T <= 1400; T += 100)
    text +=
        fmt::format("  {:<12g}{:.3g}{}\n", T, material.flow->viscosity(T + core::zero_celsius),
                    material.flow->viscosity.is_capped(T + core::zero_celsius) ? "  (the most that a run uses)" : "");
  return text;
}

/// The named materials, all where none is named.
std::vector<NamedMaterial> chosen(const std::vector<std::string>& names) {
  const auto& all = forming::library_materials();
  if (names.empty()) return all;
  std::vector<NamedMaterial> found;
  for (const auto& name : names) {
    const auto at = std::find_if(all.begin(), all.end(), [&](const auto& material) { return material.name == name; });
    const auto known = forming::library_names();
    if (at == all.end())
      throw core::CaseError(fmt::format("{}: no such material{}, allowed are {}", name, core::did_you_mean(name, known),
                                        fmt::join(known, ", ")));
    found.push_back(*at);
  }
  return found;
}

}  // namespace

int materials(const MaterialsRequest& request) {
  const std::vector<NamedMaterial> found = chosen(request.names);
  if (!request.picture.empty()) {
    if (std::filesystem::path(request.picture).extension() != ".svg")
      throw core::CaseError(fmt::format("--picture: \"{}\" was found, allowed is a file named .svg", request.picture));
    core::replace_file(request.picture, viscosity_picture(found));
  }
  if (request.names.empty()) {
    fmt::print(
        "{}{}\n`parison materials NAME` shows values, sources and what is assumed; a case says material = "
        "\"NAME\".\n",
        glass_lines(), tool_lines());
    return 0;
  }
  for (std::size_t i = 0; i < found.size(); ++i) fmt::print("{}{}", i ? "\n" : "", shown(found[i]));
  return 0;
}

}  // namespace parison::tools
