// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/surface_change.hpp"

#include <algorithm>
#include <cmath>

#include "forming/thermal_interface.hpp"
#include "forming/initial_state.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {
namespace {

/// Time in which the contact brings the glass surface to the tool's temperature, s.
double relaxation_time(const Scene& scene, const core::InterfacePoint& point, double temperature) {
  const auto& glass = *scene.glass.thermal;
  long table_holds = 0;
  const double h = point.closure * point_conductance(scene, point, temperature, table_holds).h;
  return thermal::conductivity(glass, temperature) * glass.density * glass.heat_capacity(temperature) / (h * h);
}

}  // namespace

double surface_temperature_change(const Scene& scene, const State& before, const State& after,
                                  const std::vector<core::InterfacePoint>& interface) {
  const Eigen::VectorXd &from = before.bodies[0].temperature, &to = after.bodies[0].temperature;
  Eigen::VectorXd change = (to - from).cwiseAbs();
  for (const auto& point : interface) {
    double temperature = 0;
    for (int i = 0; i < 3; ++i) temperature += point.slave_shape[i] * from[point.slave_nodes[i]];
    if (relaxation_time(scene, point, temperature) < scene.accuracy.first_step)
      for (const Index node : point.slave_nodes) change[node] = 0;
  }
  const core::Mesh& mesh = before.bodies[0].mesh;
  const auto symmetry = symmetry_pieces(scene.glass, mesh);
  double largest = 0;
  for (const auto& edge : mesh.boundary)
    if (!symmetry[edge.piece])
      for (const Index node : edge.nodes) largest = std::max(largest, change[node]);
  return largest;
}

}  // namespace parison::forming
