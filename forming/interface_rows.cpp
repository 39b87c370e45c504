// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/interface_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "core/files.hpp"
#include "forming/glass_surface.hpp"
#include "forming/thermal_interface.hpp"
#include "forming/initial_state.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {
namespace {

double value_at(const Eigen::VectorXd& nodal, const std::array<Index, 3>& nodes, const std::array<double, 3>& shape) {
  return shape[0] * nodal[nodes[0]] + shape[1] * nodal[nodes[1]] + shape[2] * nodal[nodes[2]];
}

/// Arc length of interface points from the start of the glass surface.
class ArcOfPoints {
 public:
  ArcOfPoints(const Scene& scene, const core::Mesh& glass) {
    std::vector<bool> surface = symmetry_pieces(scene.glass, glass);
    surface.flip();
    for (const ChainEdge& edge : walk_surface(glass, surface)) edges_[glass.boundary[edge.edge].nodes[2]] = edge;
  }
  double operator()(const core::InterfacePoint& point) const {
    const ChainEdge& edge = edges_.at(point.slave_nodes[2]);
    const double along = point.slave_shape[1] + 0.5 * point.slave_shape[2];
    return edge.start + along * edge.length;
  }

 private:
  std::map<Index, ChainEdge> edges_;  ///< by mid-side node
};

double viscosity_at(const Scene& scene, double temperature) {
  return scene.has_flow() ? scene.glass.flow->viscosity(temperature) : std::numeric_limits<double>::quiet_NaN();
}

std::string line(const Scene& scene, const State& state, const core::InterfacePoint& point, double arc) {
  const double glass = value_at(state.bodies[0].temperature, point.slave_nodes, point.slave_shape);
  const double tool = value_at(state.bodies.at(point.master_body).temperature, point.master_nodes, point.master_shape);
  const double viscosity = viscosity_at(scene, glass);
  long table_holds = 0;
  const double h = point_conductance(scene, point, glass, table_holds).h;
  const double celsius = thermal::content_reference;
  return fmt::format("{:.10g},{},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g}\n",
                     state.time, core::csv_text(scene.tools.at(point.master_body - 1).name), 1e3 * arc,
                     1e3 * point.position[0], 1e3 * point.position[1], glass - celsius, tool - celsius, point.pressure,
                     viscosity, h, point.closure * h * (glass - tool), 1e6 * point.gap, point.closure);
}

}  // namespace

std::string interface_header() {
  return "time_s,tool,arc_mm,r_mm,z_mm,T_glass_C,T_tool_C,pressure_Pa,viscosity_Pa_s,h_W_m2K,flux_W_m2,gap_um,"
         "closure\n";
}

std::string interface_lines(const Scene& scene, const State& state,
                            const std::vector<core::InterfacePoint>& interface) {
  if (!scene.has_heat()) return {};
  const ArcOfPoints arc_of(scene, state.bodies[0].mesh);
  std::vector<std::pair<double, const core::InterfacePoint*>> points;
  for (const core::InterfacePoint& point : interface)
    if (point.closure > 0) points.push_back({arc_of(point), &point});
  std::stable_sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string lines;
  for (const auto& [arc, point] : points) lines += line(scene, state, *point, arc);
  return lines;
}

}  // namespace parison::forming
