// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/materials/materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "core/case/case_error.hpp"
#include "core/case/units.hpp"
#include "core/io/files.hpp"
#include "core/io/svg.hpp"
#include "forming/scene/materials/material_library.hpp"

namespace parison::tools {

namespace {

namespace svg = core::svg;

constexpr double coldest = 450, hottest = 1450, thinnest = 0, stiffest = 12;  // degC, log10 Pa.s
constexpr double width = 720, height = 480, left = 70, top = 30;              // pixels
constexpr std::array colours{"#c1121f", "#386641", "#bc6c25", "#6a4c93", "#1982c4", "#333333", "#8ac926", "#ff924c"};

double across(double temperature) {
  return left + width * (temperature - coldest) / (hottest - coldest);
}

double down(double decades) {
  return top + height * (stiffest - decades) / (stiffest - thinnest);
}

std::string grid() {
  std::string text;
  const char* thin = "stroke=\"#ddd\"";
  for (double T = 500; T <= 1400; T += 100) {
    text += svg::line(across(T), down(thinnest), across(T), down(stiffest), thin);
    text += svg::text(across(T), down(thinnest) + 18, "middle", fmt::format("{:g}", T));
  }
  for (double decades = thinnest; decades <= stiffest; decades += 2) {
    text += svg::line(across(coldest), down(decades), across(hottest), down(decades), thin);
    text += svg::text(left - 8, down(decades) + 4, "end", fmt::format("1e{:g}", decades));
  }
  text += svg::text(across(0.5 * (coldest + hottest)), down(thinnest) + 38, "middle", "temperature, degC");
  text += svg::text(left, top - 10, "middle", "viscosity, Pa.s");
  for (const auto& [decades, name] :
       {std::pair{3.0, "working point"}, {6.6, "softening point"}, {12.0, "annealing point"}}) {
    text += svg::line(across(coldest), down(decades), across(hottest), down(decades),
                      "stroke=\"#999\" stroke-dasharray=\"6 4\"");
    text += svg::text(across(hottest) - 4, down(decades) + (decades > 11 ? 14 : -5), "end", name);
  }
  return text;
}

std::string curve(const flow::Viscosity& viscosity, const char* colour) {
  constexpr double step = 5;
  svg::Path path;
  for (double T = coldest; T <= hottest; T += step) {
    const double decades = std::log10(viscosity(T + core::zero_celsius));
    if (viscosity.is_capped(T + core::zero_celsius) || decades < thinnest || decades > stiffest) continue;
    path.to(across(T), down(decades));
  }
  return path.drawn(fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\"", colour));
}

/// An SVG picture of the viscosities of the glasses among some materials over temperature; refused where none is a
/// glass.
std::string viscosity_picture(const std::vector<forming::NamedMaterial>& materials) {
  std::string body = grid();
  std::size_t count = 0;
  for (const auto& material : materials) {
    if (!material.flow) continue;
    const char* colour = colours[count % colours.size()];
    const double y = top + 60 + 18 * static_cast<double>(count++);
    body += curve(material.flow->viscosity, colour);
    body += svg::line(across(hottest) - 190, y - 4, across(hottest) - 160, y - 4,
                      fmt::format("stroke=\"{}\" stroke-width=\"1.8\"", colour));
    body += svg::text(across(hottest) - 152, y, "start", material.name);
  }
  if (count == 0)
    throw core::CaseError("--picture: no glass among these materials, allowed are materials that have a viscosity");
  return svg::picture(left + width + 30, top + height + 60, body);
}

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
