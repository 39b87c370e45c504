// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/new_container/container_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/case/case_error.hpp"
#include "core/math/numbers.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/scene.hpp"

namespace parison::tools {

using core::millimetre;

namespace {

std::string length_text(const char* name, double value) {
  return fmt::format("dimension.{}={:.6f} mm", name, value / millimetre);
}

bool has(const forming::Scene& scene, const std::string& name) {
  return std::any_of(scene.dimensions.begin(), scene.dimensions.end(),
                     [&](const auto& one) { return one.name == name; });
}

double dimension_of(const forming::Scene& scene, const std::string& name) {
  for (const auto& dimension : scene.dimensions)
    if (dimension.name == name) return dimension.measure.value;
  throw core::CaseError(fmt::format("the template has no dimension \"{}\"", name));
}

/// A drop of glass, midway before a plunger that moves to where it is to stop: the volumes then depend on the tools
/// alone.
std::vector<std::string> without_gob(const forming::Scene& scene, const std::vector<std::string>& given) {
  std::vector<std::string> overrides = given;
  std::string place = "in = \"blank\"";
  for (const forming::Stage& stage : scene.stages) {
    if (stage.name != "press") continue;
    place = "at = \"(0 mm, 0.5*(plunger_start + parison_stop))\"";
    std::string tools;
    for (const auto& entry : stage.tools) tools += fmt::format("\"{}\", ", scene.tools[entry.tool].name);
    overrides.push_back(fmt::format(
        "stage.press={{ name = \"press\", duration = \"1 s\", gravity = \"-9.81 m/s2\", tools = [{}], motion "
        "= {{ plunger = {{ offset = [[\"0 s\", \"plunger_start\"], [\"1 s\", \"parison_stop\"]] }} }} }}",
        tools));
  }
  overrides.push_back(fmt::format("glass.gob={{ mass = \"0.2 g\", diameter = \"5 mm\", {} }}", place));
  return overrides;
}

/// The x at which a rising function is a value, by the secant method with steps of a sixth at most.
template <typename Function>
double where(double begin, double value, const Function& function) {
  constexpr int most = 25;
  constexpr double close = 1e-5, step = 1.0 / 6;
  double x0 = begin, f0 = function(x0) - value, x1 = begin * (f0 > 0 ? 0.97 : 1.03);
  for (int i = 0; i < most; ++i) {
    const double f1 = function(x1) - value;
    if (std::abs(f1) < close * value) return x1;
    const double slope = (f1 - f0) / (x1 - x0),
                 wanted = slope > 0 ? x1 - f1 / slope : x1 * (f1 > 0 ? 1 - step : 1 + step);
    x0 = x1;
    f0 = f1;
    x1 = std::clamp(wanted, (1 - step) * x1, (1 + step) * x1);
  }
  throw core::CaseError("no dimensions were found at which weight and capacity are those that are wanted");
}

}  // namespace

bool is_pressed(const forming::Scene& scene) {
  return !has(scene, "blank_radius");
}

ContainerFit fit_container(const std::string& file, const std::vector<std::string>& given, double capacity,
                           double mass) {
  std::vector<std::string> base = without_gob(forming::read_scene(file, "draft"), given);
  const auto scene_with = [&](const char* name, double length) {
    std::vector<std::string> overrides = base;
    overrides.push_back(length_text(name, length));
    return forming::read_scene(file, "draft", overrides);
  };
  const forming::Scene first = forming::read_scene(file, "draft", base);
  const auto& plan = first.container;
  if (!plan) throw core::CaseError("the template has no container");
  const double glass = mass * plan->glass_volume / plan->mass, height = dimension_of(first, "height");
  const bool pressed = is_pressed(first);
  const char* const second = pressed ? "wall" : "blank_radius";
  const auto outside = [&](double radius) {
    const forming::ContainerPlan with = *scene_with("body_radius", radius).container;
    return with.outside.value_or(with.capacity.value_or(0) + (with.press ? with.press->cavity : 0));
  };
  const double body = where(std::sqrt((capacity + glass) / (0.75 * M_PI * height)), capacity + glass, outside);
  base.push_back(length_text("body_radius", body));
  const double rim = dimension_of(forming::read_scene(file, "draft", base), "finish_radius");
  if (pressed && rim < body)
    throw core::CaseError(
        fmt::format("no plunger comes out of a rim with a radius of {:.4g} mm over a foot of {:.4g} mm",
                    rim / millimetre, body / millimetre));
  const double share = has(first, "parison_share") ? dimension_of(first, "parison_share") : 1;
  const double begin = pressed ? 0.12 * body : 0.9 * dimension_of(first, "plunger_radius") + 0.25 * body;
  const auto cavity = [&](double length) {
    const auto parison = scene_with(second, length).container->parison;
    return parison ? parison->cavity : 0;
  };
  const double length = where(begin, glass / share, cavity);
  if (has(first, "blank_neck_radius") && length < dimension_of(first, "blank_neck_radius"))
    throw core::CaseError(fmt::format("a blank with a radius of {:.4g} mm is narrower than its neck of {:.4g} mm",
                                      length / millimetre, dimension_of(first, "blank_neck_radius") / millimetre));
  std::vector<std::string> overrides = given;
  overrides.push_back(length_text("body_radius", std::round(1e5 * body) / 1e5));
  overrides.push_back(length_text(second, std::round(1e5 * length) / 1e5));
  return {overrides, body, length};
}

}  // namespace parison::tools
