// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/state/skin_size.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "forming/state/skin_history.hpp"
#include "forming/state/state.hpp"
#include "thermal/skin_history.hpp"

namespace parison::forming {

namespace {

/// Error of the heat that a first mesh may have from its first cells.
constexpr double skin_tolerance = 3e-3;
/// Share of the scene's range of temperatures below which two temperatures are the same.
constexpr double same_temperature = 1e-9;

bool differ(const Scene& scene, double first, double second) {
  return std::abs(second - first) > same_temperature * temperature_range(scene).span();
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
  double growth = data.mesh.growth.value_or(edge_growth);
  if (data.mesh.mapped) growth = std::max(growth, growth_of(*data.mesh.mapped));
  return {thermal::conductivity(material, temperature, 0), material.density * material.heat_capacity(temperature),
          first_cell, growth};
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

namespace {

/// Conductance of a contact without pressure, W/m2/K.
double lowest(const Scene& scene, const Interface& interface) {
  const double highest = contact::highest(interface.law);
  if (std::holds_alternative<contact::GapConductance>(interface.law)) return highest;
  const double viscosity = scene.has_flow() ? scene.glass.flow->viscosity(scene.glass.initial_temperature) : 1;
  return std::min(highest, contact::conductance(interface.law, 0, viscosity).h);
}

/// Of the contact of a body with one of another temperature, K, up to the end of a stage: perfect as the law lets it be
/// while the tool is active.
thermal::SkinHistory contact_history(const Scene& scene, const Interface& interface, double other, Index last_stage) {
  thermal::SkinHistory history;
  const double swabbing = scene.tools[interface.tool].swabbing, h = swabbing * contact::highest(interface.law);
  for (Index s = 0; s <= last_stage; ++s) {
    const Stage& stage = scene.stages[s];
    if (stage.uses(interface.tool))
      add_pressed_intervals(stage, {h, other}, swabbing * lowest(scene, interface), history);
    else
      add_interval(history, {stage.duration, {0, other}, {0, other}});
  }
  return history;
}

double edge_at_contact(const Scene& scene, const Interface& interface, Index body, double wanted, Index last_stage) {
  const double glass = scene.glass.initial_temperature, tool = scene.tools[interface.tool].initial_temperature;
  if (!scene.tools[interface.tool].thermal || !differ(scene, glass, tool)) return wanted;
  return thermal::fitting_first_cell(skin_side(scene, body, wanted), body == glass_body ? glass : tool,
                                     contact_history(scene, interface, body == glass_body ? tool : glass, last_stage),
                                     skin_tolerance);
}

}  // namespace

double glass_edge_at_tool(const Scene& scene, const Interface& interface, double wanted, Index last_stage) {
  return std::max(std::min(wanted, least_edge(scene, scene.glass)),
                  edge_at_contact(scene, interface, glass_body, wanted, last_stage));
}

double surroundings_edge(const Scene& scene, Index body, std::size_t boundary, double wanted, Index last_stage) {
  const Body& data = body_of(scene, body);
  if (!data.thermal) return wanted;
  std::vector<double> durations;
  for (Index s = 0; s <= last_stage; ++s) durations.push_back(scene.stages[s].duration);
  return std::max(std::min(wanted, least_edge(scene, data)),
                  thermal::fitting_first_cell(skin_side(scene, body, wanted), data.initial_temperature,
                                              surroundings_history(scene, body, boundary, durations), skin_tolerance));
}

Index last_meshed_stage(const Scene& scene) {
  auto last = static_cast<Index>(scene.stages.size()) - 1;
  while (last > 0 && scene.stages[last].cools) --last;
  return scene.stages[last].cools ? static_cast<Index>(scene.stages.size()) - 1 : last;
}

double contact_edge(const Scene& scene, Index body, double wanted) {
  const Body& data = body_of(scene, body);
  if (!data.thermal) return wanted;
  double edge = wanted;
  const Index last_stage = last_meshed_stage(scene);
  for (const Interface& interface : scene.interfaces)
    if (body == glass_body || body == body_of_tool(interface.tool))
      edge = edge_at_contact(scene, interface, body, edge, last_stage);
  return std::max(std::min(wanted, least_edge(scene, data)), edge);
}

}  // namespace parison::forming
