// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/surface_change.hpp"

#include <algorithm>
#include <cmath>

#include "forming/thermal_interface.hpp"
#include "forming/initial_state.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {
namespace {

/// Temperatures of the glass at the interface's points, K.
Eigen::ArrayXd glass_temperatures(const Eigen::VectorXd& nodal, const std::vector<core::InterfacePoint>& interface) {
  Eigen::ArrayXd at = Eigen::ArrayXd::Zero(interface.size());
  for (std::size_t p = 0; p < interface.size(); ++p)
    for (int i = 0; i < 3; ++i) at[p] += interface[p].slave_shape[i] * nodal[interface[p].slave_nodes[i]];
  return at;
}

/// Times in which the contact brings the glass surface to the tool's temperature, s.
Eigen::ArrayXd relaxation_times(const Scene& scene, const std::vector<core::InterfacePoint>& interface,
                                const Eigen::ArrayXd& temperature) {
  const auto& glass = *scene.glass.thermal;
  const thermal::Conductivity conductivity(glass);
  long table_holds = 0;
  Eigen::ArrayXd h(temperature.size()), times(temperature.size());
  interface_law(scene, interface, table_holds)(interface, temperature, h, nullptr);
  const thermal::Enthalpy enthalpy(glass.heat_capacity);
  const Eigen::Index count = temperature.size(), batch = thermal::PointArray::SizeAtCompileTime;
  for (Eigen::Index first = 0; first < count; first += batch) {
    const Eigen::Index used = std::min(batch, count - first);
    thermal::PointArray T = thermal::PointArray::Constant(temperature[first]);
    T.head(used) = temperature.segment(first, used);
    const thermal::PointArray stored = conductivity(T, thermal::PointArray::Ones()) * glass.density * enthalpy.capacity(T);
    for (Eigen::Index i = 0; i < used; ++i) {
      const double closed = interface[first + i].closure * h[first + i];
      times[first + i] = stored[i] / (closed * closed);
    }
  }
  return times;
}

}  // namespace

double surface_temperature_change(const Scene& scene, const State& before, const State& after,
                                  const std::vector<core::InterfacePoint>& interface) {
  const Eigen::VectorXd &from = before.bodies[0].temperature, &to = after.bodies[0].temperature;
  Eigen::VectorXd change = (to - from).cwiseAbs();
  const Eigen::ArrayXd times = relaxation_times(scene, interface, glass_temperatures(from, interface));
  for (std::size_t p = 0; p < interface.size(); ++p)
    if (times[p] < scene.accuracy.first_step)
      for (const Index node : interface[p].slave_nodes) change[node] = 0;
  const core::Mesh& mesh = before.bodies[0].mesh;
  const auto symmetry = symmetry_pieces(scene.glass, mesh);
  double largest = 0;
  for (const auto& edge : mesh.boundary)
    if (!symmetry[edge.piece])
      for (const Index node : edge.nodes) largest = std::max(largest, change[node]);
  return largest;
}

}  // namespace parison::forming
