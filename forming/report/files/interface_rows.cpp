// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/files/interface_rows.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/io/files.hpp"
#include "forming/report/thickness_profile.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/heat/thermal_interface.hpp"
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

namespace {

double value_at(const Eigen::VectorXd& nodal, const std::array<Index, 3>& nodes, const std::array<double, 3>& shape) {
  return shape[0] * nodal[nodes[0]] + shape[1] * nodal[nodes[1]] + shape[2] * nodal[nodes[2]];
}

/// Where a point lies on its glass edge, 0 to 1.
double fraction_of_edge(const core::InterfacePoint& point) {
  return point.slave_shape[1] + 0.5 * point.slave_shape[2];
}

/// Arc length of interface points from the start of the glass surface.
class ArcOfPoints {
 public:
  explicit ArcOfPoints(const core::Mesh& glass) {
    std::vector<bool> surface = core::boundaries_of_kind(glass, BoundaryKind::symmetry);
    surface.flip();
    for (const ChainEdge& edge : walk_surface(glass, surface))
      edges_[glass.boundary_edges()[edge.edge].nodes[2]] = edge;
  }
  double operator()(const core::InterfacePoint& point) const {
    const ChainEdge& edge = edges_.at(point.slave_nodes[2]);
    return edge.start + fraction_of_edge(point) * edge.length;
  }

 private:
  std::map<Index, ChainEdge> edges_;  ///< by mid-side node
};

double viscosity_at(const Scene& scene, double temperature) {
  return scene.has_flow() ? scene.glass.flow->viscosity(temperature) : std::numeric_limits<double>::quiet_NaN();
}

/// Whether two neighbours on the glass surface are so close that one row speaks for both: a quarter of a glass edge.
bool same_row(const core::InterfacePoint& a, const core::InterfacePoint& b) {
  constexpr double rows_on_edge = 4;
  return a.slave_nodes[2] == b.slave_nodes[2] && a.master_body == b.master_body &&
         std::floor(rows_on_edge * fraction_of_edge(a)) == std::floor(rows_on_edge * fraction_of_edge(b));
}

/// Values have the digits of single precision.
void add_line(const Scene& scene, const State& state, const core::InterfacePoint& point, double arc,
              fmt::memory_buffer& lines) {
  const double glass = value_at(state.glass.temperature, point.slave_nodes, point.slave_shape);
  const double tool = value_at(temperature_of(state, point.master_body), point.master_nodes, point.master_shape);
  long clamped_lookups = 0;
  const double h = point_conductance(scene, point, {glass, tool}, clamped_lookups).h;
  const double celsius = thermal::content_reference;
  for (const double value : {1e3 * arc, 1e3 * point.position[0], 1e3 * point.position[1], glass - celsius,
                             tool - celsius, point.pressure, viscosity_at(scene, glass), h,
                             point.contact_weight * h * (glass - tool), 1e3 * point.gap, point.contact_weight})
    fmt::format_to(fmt::appender(lines), FMT_COMPILE(",{}"), static_cast<float>(value));
  lines.push_back('\n');
}

}  // namespace

std::string interface_header() {
  return "time_s,tool,arc_mm,r_mm,z_mm,T_glass_degC,T_tool_degC,pressure_Pa,viscosity_Pa_s,h_W_m2K,flux_W_m2,gap_mm,"
         "contact_weight\n";
}

std::string interface_lines(const Scene& scene, const State& state,
                            const std::vector<core::InterfacePoint>& interface) {
  if (!scene.has_heat()) return {};
  const ArcOfPoints arc_of(state.glass.mesh);
  std::vector<std::pair<double, const core::InterfacePoint*>> points;
  for (const core::InterfacePoint& point : interface)
    if (point.contact_weight > 0) points.push_back({arc_of(point), &point});
  std::stable_sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  fmt::memory_buffer lines;
  const std::string time = fmt::format("{:.10g},", state.time);
  const core::InterfacePoint* last = nullptr;
  for (const auto& [arc, point] : points) {
    if (last && same_row(*last, *point)) continue;
    last = point;
    lines.append(time + core::csv_text(scene.tools.at(point->master_body - 1).name));
    add_line(scene, state, *point, arc, lines);
  }
  return fmt::to_string(lines);
}

}  // namespace parison::forming
