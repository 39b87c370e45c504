// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/heat/thermal_interface.hpp"

#include <algorithm>

#include "contact/conductance/interface_conductance.hpp"
#include "contact/mortar/mortar.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/state/skin_size.hpp"
#include "forming/step/contact/contact_geometry.hpp"

namespace parison::forming {

std::vector<core::InterfacePoint> thermal_interface(const Scene& scene, const State& state) {
  const core::Mesh& glass = state.glass.mesh;
  const auto slave = contact::make_surface(glass_body, glass, core::boundaries_of_kind(glass, BoundaryKind::contact),
                                           core::Point::Zero());
  const auto nodes = contact_nodes(glass);
  const auto& active_tools = scene.stages[state.stage].tools;
  std::vector<contact::Master> masters;
  for (std::size_t law = 0; law < scene.interfaces.size(); ++law) {
    const auto& interface = scene.interfaces[law];
    if (std::none_of(active_tools.begin(), active_tools.end(), [&](const auto& t) { return t.tool == interface.tool; }))
      continue;
    const auto& tool = state.tools[interface.tool];
    const auto touches = core::boundaries_of_kind(tool.mesh, BoundaryKind::contact);
    masters.push_back(
        {contact::make_surface(body_of_tool(interface.tool), tool.mesh, touches, tool.offset * core::axis_direction()),
         tool_gaps(scene, state, nodes, interface.tool, 10 * interface.transition_gap), interface.transition_gap,
         static_cast<Index>(law)});
  }
  return contact::build_interface(slave, state.glass.contact_pressure, masters, scene.geometry);
}

core::Conductance point_conductance(const Scene& scene, const core::InterfacePoint& point, double temperature,
                                    long& clamped_lookups) {
  double viscosity = 1, derivative = 0;
  if (scene.has_flow()) {
    viscosity = scene.glass.flow->viscosity(temperature);
    derivative = viscosity * scene.glass.flow->viscosity.log_derivative(temperature);
  }
  const auto value = contact::conductance(scene.interfaces[point.law].law, point.pressure, viscosity);
  clamped_lookups += value.clamped;
  const double perfect = perfect_contact(scene, scene.interfaces[point.law]);
  if (value.h >= perfect) return {perfect, 0};
  return {value.h, value.dh_deta * derivative};
}

thermal::InterfaceLaw interface_law(const Scene& scene, const std::vector<core::InterfacePoint>& interface,
                                    long& clamped_lookups) {
  std::vector<contact::ConductanceLaw> laws;
  for (const auto& each : scene.interfaces) laws.push_back(each.law);
  Eigen::ArrayXd perfect(interface.size());
  std::vector<double> perfect_of_law;
  for (const auto& each : scene.interfaces) perfect_of_law.push_back(perfect_contact(scene, each));
  for (std::size_t i = 0; i < interface.size(); ++i) perfect[i] = perfect_of_law[interface[i].law];
  return [&scene, &clamped_lookups, perfect, law = contact::InterfaceConductance(laws, interface)](
             double, const std::vector<core::InterfacePoint>&, const Eigen::ArrayXd& temperature, Eigen::ArrayXd& h,
             Eigen::ArrayXd* dh_dT) {
    const flow::Viscosity unknown{0, 0, 0, 1.0};
    const flow::Viscosity& viscosity = scene.has_flow() ? scene.glass.flow->viscosity : unknown;
    clamped_lookups += law(viscosity.logarithm(temperature), h, dh_dT);
    if (dh_dT) *dh_dT = (h < perfect).select(*dh_dT * viscosity.log_derivative(temperature), 0.0);
    h = h.min(perfect);
  };
}

}  // namespace parison::forming
