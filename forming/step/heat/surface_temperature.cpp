// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/heat/surface_temperature.hpp"

#include <algorithm>
#include <cmath>

#include "forming/state/initial_state.hpp"
#include "forming/step/heat/thermal_interface.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {
namespace {

/// Times in which the contact brings the glass surface to the tool's temperature, s.
Eigen::ArrayXd relaxation_times(const Scene& scene, const std::vector<core::InterfacePoint>& interface, double time,
                                const FaceTemperatureArrays& faces) {
  const auto& glass = *scene.glass.thermal;
  const thermal::Conductivity conductivity(glass);
  long clamped_lookups = 0;
  const Eigen::ArrayXd& temperature = faces.glass;
  Eigen::ArrayXd h(temperature.size()), times(temperature.size());
  interface_law(scene, interface, time, clamped_lookups)(time, interface, {faces.glass, faces.tool}, h, nullptr);
  const thermal::Enthalpy enthalpy(glass.heat_capacity);
  for (Eigen::Index i = 0; i < times.size(); ++i) {
    const double stored = conductivity(temperature[i]) * glass.density * enthalpy(temperature[i]).c;
    const double conductance = interface[i].contact_weight * h[i];
    times[i] = stored / (conductance * conductance);
  }
  return times;
}

/// Whether a contact brings the glass node to its tool's temperature in no time.
bool relaxes_at_once(const Scene& scene, const State& state, const std::vector<core::InterfacePoint>& interface,
                     Index node) {
  std::vector<core::InterfacePoint> of_node;
  for (const auto& point : interface)
    if (std::find(point.slave_nodes.begin(), point.slave_nodes.end(), node) != point.slave_nodes.end())
      of_node.push_back(point);
  const Eigen::ArrayXd times = relaxation_times(scene, of_node, state.time, face_temperatures(state, of_node));
  return (times < scene.accuracy.initial_step).any();
}

}  // namespace

double surface_temperature_change(const Scene& scene, const State& before, const State& after,
                                  const std::vector<core::InterfacePoint>& interface) {
  const core::Mesh& mesh = before.glass.mesh;
  const Eigen::VectorXd& from = before.glass.temperature;
  Eigen::VectorXd change = Eigen::VectorXd::Zero(mesh.node_count());
  for (const auto& edge : mesh.boundary_edges())
    if (mesh.kind_of(edge) != BoundaryKind::symmetry)
      for (const Index node : edge.nodes) change[node] = std::abs(after.glass.temperature[node] - from[node]);
  for (;;) {
    Eigen::Index largest = 0;
    const double found = change.maxCoeff(&largest);
    if (found == 0 || !relaxes_at_once(scene, before, interface, static_cast<Index>(largest))) return found;
    change[largest] = 0;
  }
}

}  // namespace parison::forming
