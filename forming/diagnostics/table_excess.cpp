// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/diagnostics/table_excess.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/mesh/element.hpp"

namespace parison::forming {

namespace {

/// By how much a temperature lies beyond a range, K.
double beyond(double temperature, double coldest, double hottest) {
  return std::max({0.0, coldest - temperature, temperature - hottest});
}

bool is_table(const core::Table& table) {
  return table.x.size() > 1;
}

/// Change of a table at a temperature, had it gone on beyond its end; zero between its ends.
double missed_change(const core::Table& table, double temperature) {
  const std::size_t last = table.x.size() - 1, end = temperature < table.x.front() ? 0 : last - 1;
  const auto [least, most] = std::minmax_element(table.y.begin(), table.y.end());
  const double at_end = std::abs(table.y[end + 1] - table.y[end]) / (table.x[end + 1] - table.x[end]);
  const double in_the_mean = (*most - *least) / (table.x[last] - table.x[0]);
  return std::max(at_end, in_the_mean) * beyond(temperature, table.x.front(), table.x.back());
}

/// A property by a table, over the temperature of a body.
struct TabledProperty {
  double coldest, hottest;                ///< of the table, K
  std::function<double(double)> error;    ///< estimated relative error at a temperature, K
  std::function<bool(Index)> is_counted;  ///< nodes of the surface whose temperature matters; none: all of it
  bool in_volume = true;                  ///< whether the inside matters too
};

/// Mean of the error over the volume of a body, by the middles of the sides of its cells.
double mean_in_volume(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& error) {
  double sum = 0, volume = 0;
  for (const auto& cell : mesh.cells()) {
    const core::Point a = mesh.nodes[cell[0]], b = mesh.nodes[cell[1]] - a, c = mesh.nodes[cell[2]] - a;
    const double part = std::abs(b[0] * c[1] - b[1] * c[0]) * core::depth(geometry, a + (b + c) / 3);
    sum += part * (error[cell[3]] + error[cell[4]] + error[cell[5]]) / 3;
    volume += part;
  }
  return sum / volume;
}

/// Mean over the surface, or over its nodes that count.
double mean_on_surface(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& error,
                       const std::function<bool(Index)>& is_counted) {
  double sum = 0, surface = 0;
  for (const auto& edge : mesh.boundary_edges()) {
    const auto& n = edge.nodes;
    const BoundaryKind kind = mesh.kind_of(edge);
    if ((kind != BoundaryKind::contact && kind != BoundaryKind::air) || (is_counted && !is_counted(n[2]))) continue;
    const double part = (mesh.nodes[n[1]] - mesh.nodes[n[0]]).norm() * core::depth(geometry, mesh.nodes[n[2]]);
    sum += part * (error[n[0]] + 4 * error[n[2]] + error[n[1]]) / 6;
    surface += part;
  }
  return surface > 0 ? sum / surface : 0;
}

void follow(const TabledProperty& property, const core::Mesh& mesh, core::Geometry geometry,
            const Eigen::VectorXd& temperature, double dt, TableExcess& excess) {
  if (temperature.size() == 0) return;
  const double furthest = std::max(beyond(temperature.minCoeff(), property.coldest, property.hottest),
                                   beyond(temperature.maxCoeff(), property.coldest, property.hottest));
  if (furthest == 0) return;
  const Eigen::VectorXd error = temperature.unaryExpr([&](double T) {
    return beyond(T, property.coldest, property.hottest) > 0 ? std::min(1.0, property.error(T)) : 0.0;
  });
  double mean = mean_on_surface(mesh, geometry, error, property.is_counted);
  if (property.in_volume) mean = std::max(mean, mean_in_volume(mesh, geometry, error));
  if (mean == 0) return;
  excess.error = std::max(excess.error, mean);
  excess.furthest = std::max(excess.furthest, furthest);
  excess.seconds += dt;
}

/// Conductivity and heat capacity.
void follow_thermal(const Scene& scene, const State& state, Index body, double dt, TablesExcess& excess) {
  const Body& data = body_of(scene, body);
  if (!data.thermal) return;
  const thermal::Material& material = *data.thermal;
  const auto follow_table = [&](const core::Table& table, const std::function<double(double)>& value,
                                TableExcess& found) {
    if (!is_table(table)) return;
    const auto error = [&](double T) { return missed_change(table, T) / value(T); };
    follow({table.x.front(), table.x.back(), error, {}}, mesh_of(state, body), scene.geometry,
           temperature_of(state, body), dt, found);
  };
  follow_table(
      material.conductivity, [&](double T) { return thermal::conductivity(material, T); }, excess.conductivity);
  follow_table(
      material.heat_capacity, [&](double T) { return material.heat_capacity(T); }, excess.heat_capacity);
}

void follow_viscosity(const Scene& scene, const State& state, double dt, TableExcess& excess) {
  const flow::Viscosity& law = scene.glass.flow->viscosity;
  if (!law.table) return;
  const auto error = [&](double T) { return law.is_capped(T) ? 0 : law.table->error_beyond(T); };
  follow({law.table->coldest(), law.table->hottest(), error, {}}, state.glass.mesh, scene.geometry,
         state.glass.temperature, dt, excess);
}

void follow_friction(const Scene& scene, const State& state, Index tool, double dt, TableExcess& excess) {
  const auto& table = scene.tools[tool].friction.by_temperature;
  if (!table || !is_table(*table)) return;
  const auto touches = [&](Index node) { return state.glass.contact_tool[node] == tool; };
  const auto error = [&](double T) { return missed_change(*table, T); };  // of a logarithm
  follow({table->x.front(), table->x.back(), error, touches, false}, state.glass.mesh, scene.geometry,
         state.glass.temperature, dt, excess);
}

bool has_thermal_tables(const Body& body) {
  return body.thermal && (is_table(body.thermal->conductivity) || is_table(body.thermal->heat_capacity));
}

}  // namespace

bool has_property_tables(const Scene& scene) {
  return has_thermal_tables(scene.glass) || (scene.has_flow() && scene.glass.flow->viscosity.table) ||
         std::any_of(scene.tools.begin(), scene.tools.end(),
                     [](const Tool& tool) { return has_thermal_tables(tool) || tool.friction.by_temperature; });
}

void follow_tables(const Scene& scene, const State& state, Index body, double dt, TablesExcess& excess) {
  follow_thermal(scene, state, body, dt, excess);
  if (!scene.has_flow()) return;
  if (body == glass_body)
    follow_viscosity(scene, state, dt, excess.flow);
  else
    follow_friction(scene, state, body - body_of_tool(0), dt, excess.flow);
}

}  // namespace parison::forming
