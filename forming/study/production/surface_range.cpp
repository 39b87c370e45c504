// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/surface_range.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/case/units.hpp"

namespace parison::forming {
namespace {

bool is_soft_at(const Scene& scene, double temperature) {
  constexpr double softening_point = 4e6;  // Pa.s
  const auto& flow = scene.glass.flow;
  return flow && !flow->viscosity.constant && flow->viscosity(temperature) < softening_point;
}

}  // namespace

SurfaceRange range_of(const std::vector<CycleSample>& samples, std::size_t tool) {
  SurfaceRange range;
  double time = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const ToolTemperatures& now = samples[i].tools[tool];
    range.min = std::min(range.min, now.surface_mean);
    range.max = std::max(range.max, now.surface_mean);
    range.hottest = std::max(range.hottest, now.surface_max);
    if (i == 0) continue;
    const double dt = samples[i].time - samples[i - 1].time;
    range.mean += 0.5 * dt * (now.surface_mean + samples[i - 1].tools[tool].surface_mean);
    time += dt;
  }
  range.mean = time > 0 ? range.mean / time : range.max;
  return range;
}

std::vector<std::string> why_not_possible(const Scene& scene, const std::vector<CycleSample>& samples) {
  std::vector<std::string> sentences;
  const double sticks = scene.output.flags.tool_surface_above;
  for (std::size_t t = 0; !samples.empty() && t < scene.tools.size(); ++t) {
    const SurfaceRange range = range_of(samples, t);
    const std::string& name = scene.tools[t].name;
    if (range.mean > sticks)
      sentences.push_back(fmt::format(
          "the surface of \"{}\" settles at {:.0f} degC on the mean, {:.0f} degC at its hottest; glass "
          "sticks above {:.0f} degC: cool it more, or make fewer containers in the time",
          name, range.mean - core::zero_celsius, range.hottest - core::zero_celsius, sticks - core::zero_celsius));
    else if (is_soft_at(scene, range.hottest))
      sentences.push_back(
          fmt::format("the surface of \"{}\" gets {:.0f} degC hot, where the glass itself is softer than at its "
                      "softening point and sticks: cool it more, or make fewer containers in the time",
                      name, range.hottest - core::zero_celsius));
  }
  return sentences;
}

std::vector<std::string> too_cold(const Scene& scene, const std::vector<CycleSample>& samples) {
  constexpr double coldest_usual = 400 + core::zero_celsius;
  std::vector<std::string> sentences;
  for (std::size_t t = 0; !samples.empty() && t < scene.tools.size(); ++t) {
    const double mean = range_of(samples, t).mean;
    if (mean < coldest_usual)
      sentences.push_back(
          fmt::format("the surface of \"{}\" settles at {:.0f} degC on the mean, where tools of production have {:.0f} "
                      "degC and more: cool it less, or make more containers in the time",
                      scene.tools[t].name, mean - core::zero_celsius, coldest_usual - core::zero_celsius));
  }
  return sentences;
}

}  // namespace parison::forming
