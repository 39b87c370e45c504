// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/state/skin_size.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "forming/state/state.hpp"

namespace parison::forming {

namespace {

/// Error of the heat that a first mesh may have from its first cells.
constexpr double skin_tolerance = 3e-3;
/// Share of the scene's range of temperatures below which two temperatures are the same.
constexpr double same_temperature = 1e-9;

bool differ(const Scene& scene, double first, const core::TimeFunction& second) {
  const double small = same_temperature * temperature_range(scene).span();
  return std::abs(second.max() - first) > small || std::abs(second.min() - first) > small;
}

double run_time(const Scene& scene) {
  double time = 0;
  for (const Stage& stage : scene.stages) time += stage.duration;
  return time;
}

/// Cells for which a mesh has room: a layer of `wanted` edges that grow from there has a few cells for each.
double least_edge(const Scene& scene, const Body& body) {
  constexpr double cells_per_edge = 6;
  return cells_per_edge * core::size(body.profile) / scene.accuracy.max_cells;
}

/// Growth of the divisions of a mapped mesh along the direction in which they differ most.
double growth_of(const MeshSpec::Mapped& mapped) {
  const auto along = [](Index count, double ratio) {
    return count > 1 ? std::pow(std::max(ratio, 1 / ratio), 1.0 / (count - 1)) - 1 : 0.0;
  };
  return std::max(along(mapped.along_first, mapped.ratio_first), along(mapped.along_second, mapped.ratio_second));
}

}  // namespace

thermal::SkinSide skin_side(const Scene& scene, Index body, double first_cell) {
  const Body& data = body_of(scene, body);
  const thermal::Material& material = *data.thermal;
  const double temperature = data.initial_temperature;
  double growth =
      data.mesh.growth.value_or(body == glass_body ? scene.accuracy.glass_growth : scene.accuracy.tool_growth);
  if (data.mesh.mapped) growth = std::max(growth, growth_of(*data.mesh.mapped));
  return {thermal::conductivity(material, temperature, 0), material.density * material.heat_capacity(temperature),
          first_cell, growth, scene.accuracy.temperature_order};
}

double active_time(const Scene& scene, Index tool, Index last_stage) {
  double time = 0;
  for (Index s = 0; s <= last_stage; ++s)
    for (const StageTool& place : scene.stages[s].tools)
      if (place.tool == tool) time += scene.stages[s].duration;
  return time;
}

double perfect_contact(const Scene& scene, const Interface& interface) {
  if (!scene.glass.thermal || !scene.tools[interface.tool].thermal) return std::numeric_limits<double>::infinity();
  const auto layer = [&](Index body, double edge) {
    const thermal::SkinSide side = skin_side(scene, body, edge);
    return thermal::perfect_conductance(side.conductivity, edge);
  };
  const double glass = layer(glass_body, scene.accuracy.skin_size);
  const double tool = layer(body_of_tool(interface.tool), scene.accuracy.tool_contact_size);
  return 1 / (1 / glass + 1 / tool);
}

double glass_edge_at_tool(const Scene& scene, const Interface& interface, double wanted, Index last_stage) {
  const Tool& tool = scene.tools[interface.tool];
  if (!tool.thermal || !differ(scene, scene.glass.initial_temperature, tool.initial_temperature)) return wanted;
  return std::max(std::min(wanted, least_edge(scene, scene.glass)),
                  thermal::fitting_first_cell(skin_side(scene, glass_body, wanted), contact::highest(interface.law),
                                              active_time(scene, interface.tool, last_stage), skin_tolerance));
}

namespace {

/// The greatest h of what cools a boundary of a tool in the stages up to one, W/m2/K.
double stage_cooling(const Scene& scene, Index body, std::size_t boundary, Index last_stage) {
  double h = 0;
  for (Index s = 0; s <= last_stage; ++s)
    for (const StageCooling& cooling : scene.stages[s].cooling)
      if (body_of_tool(cooling.tool) == body && cooling.boundary == boundary &&
          differ(scene, body_of(scene, body).initial_temperature, cooling.air_temperature))
        h = std::max(h, cooling.h.max());
  return h;
}

/// Of air and radiation at the start, where they differ from the body, W/m2/K.
double air_conductance(const Scene& scene, const Body& body, const Air& air) {
  const double start = body.initial_temperature;
  double h = differ(scene, start, air.air_temperature) ? air.h.max() : 0;
  if (body.emissivity > 0 && differ(scene, start, air.ambient_temperature))
    h = std::max(h, 4 * body.emissivity * thermal::stefan_boltzmann *
                        std::pow(std::max(start, air.ambient_temperature.max()), 3));
  return h;
}

}  // namespace

double surroundings_conductance(const Scene& scene, Index body, std::size_t boundary, Index last_stage) {
  const Body& data = body_of(scene, body);
  const Boundary& given = data.boundaries[boundary];
  const double start = data.initial_temperature;
  if (given.kind == BoundaryKind::temperature)
    return differ(scene, start, given.temperature(0)) ? std::numeric_limits<double>::infinity() : 0;
  double h = stage_cooling(scene, body, boundary, last_stage);
  if (given.kind == BoundaryKind::cooled)
    return differ(scene, start, given.cooling.air_temperature) ? std::max(h, given.cooling.h.max()) : h;
  if (given.kind != BoundaryKind::contact && given.kind != BoundaryKind::air) return h;
  for (Index s = 0; s <= last_stage; ++s)
    for (const Air* air : airs_of(scene.stages[s]))
      if (body == glass_body || air == &scene.stages[s].air) h = std::max(h, air_conductance(scene, data, *air));
  return h;
}

double surroundings_edge(const Scene& scene, Index body, std::size_t boundary, double wanted) {
  const Body& data = body_of(scene, body);
  if (!data.thermal) return wanted;
  const double h = surroundings_conductance(scene, body, boundary, static_cast<Index>(scene.stages.size()) - 1);
  return std::max(std::min(wanted, least_edge(scene, data)),
                  thermal::fitting_first_cell(skin_side(scene, body, wanted), h, run_time(scene), skin_tolerance));
}

double contact_edge(const Scene& scene, Index body, double wanted) {
  const Body& data = body_of(scene, body);
  if (!data.thermal) return wanted;
  double edge = wanted;
  const Index last_stage = static_cast<Index>(scene.stages.size()) - 1;
  for (const Interface& interface : scene.interfaces) {
    if (body == glass_body) edge = glass_edge_at_tool(scene, interface, edge, last_stage);
    if (body != body_of_tool(interface.tool) ||
        !differ(scene, scene.glass.initial_temperature, data.initial_temperature))
      continue;
    edge = thermal::fitting_first_cell(skin_side(scene, body, edge), contact::highest(interface.law),
                                       active_time(scene, interface.tool, last_stage), skin_tolerance);
  }
  return std::max(std::min(wanted, least_edge(scene, data)), edge);
}

}  // namespace parison::forming
