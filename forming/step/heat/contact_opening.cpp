// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/heat/contact_opening.hpp"

#include <algorithm>

#include "forming/step/contact/contact_geometry.hpp"

namespace parison::forming {

namespace {

/// The interface whose tool is nearest to each node, -1 where all are farther than their transition gaps, and how near.
struct NearestTools {
  std::vector<Index> interface;
  Eigen::VectorXd gap;  ///< m
};

NearestTools nearest_tools(const Scene& scene, const State& state, const std::vector<Index>& nodes) {
  constexpr double reach = 2;  // transition gaps
  const Index count = state.glass.mesh.node_count();
  NearestTools nearest{std::vector<Index>(count, -1), Eigen::VectorXd::Constant(count, 1e300)};
  for (std::size_t i = 0; i < scene.interfaces.size(); ++i) {
    const Interface& interface = scene.interfaces[i];
    if (!scene.stages[state.stage].uses(interface.tool)) continue;
    const Eigen::VectorXd gap = tool_gaps(scene, state, nodes, interface.tool, reach * interface.transition_gap);
    for (const Index n : nodes)
      if (gap[n] < interface.transition_gap && gap[n] < nearest.gap[n]) {
        nearest.gap[n] = gap[n];
        nearest.interface[n] = static_cast<Index>(i);
      }
  }
  return nearest;
}

}  // namespace

double closing_rate(const Scene& scene, const contact::GapConductance& law, double pressure, double temperature) {
  return scene.has_flow() ? law.closing_rate(std::max(pressure, 0.0), scene.glass.flow->viscosity(temperature)) : 0;
}

double share_in_contact(double gap_before, double gap, double limit) {
  if (gap_before < limit) return 1;
  return (limit - gap) / (gap_before - gap);
}

void set_openings(const Scene& scene, const State& state, std::vector<core::InterfacePoint>& interface) {
  if (!scene.has_gap_law()) return;
  for (core::InterfacePoint& point : interface) {
    const auto* law = std::get_if<contact::GapConductance>(&scene.interfaces[point.law].law);
    if (!law) continue;
    double temperature = 0;
    point.opening = 0;
    for (int i = 0; i < 3; ++i) {
      temperature += point.slave_shape[i] * state.glass.temperature[point.slave_nodes[i]];
      point.opening += point.slave_shape[i] * state.glass.contact_opening[point.slave_nodes[i]];
    }
    // The interpolation may leave the range of openings at the front of a contact.
    point.opening = std::clamp(point.opening, 0.0, law->open_gap - law->touch_gap);
    point.closing_rate = closing_rate(scene, *law, point.pressure, temperature);
  }
}

void advance_openings(const Scene& scene, const State& before, double dt, State& after) {
  if (!scene.has_gap_law()) return;
  const auto nodes = contact_nodes(after.glass.mesh);
  const NearestTools now = nearest_tools(scene, after, nodes);
  std::vector<Eigen::VectorXd> gap_before(scene.interfaces.size());
  for (const Index n : nodes) {
    double& opening = after.glass.contact_opening[n];
    const Index at = now.interface[n];
    const auto* law = at < 0 ? nullptr : std::get_if<contact::GapConductance>(&scene.interfaces[at].law);
    if (!law) {
      opening = 0;
      continue;
    }
    const Interface& interface = scene.interfaces[at];
    if (gap_before[at].size() == 0)
      gap_before[at] = tool_gaps(scene, before, nodes, interface.tool, 1e3 * interface.transition_gap);
    const double share = before.glass.contact_opening[n] > 0
                             ? 1
                             : share_in_contact(gap_before[at][n], now.gap[n], interface.transition_gap);
    const double temperature = 0.5 * (before.glass.temperature[n] + after.glass.temperature[n]);
    const double rate = closing_rate(scene, *law, after.glass.contact_pressure[n], temperature);
    opening = law->opening_after(before.glass.contact_opening[n], rate, share * dt);
  }
}

}  // namespace parison::forming
