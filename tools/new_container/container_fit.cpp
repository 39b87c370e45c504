// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/new_container/container_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/case/case_error.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/scene.hpp"

namespace parison::tools {
namespace {

constexpr double mm = 1e-3;

std::string radius_text(const char* name, double value) {
  return fmt::format("dimension.{}={:.6f} mm", name, value / mm);
}

double dimension_of(const forming::Scene& scene, const std::string& name) {
  for (const auto& dimension : scene.dimensions)
    if (dimension.name == name) return dimension.measure.value;
  throw core::CaseError(fmt::format("the template has no dimension \"{}\"", name));
}

/// A drop of glass and a plunger that moves to where it is to stop: the volumes then depend on the tools alone.
std::vector<std::string> without_press(const std::vector<std::string>& given) {
  std::vector<std::string> overrides = given;
  overrides.push_back("glass.gob={ mass = \"1 g\", diameter = \"5 mm\", at = \"(0 mm, 0.4*blank_length)\" }");
  overrides.push_back(
      "stage.press={ name = \"press\", duration = \"1 s\", gravity = \"-9.81 m/s2\", tools = [\"ring\", \"plate\", "
      "\"blank\", \"plunger\"], motion = { plunger = { offset = [[\"0 s\", \"0 mm\"], [\"1 s\", \"blank_length - "
      "parison_base\"]] } } }");
  overrides.push_back("tool.plunger.position=0 mm");
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

ContainerFit fit_container(const std::string& file, const std::vector<std::string>& given, double capacity,
                           double mass) {
  const std::vector<std::string> base = without_press(given);
  const auto scene_with = [&](const char* name, double radius) {
    std::vector<std::string> overrides = base;
    overrides.push_back(radius_text(name, radius));
    return forming::read_scene(file, "draft", overrides);
  };
  const forming::Scene first = forming::read_scene(file, "draft", base);
  const auto& plan = first.container;
  if (!plan) throw core::CaseError("the template has no container");
  const double glass = mass * plan->glass_volume / plan->mass, height = dimension_of(first, "height");
  const auto mould = [&](double radius) { return scene_with("body_radius", radius).container->outside.value_or(0); };
  const auto cavity = [&](double radius) {
    const forming::Scene scene = scene_with("blank_radius", radius);
    return scene.container->press ? scene.container->press->cavity : 0;
  };
  const double body = where(std::sqrt((capacity + glass) / (0.75 * M_PI * height)), capacity + glass, mould);
  const double blank = where(0.9 * dimension_of(first, "plunger_radius") + 0.25 * body, glass, cavity);
  std::vector<std::string> overrides = given;
  overrides.push_back(radius_text("body_radius", std::round(1e5 * body) / 1e5));
  overrides.push_back(radius_text("blank_radius", std::round(1e5 * blank) / 1e5));
  return {overrides, body, blank};
}

}  // namespace parison::tools
