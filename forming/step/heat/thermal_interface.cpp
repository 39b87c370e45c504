// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/heat/thermal_interface.hpp"

#include <algorithm>

#include "contact/conductance/interface_conductance.hpp"
#include "contact/mortar/mortar.hpp"
#include "contact/unilateral/tool_gap.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/state/skin_size.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/heat/contact_opening.hpp"

namespace parison::forming {

namespace {

/// Gap of any point of the glass to a tool's outline.
std::function<double(const core::Point&)> exact_gaps(const Scene& scene, const State& state, Index tool, double reach) {
  const Body& body = scene.tools[tool];
  const core::Point displacement = state.tools[tool].offset * core::axis_direction();
  return [gap = contact::ToolGap(body.profile, contact_boundaries(body), reach), displacement](const core::Point& x) {
    return gap(x - displacement);
  };
}

std::vector<bool> held_nodes(const State& state, Index tool) {
  std::vector<bool> held(state.glass.contact_tool.size());
  for (std::size_t n = 0; n < held.size(); ++n) held[n] = state.glass.contact_tool[n] == tool;
  return held;
}

}  // namespace

std::vector<core::InterfacePoint> thermal_interface(const Scene& scene, const State& state) {
  const core::Mesh& glass = state.glass.mesh;
  const auto slave = contact::make_surface(glass_body, glass, core::boundaries_of_kind(glass, BoundaryKind::contact),
                                           core::Point::Zero());
  const auto nodes = contact_nodes(glass);
  // In transition gaps: of points on edges in contact, and of nodes, also of those behind the end of a contact.
  constexpr double point_reach = 10, node_reach = 40;
  std::vector<contact::Master> masters;
  for (std::size_t law = 0; law < scene.interfaces.size(); ++law) {
    const auto& interface = scene.interfaces[law];
    if (!scene.stages[state.stage].uses(interface.tool)) continue;
    const auto& tool = state.tools[interface.tool];
    const auto touches = core::boundaries_of_kind(tool.mesh, BoundaryKind::contact);
    masters.push_back(
        {contact::make_surface(body_of_tool(interface.tool), tool.mesh, touches, tool.offset * core::axis_direction()),
         tool_gaps(scene, state, nodes, interface.tool, node_reach * interface.transition_gap),
         interface.transition_gap, static_cast<Index>(law),
         exact_gaps(scene, state, interface.tool, point_reach * interface.transition_gap),
         held_nodes(state, interface.tool)});
  }
  auto interface = contact::build_interface(slave, state.glass.contact_pressure, masters, scene.geometry);
  set_openings(scene, state, interface);
  return interface;
}

FaceTemperatureArrays face_temperatures(const State& state, const std::vector<core::InterfacePoint>& interface) {
  FaceTemperatureArrays at{Eigen::ArrayXd::Zero(interface.size()), Eigen::ArrayXd::Zero(interface.size())};
  for (std::size_t p = 0; p < interface.size(); ++p) {
    const core::InterfacePoint& point = interface[p];
    const Eigen::VectorXd& tool = temperature_of(state, point.master_body);
    for (int i = 0; i < 3; ++i) {
      at.glass[p] += point.slave_shape[i] * state.glass.temperature[point.slave_nodes[i]];
      at.tool[p] += point.master_shape[i] * tool[point.master_nodes[i]];
    }
  }
  return at;
}

core::Conductance point_conductance(const Scene& scene, const core::InterfacePoint& point,
                                    const FaceTemperatures& temperature, long& clamped_lookups) {
  const Interface& interface = scene.interfaces[point.law];
  const double swabbing = scene.tools[interface.tool].swabbing;
  core::Conductance found;
  if (const auto* gap = std::get_if<contact::GapConductance>(&interface.law)) {
    const auto [h, derivative] = gap->at_opening(point.opening, core::Dual<double>{temperature.glass, 1},
                                                 core::Dual<double>{temperature.tool, 0});
    found = {h, derivative};
  } else {
    double viscosity = 1, derivative = 0;
    if (scene.has_flow()) {
      viscosity = scene.glass.flow->viscosity(temperature.glass);
      derivative = viscosity * scene.glass.flow->viscosity.log_derivative(temperature.glass);
    }
    const auto value = contact::conductance(interface.law, point.pressure, viscosity);
    clamped_lookups += value.clamped;
    found = {value.h, value.dh_deta * derivative};
  }
  if (swabbing != 1) found = {swabbing * found.h, swabbing * found.dh_dT};
  const double perfect = perfect_contact(scene, interface);
  return found.h >= perfect ? core::Conductance{perfect, 0} : found;
}

namespace {

/// Swabbing factor at each point of an interface; empty where all are 1.
Eigen::ArrayXd swabbing_factors(const Scene& scene, const std::vector<core::InterfacePoint>& interface) {
  if (std::all_of(scene.tools.begin(), scene.tools.end(), [](const Tool& tool) { return tool.swabbing == 1; }))
    return {};
  Eigen::ArrayXd factor(interface.size());
  for (std::size_t i = 0; i < interface.size(); ++i)
    factor[i] = scene.tools[scene.interfaces[interface[i].law].tool].swabbing;
  return factor;
}

}  // namespace

thermal::InterfaceLaw interface_law(const Scene& scene, const std::vector<core::InterfacePoint>& interface,
                                    double step_start, long& clamped_lookups) {
  std::vector<contact::ConductanceLaw> laws;
  for (const auto& each : scene.interfaces) laws.push_back(each.law);
  Eigen::ArrayXd perfect(interface.size());
  std::vector<double> perfect_of_law;
  for (const auto& each : scene.interfaces) perfect_of_law.push_back(perfect_contact(scene, each));
  for (std::size_t i = 0; i < interface.size(); ++i) perfect[i] = perfect_of_law[interface[i].law];
  return [&scene, &clamped_lookups, perfect, swabbing = swabbing_factors(scene, interface), step_start,
          law = contact::InterfaceConductance(laws, interface)](
             double time, const std::vector<core::InterfacePoint>& points,
             const thermal::InterfaceTemperatures& temperature, Eigen::ArrayXd& h, Eigen::ArrayXd* dh_dT) {
    const flow::Viscosity unknown{0, 0, 0, 1.0};
    const flow::Viscosity& viscosity = scene.has_flow() ? scene.glass.flow->viscosity : unknown;
    clamped_lookups += law(viscosity.logarithm(temperature.slave), h, dh_dT);
    if (dh_dT) *dh_dT = *dh_dT * viscosity.log_derivative(temperature.slave);
    if (scene.has_gap_law())
      law.set_gap_conductance(time - step_start, points, temperature.slave, temperature.master, h, dh_dT);
    if (swabbing.size() > 0) h *= swabbing;
    if (dh_dT && swabbing.size() > 0) *dh_dT *= swabbing;
    if (dh_dT) *dh_dT = (h < perfect).select(*dh_dT, 0.0);
    h = h.min(perfect);
  };
}

}  // namespace parison::forming
