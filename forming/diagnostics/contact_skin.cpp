// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/diagnostics/contact_skin.hpp"

#include <cmath>
#include <limits>

#include "contact/conductance/conductance.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/state/skin_size.hpp"
#include "forming/step/heat/thermal_interface.hpp"

namespace parison::forming {

namespace {

/// Share of its greatest area below which a contact is over.
constexpr double lost_contact = 0.02;
/// Ratio of conductances from which on a contact begins anew: a pulse has a skin of its own.
constexpr double another_conductance = 4;

/// Height of the cell on each edge of a mesh's surface, m, by node: the least of those at a node.
Eigen::VectorXd surface_cells(const core::Mesh& mesh) {
  Eigen::VectorXd height = Eigen::VectorXd::Constant(mesh.node_count(), std::numeric_limits<double>::infinity());
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    const auto& cell = mesh.cells()[edge.cell];
    const core::Point a = mesh.nodes[cell[1]] - mesh.nodes[cell[0]], b = mesh.nodes[cell[2]] - mesh.nodes[cell[0]];
    const double length = (mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]]).norm();
    height[edge.nodes[2]] = std::abs(a[0] * b[1] - a[1] * b[0]) / length;  // each mid-side node has one edge
  }
  return height;
}

/// Of the contact of a tool that goes on.
double error_of(const Scene& scene, const State& state, Index tool, const ContactSkin& skin) {
  if (!(skin.area_time > 0) || !(skin.conductance > 0)) return 0;
  const double mean = 1 / skin.area_time, time = skin.area_time / skin.peak_area;
  const auto side = [&](Index body, double cell) {
    thermal::SkinSide result = skin_side(scene, body, mean * cell);
    result.depth = core::volume(mesh_of(state, body), scene.geometry) / skin.peak_area;
    return result;
  };
  return std::abs(thermal::skin_error(side(glass_body, skin.glass_cell), side(body_of_tool(tool), skin.tool_cell),
                                      mean * skin.conductance, time));
}

/// Whether a contact has become another one, by its area and conductance, each summed over its points.
bool is_another(const ContactSkin& skin, double area, double conductance) {
  if (!(skin.area_time > 0)) return false;
  if (area < lost_contact * skin.peak_area) return true;
  const double mean = skin.conductance / skin.area_time, now = conductance / area;
  return now > another_conductance * mean || mean > another_conductance * now;
}

/// Makes an end of a contact.
void close(const Scene& scene, const State& state, Index tool, ContactSkin& skin) {
  ContactSkin after;
  after.exchanged = skin.exchanged;
  after.wrong = skin.wrong + error_of(scene, state, tool, skin) * std::abs(skin.heat);
  skin = after;
}

/// What the interface of a step gives the skin at one tool.
struct Touch {
  double area = 0, conductance = 0, glass_cell = 0, tool_cell = 0;  ///< m2, W/K, m3, m3
};

/// By tool.
std::vector<Touch> touches(const Scene& scene, const State& state, const std::vector<core::InterfacePoint>& interface) {
  std::vector<Touch> found(state.tools.size());
  if (interface.empty()) return found;
  const Eigen::VectorXd cells = surface_cells(state.glass.mesh);
  std::vector<Eigen::VectorXd> of_tool(found.size());
  const FaceTemperatureArrays temperature = face_temperatures(state, interface);
  Eigen::ArrayXd h(interface.size());
  long clamped = 0;
  interface_law(scene, interface, state.time, clamped)(state.time, interface, {temperature.glass, temperature.tool}, h,
                                                       nullptr);
  for (std::size_t p = 0; p < interface.size(); ++p) {
    const core::InterfacePoint& point = interface[p];
    const std::size_t tool = point.master_body - body_of_tool(0);
    if (of_tool[tool].size() == 0) of_tool[tool] = surface_cells(state.tools[tool].mesh);
    const double weight = point.contact_weight * point.area;
    found[tool].area += weight;
    found[tool].conductance += weight * h[p];
    found[tool].glass_cell += weight * cells[point.slave_nodes[2]];
    found[tool].tool_cell += weight * of_tool[tool][point.master_nodes[2]];
  }
  return found;
}

}  // namespace

void follow_contact_skins(const Scene& scene, const State& before, const StepResult& step,
                          std::vector<ContactSkin>& skins) {
  const double dt = step.report.dt;
  const std::vector<Touch> touched = touches(scene, step.at_heat, step.report.interface);
  for (std::size_t tool = 0; tool < skins.size(); ++tool) {
    ContactSkin& skin = skins[tool];
    const Touch& touch = touched[tool];
    if (is_another(skin, touch.area, touch.conductance)) close(scene, step.at_heat, Index(tool), skin);
    const double heat = step.state.tools[tool].heat_received - before.tools[tool].heat_received;
    skin.exchanged += std::abs(heat);
    if (touch.area == 0) continue;
    skin.peak_area = std::max(skin.peak_area, touch.area);
    skin.area_time += dt * touch.area;
    skin.conductance += dt * touch.conductance;
    skin.glass_cell += dt * touch.glass_cell;
    skin.tool_cell += dt * touch.tool_cell;
    skin.heat += heat;
  }
}

double contact_skin_error(const Scene& scene, const State& state, Index tool, ContactSkin skin) {
  if (!(skin.exchanged > 0)) return std::numeric_limits<double>::quiet_NaN();
  close(scene, state, tool, skin);
  return skin.wrong / skin.exchanged;
}

}  // namespace parison::forming
