// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/heat/bounds/table_excess.hpp"

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
void follow_thermal(const Scene& scene, Index body, double dt, State& state, TablesExcess& excess) {
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

void follow_viscosity(const Scene& scene, double dt, State& state) {
  const flow::Viscosity& law = scene.glass.flow->viscosity;
  if (!law.table) return;
  const auto error = [&](double T) { return law.is_capped(T) ? 0 : law.table->error_beyond(T); };
  follow({law.table->coldest(), law.table->hottest(), error, {}}, state.glass.mesh, scene.geometry,
         state.glass.temperature, dt, state.glass.tables.flow);
}

void follow_friction(const Scene& scene, Index tool, double dt, State& state) {
  const auto& table = scene.tools[tool].friction.by_temperature;
  if (!table || !is_table(*table)) return;
  const auto touches = [&](Index node) { return state.glass.contact_tool[node] == tool; };
  const auto error = [&](double T) { return missed_change(*table, T); };  // of a logarithm
  follow({table->x.front(), table->x.back(), error, touches, false}, state.glass.mesh, scene.geometry,
         state.glass.temperature, dt, state.tools[tool].tables.flow);
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

void update_table_excess(const Scene& scene, double dt, State& state) {
  follow_thermal(scene, glass_body, dt, state, state.glass.tables);
  if (scene.has_flow()) follow_viscosity(scene, dt, state);
  for (Index tool = 0; tool < static_cast<Index>(state.tools.size()); ++tool) {
    follow_thermal(scene, body_of_tool(tool), dt, state, state.tools[tool].tables);
    if (scene.has_flow()) follow_friction(scene, tool, dt, state);
  }
}

}  // namespace parison::forming
