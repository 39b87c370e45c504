// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/materials/viscosity_picture.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/case/case_error.hpp"
#include "core/case/units.hpp"
#include "core/io/svg.hpp"

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

}  // namespace

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

}  // namespace parison::tools
