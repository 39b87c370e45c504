// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/files/tool_rows.hpp"

#include <fmt/format.h>

#include "core/io/files.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {

std::vector<ToolSurface> tool_surfaces(const Scene& scene, const State& state) {
  std::vector<ToolSurface> surfaces;
  for (const ToolState& tool : state.tools) surfaces.emplace_back(tool.mesh, scene.geometry);
  return surfaces;
}

std::vector<std::size_t> reported_faces(const Tool& tool) {
  std::vector<std::size_t> faces;
  for (std::size_t i = 0; i < tool.boundaries.size(); ++i)
    if (const BoundaryKind kind = tool.boundaries[i].kind;
        kind == BoundaryKind::cooled || kind == BoundaryKind::temperature)
      faces.push_back(i);
  return faces;
}

std::string tool_header(const Scene& scene) {
  std::string line = "time_s,stage";
  for (const Tool& tool : scene.tools) {
    if (!tool.thermal) continue;
    for (const char* column : {"mean_degC", "surface_mean_degC", "surface_max_degC", "surface_max_r_mm",
                               "surface_max_z_mm", "sticking_area_mm2", "heat_received_J"})
      line += ',' + core::csv_text(tool.name + '_' + column);
    for (const std::size_t face : reported_faces(tool))
      line += ',' + core::csv_text(tool.name + '_' + tool.boundaries[face].name + "_heat_J");
  }
  return line + '\n';
}

std::string tool_line(const Scene& scene, const State& state, const std::vector<ToolSurface>& surfaces) {
  std::string line = fmt::format("{:.12g},{}", state.time, core::csv_text(scene.stages.at(state.stage).name));
  for (std::size_t i = 0; i < scene.tools.size(); ++i) {
    if (!scene.tools[i].thermal) continue;
    const ToolState& tool = state.tools[i];
    const ToolTemperatures found = surfaces[i].temperatures(tool, scene.output.flags.tool_surface_above);
    const Point at = found.surface_max_at + tool.offset * core::axis_direction();
    const double celsius = thermal::content_reference;
    for (const double value : {found.mean - celsius, found.surface_mean - celsius, found.surface_max - celsius,
                               1e3 * at[0], 1e3 * at[1], 1e6 * found.surface_area_above, tool.heat_received})
      line += fmt::format(",{:.8g}", value);
    for (const std::size_t face : reported_faces(scene.tools[i]))
      line += fmt::format(",{:.8g}", tool.heat_through[face]);
  }
  return line + '\n';
}

}  // namespace parison::forming
