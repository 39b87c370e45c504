// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/heat/surroundings.hpp"

#include <algorithm>

#include "forming/state/skin_size.hpp"

namespace parison::forming {

namespace {

/// Beyond this the surface has the temperature of what cools it; a larger h would only lose digits.
double perfect_cooling(const Scene& scene, Index body) {
  const double edge = body == glass_body ? scene.accuracy.skin_size : scene.accuracy.tool_contact_size;
  return thermal::perfect_conductance(skin_side(scene, body, edge).conductivity, edge);
}

/// Air over the time of the run.
thermal::SurfaceExchange in_run(const Air& air, double stage_start) {
  if (!air.of_stage) return air;
  return {air.h.later(stage_start), air.air_temperature.later(stage_start), air.emissivity,
          air.ambient_temperature.later(stage_start)};
}

bool sees_air(BoundaryKind kind) {
  return kind == BoundaryKind::contact || kind == BoundaryKind::air;
}

/// The air at a boundary of a body, over the time of the run.
thermal::SurfaceExchange air_at(const State& state, const Stage& stage, Index body, const std::string& boundary) {
  const bool is_inner = body == glass_body && stage.inner_air && boundary == inner_side;
  return in_run(is_inner ? *stage.inner_air : stage.air, state.stage_start);
}

/// What the stage gives a tool's boundary in place of its own cooling or the air; null for nothing.
const StageCooling* cooling_of_stage(const Stage& stage, Index body, std::size_t boundary) {
  for (const StageCooling& cooling : stage.cooling)
    if (body_of_tool(cooling.tool) == body && cooling.boundary == boundary) return &cooling;
  return nullptr;
}

std::optional<thermal::SurfaceExchange> exchange_of(const Scene& scene, const State& state, Index body,
                                                    const core::Mesh& mesh, std::size_t boundary) {
  const Stage& stage = scene.stages[state.stage];
  const auto& [name, kind] = mesh.boundaries()[boundary];
  const bool cooled = kind == BoundaryKind::cooled;
  if (!cooled && !sees_air(kind)) return std::nullopt;
  const Body& data = body_of(scene, body);
  thermal::SurfaceExchange exchange = cooled ? data.boundaries[boundary].cooling : air_at(state, stage, body, name);
  if (!cooled) exchange.emissivity = thermal::has_light(*data.thermal) ? 0 : data.emissivity;
  if (const StageCooling* own = cooling_of_stage(stage, body, boundary)) {
    exchange.h = own->h.later(state.stage_start);
    exchange.air_temperature = own->air_temperature.later(state.stage_start);
  }
  if (!cooled && exchange.h.max() == 0 && exchange.emissivity == 0) return std::nullopt;
  return exchange;
}

}  // namespace

std::vector<std::optional<thermal::SurfaceExchange>> surroundings(const Scene& scene, const State& state, Index body,
                                                                  const core::Mesh& mesh) {
  const double perfect = perfect_cooling(scene, body);
  std::vector<std::optional<thermal::SurfaceExchange>> result;
  for (std::size_t boundary = 0; boundary < mesh.boundaries().size(); ++boundary) {
    result.push_back(exchange_of(scene, state, body, mesh, boundary));
    if (auto& exchange = result.back(); exchange && exchange->h.max() > perfect)
      exchange->h = exchange->h.limited(perfect);
  }
  return result;
}

thermal::SurfaceExchange air_at_glass(const Scene& scene, const State& state, bool inside) {
  thermal::SurfaceExchange exchange = air_at(state, scene.stages[state.stage], glass_body, inside ? inner_side : "");
  exchange.emissivity = scene.glass.emissivity;
  return exchange;
}

thermal::SurfaceLight surface_light(const Scene& scene, const State& state, Index body, const core::Mesh& mesh) {
  thermal::SurfaceLight light{{}, body_of(scene, body).emissivity};
  const Stage& stage = scene.stages[state.stage];
  if (scene.enclosure && body != glass_body) {
    const Index tool = body - 1;
    light.offset = state.tools[tool].offset;
    light.in_place = stage.uses(tool);
  }
  const bool sees_others = scene.enclosure && light.in_place;
  if (!sees_others && !thermal::has_light(*body_of(scene, body).thermal)) return light;
  for (const auto& [name, kind] : mesh.boundaries())
    if (sees_air(kind))
      light.surroundings.emplace_back(air_at(state, stage, body, name).ambient_temperature);
    else
      light.surroundings.emplace_back();
  return light;
}

}  // namespace parison::forming
