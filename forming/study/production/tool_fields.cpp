// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/tool_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

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

Eigen::VectorXd tool_temperatures(const State& state) {
  Eigen::Index size = 0, at = 0;
  for (const ToolState& tool : state.tools) size += tool.temperature.size();
  Eigen::VectorXd all(size);
  for (const ToolState& tool : state.tools) {
    all.segment(at, tool.temperature.size()) = tool.temperature;
    at += tool.temperature.size();
  }
  return all;
}

void set_tool_temperatures(const Eigen::VectorXd& temperatures, State& state) {
  Eigen::Index at = 0;
  for (ToolState& tool : state.tools) {
    tool.temperature = temperatures.segment(at, tool.temperature.size());
    at += tool.temperature.size();
  }
}

Scene with_tools_at(const Scene& scene, const State& state, const Eigen::VectorXd& temperatures) {
  Scene warm = scene;
  Eigen::Index at = 0;
  for (std::size_t t = 0; t < state.tools.size(); ++t) {
    const Eigen::VectorXd field = temperatures.segment(at, state.tools[t].temperature.size());
    at += field.size();
    warm.tools[t].start_field =
        StartField{"the machine cycle before", {}, state.tools[t].mesh, field, field.minCoeff(), field.maxCoeff()};
  }
  return warm;
}

Scene with_tools_of(const Scene& scene, const std::string& folder) {
  const std::string from = std::filesystem::absolute(folder).lexically_normal().string();
  std::vector<std::string> overrides = scene.overrides;
  for (const Tool& tool : scene.tools) {
    const std::string key = fmt::format("tool.{}.temperature=", tool.name);
    overrides.erase(std::remove_if(overrides.begin(), overrides.end(),
                                   [&](const std::string& assignment) { return assignment.rfind(key, 0) == 0; }),
                    overrides.end());
    overrides.push_back(fmt::format("{}{{ from = \"{}\" }}", key, from));
  }
  Scene warm = read_scene(scene.file, scene.accuracy_name, overrides);
  // Sizes of first meshes depend on this mean.
  for (std::size_t t = 0; t < warm.tools.size(); ++t)
    warm.tools[t].initial_temperature = scene.tools[t].initial_temperature;
  return warm;
}

std::vector<double> surface_changes(const State& state, const Eigen::VectorXd& changes) {
  std::vector<double> largest;
  Eigen::Index first = 0;
  for (const ToolState& tool : state.tools) {
    const auto touches = core::boundaries_of_kind(tool.mesh, BoundaryKind::contact);
    double change = 0;
    for (const auto& edge : tool.mesh.boundary_edges())
      if (touches[edge.boundary_id])
        for (const Index node : edge.nodes) change = std::max(change, std::abs(changes[first + node]));
    largest.push_back(change);
    first += tool.mesh.node_count();
  }
  return largest;
}

double surface_change(const State& state, const Eigen::VectorXd& changes) {
  const auto largest = surface_changes(state, changes);
  return *std::max_element(largest.begin(), largest.end());
}

State tools_of(const State& state) {
  State tools;
  tools.time = state.time;
  tools.stage = state.stage;
  tools.stage_start = state.stage_start;
  tools.tools = state.tools;
  tools.probes = state.probes;
  return tools;
}

}  // namespace parison::forming
