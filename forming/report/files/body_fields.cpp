// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/files/body_fields.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

#include "core/mesh/element.hpp"
#include "remesh/surface/wall_thickness.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {
namespace {

void add_temperature(const Body& body, const Eigen::VectorXd& temperature, core::VtuFields& fields) {
  if (body.thermal)
    fields.nodal.push_back({"temperature_degC", (temperature.array() - thermal::content_reference).matrix()});
}

Eigen::VectorXd viscosity_field(const Scene& scene, const GlassState& glass) {
  return glass.temperature.unaryExpr([&](double temperature) { return scene.glass.flow->viscosity(temperature); });
}

void add_declared_fields(const Scene& scene, const GlassState& glass, core::VtuFields& fields) {
  for_each_glass_field([&](const auto& field) {
    const auto& values = glass.*field.values;
    const bool written = field.needs == Needs::gap_law          ? scene.has_gap_law()
                         : field.output == FieldOutput::celsius ? scene.has_heat()
                                                                : scene.has_flow();
    if (field.output == FieldOutput::none || !written) return;
    const double offset = field.output == FieldOutput::celsius ? thermal::content_reference : 0;
    const double scale = field.output == FieldOutput::millimetre ? 1e3 : 1;
    using Stored = typename std::decay_t<decltype(values)>::value_type;
    const Eigen::Map<const Eigen::Array<Stored, Eigen::Dynamic, 1>> stored(values.data(), Index(values.size()));
    fields.nodal.push_back({field.output_name, (scale * (stored.template cast<double>() - offset)).matrix()});
  });
}

double volume_of(const core::Mesh& mesh, core::Geometry geometry, Index cell) {
  double volume = 0;
  for (const core::TriangleRulePoint& at : core::triangle_rule(4))
    volume += core::map_cell_point(mesh, cell, geometry, at).volume;
  return volume;
}

}  // namespace

Eigen::VectorXd conducted_flux(const core::Mesh& mesh, core::Geometry geometry, const thermal::Material& material,
                               const Eigen::VectorXd& temperature, const Eigen::VectorXd& wall_thickness) {
  Eigen::VectorXd flux = Eigen::VectorXd::Zero(core::dim * mesh.node_count());
  Eigen::VectorXd around = Eigen::VectorXd::Zero(mesh.node_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto& nodes = mesh.cells()[cell];
    const double volume = volume_of(mesh, geometry, cell);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const core::CellPoint point = core::map_cell_point(mesh, cell, geometry, core::triangle_nodes[k]);
      Point gradient = Point::Zero();
      for (std::size_t i = 0; i < nodes.size(); ++i) gradient += temperature[nodes[i]] * point.gradient[i];
      flux.segment<core::dim>(core::dim * nodes[k]) += volume * gradient;
      around[nodes[k]] += volume;
    }
  }
  for (Index node = 0; node < mesh.node_count(); ++node) {
    const double thin_wall =
        material.radiation ? thermal::thin_wall_factor(*material.radiation, wall_thickness[node]) : 1;
    flux.segment<core::dim>(core::dim * node) *=
        -thermal::conductivity(material, temperature[node], thin_wall) / around[node];
  }
  return flux;
}

core::VtuFields glass_output(const Scene& scene, const State& state) {
  const GlassState& glass = state.glass;
  core::VtuFields fields;
  fields.time = state.time;
  add_declared_fields(scene, glass, fields);
  if (scene.has_flow()) fields.nodal.push_back({"viscosity_Pa_s", viscosity_field(scene, glass)});
  const Eigen::VectorXd wall = remesh::wall_thickness(glass.mesh);
  fields.nodal.push_back({"wall_thickness_mm", 1e3 * wall});
  if (scene.has_heat())
    fields.nodal.push_back(
        {"heat_flux_W_m2", conducted_flux(glass.mesh, scene.geometry, *scene.glass.thermal, glass.temperature, wall)});
  return fields;
}

core::VtuFields tool_output(const Scene& scene, const State& state, Index tool) {
  const ToolState& body = state.tools[tool];
  const auto& present = scene.stages.at(state.stage).tools;
  const bool active = std::any_of(present.begin(), present.end(), [&](const StageTool& t) { return t.tool == tool; });
  core::VtuFields fields;
  fields.time = state.time;
  fields.displacement = body.offset * core::axis_direction();
  add_temperature(scene.tools[tool], body.temperature, fields);
  fields.cell.push_back({"active", active ? 1.0 : 0.0});
  return fields;
}

}  // namespace parison::forming
