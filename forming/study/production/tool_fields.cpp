// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/tool_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace parison::forming {

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
