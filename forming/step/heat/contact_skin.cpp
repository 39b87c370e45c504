// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/heat/contact_skin.hpp"

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

}  // namespace

void update_contact_skins(const Scene& scene, const std::vector<core::InterfacePoint>& interface, double dt,
                          const std::vector<double>& heat_before, State& state) {
  const std::size_t tools = state.tools.size();
  std::vector<double> area(tools), conductance(tools), glass_cell(tools), tool_cell(tools);
  if (!interface.empty()) {
    const Eigen::VectorXd cells = surface_cells(state.glass.mesh);
    std::vector<Eigen::VectorXd> of_tool(tools);
    const FaceTemperatureArrays temperature = face_temperatures(state, interface);
    Eigen::ArrayXd h(interface.size());
    long clamped = 0;
    interface_law(scene, interface, state.time, clamped)(state.time, interface, {temperature.glass, temperature.tool},
                                                         h, nullptr);
    for (std::size_t p = 0; p < interface.size(); ++p) {
      const core::InterfacePoint& point = interface[p];
      const std::size_t tool = point.master_body - body_of_tool(0);
      if (of_tool[tool].size() == 0) of_tool[tool] = surface_cells(state.tools[tool].mesh);
      const double weight = point.contact_weight * point.area;
      area[tool] += weight;
      conductance[tool] += weight * h[p];
      glass_cell[tool] += weight * cells[point.slave_nodes[2]];
      tool_cell[tool] += weight * of_tool[tool][point.master_nodes[2]];
    }
  }
  for (std::size_t tool = 0; tool < tools; ++tool) {
    ContactSkin& skin = state.tools[tool].skin;
    if (is_another(skin, area[tool], conductance[tool])) close(scene, state, Index(tool), skin);
    const double heat = state.tools[tool].heat_received - heat_before[tool];
    skin.exchanged += std::abs(heat);
    if (area[tool] == 0) continue;
    skin.peak_area = std::max(skin.peak_area, area[tool]);
    skin.area_time += dt * area[tool];
    skin.conductance += dt * conductance[tool];
    skin.glass_cell += dt * glass_cell[tool];
    skin.tool_cell += dt * tool_cell[tool];
    skin.heat += heat;
  }
}

double contact_skin_error(const Scene& scene, const State& state, Index tool) {
  ContactSkin skin = state.tools[tool].skin;
  if (!(skin.exchanged > 0)) return std::numeric_limits<double>::quiet_NaN();
  close(scene, state, tool, skin);
  return skin.wrong / skin.exchanged;
}

}  // namespace parison::forming
