// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/element.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/report/files/history.hpp"
#include "forming/state/skin_history.hpp"
#include "forming/state/skin_size.hpp"

namespace parison::forming {

namespace {

/// Heat, as a share of the greatest exchange, below which the error of a tool's heat counts by its share of this.
constexpr double small_exchange = 0.02;
/// Share of the range of temperatures below which a body sees no jump.
constexpr double no_jump = 1e-6;

/// A skin of which the mesh gets the heat wrong.
struct Skin {
  double error = 0;
  std::string where;
};

Skin skin_at_tools(const Scene& scene, const State& state, const std::vector<ContactSkin>& skins) {
  double greatest = 0;
  for (const ContactSkin& skin : skins) greatest = std::max(greatest, skin.exchanged);
  Skin worst;
  for (std::size_t i = 0; i < skins.size(); ++i) {
    const double exchanged = skins[i].exchanged;
    if (!(exchanged > 0)) continue;
    const double error = contact_skin_error(scene, state, static_cast<Index>(i), skins[i]) *
                         std::min(1.0, exchanged / (small_exchange * greatest));
    if (is_worse(error, worst.error)) worst = {error, "at the contact with " + scene.tools[i].name};
  }
  return worst;
}

/// Mean height of the cells along a boundary, m, and the mesh's volume over the boundary's area, m.
struct BoundaryLayer {
  double first_cell = 0, depth = 0;
};

BoundaryLayer layer_under(const core::Mesh& mesh, Index boundary, core::Geometry geometry) {
  double area = 0, length = 0, surface = 0;
  for (const auto& edge : mesh.boundary_edges()) {
    if (edge.boundary_id != boundary) continue;
    const auto& cell = mesh.cells()[edge.cell];
    const core::Point a = mesh.nodes[cell[1]] - mesh.nodes[cell[0]], b = mesh.nodes[cell[2]] - mesh.nodes[cell[0]];
    area += std::abs(a[0] * b[1] - a[1] * b[0]);
    const double of_edge = (mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]]).norm();
    length += of_edge;
    surface += of_edge * core::depth(geometry, mesh.nodes[edge.nodes[2]]);
  }
  if (!(surface > 0)) return {};
  return {area / length, core::volume(mesh, geometry) / surface};
}

/// How long the stages up to the present one took, s: those before it, which may have ended early, in proportion to
/// their durations.
std::vector<double> durations_so_far(const Scene& scene, const State& state) {
  std::vector<double> durations;
  double planned = 0;
  for (Index s = 0; s < state.stage; ++s) planned += scene.stages[s].duration;
  for (Index s = 0; s < state.stage; ++s) durations.push_back(scene.stages[s].duration * state.stage_start / planned);
  durations.push_back(state.time - state.stage_start);
  return durations;
}

Skin skin_at_surroundings(const Scene& scene, const State& state) {
  Skin worst;
  const std::vector<double> durations = durations_so_far(scene, state);
  for (Index body = 0; body < body_count(state); ++body) {
    const Body& data = body_of(scene, body);
    if (!data.thermal) continue;
    for (std::size_t b = 0; b < data.boundaries.size(); ++b) {
      const BoundaryLayer layer = layer_under(mesh_of(state, body), static_cast<Index>(b), scene.geometry);
      if (layer.first_cell == 0) continue;
      thermal::SkinSide side = skin_side(scene, body, layer.first_cell);
      side.depth = layer.depth;
      const double error =
          thermal::skin_error(side, data.initial_temperature, surroundings_history(scene, body, b, durations));
      if (is_worse(error, worst.error))
        worst = {error, fmt::format("at boundary {} of {}", data.boundaries[b].name, data.name)};
    }
  }
  return worst;
}

Check thermal_skin(const Scene& scene, const State& state, const std::vector<ContactSkin>& skins) {
  const Skin tools = skin_at_tools(scene, state, skins), surroundings = skin_at_surroundings(scene, state);
  const Skin& worst = is_worse(tools.error, surroundings.error) ? tools : surroundings;
  return {"thermal_skin",
          worst.error,
          0.01,
          0.1,
          "%",
          fmt::format("the heat exchanged {} is wrong by about this, because the skin that cools or warms is thinner "
                      "than the first cells; smaller first cells (mesh.contact_size of the body, numerics.skin_size "
                      "for glass that flows) or a longer time help",
                      worst.where.empty() ? "anywhere" : worst.where),
          CheckKind::error};
}

/// Share of the jump that a body's surface has seen.
double share(double excess, const TemperatureBounds& bounds, double span, double time) {
  const double jump = bounds.hottest - bounds.coldest;
  return jump > no_jump * span && time > 0 ? excess / (jump * time) : 0;
}

Check overshoot(const Scene& scene, const std::vector<TemperatureBounds>& bounds, double time,
                double TemperatureBounds::*excess, const char* name, const char* direction) {
  const double span = temperature_range(scene).span();
  double worst = 0;
  std::string of = "the glass";
  for (std::size_t b = 0; b < bounds.size(); ++b)
    if (const double found = share(bounds[b].*excess, bounds[b], span, time); is_worse(found, worst)) {
      worst = found;
      if (b != glass_body) of = body_of(scene, Index(b)).name;
    }
  return {
      name,
      worst,
      0.1,
      0.5,
      "%",
      fmt::format("inside {} a temperature was {} all that its surface and its start had, in the mean over the run by "
                  "so much of the jump at the surface: the thermal boundary layer is thinner than the mesh resolves; "
                  "smaller first cells (mesh.contact_size of the body, numerics.skin_size for glass that flows) help",
                  of, direction),
      CheckKind::resolution};
}

}  // namespace

void add_heat_checks(const Scene& scene, const State& state, const Diagnostics& seen, Checks& checks) {
  checks.push_back({"energy_imbalance", glass_facts(scene, state).energy_imbalance, 5e-3, 5e-2, "%",
                    "so much of the heat that the glass lost is not explained by its change of heat content, and "
                    "heat and temperatures are wrong by about as much; a smaller numerics.temperature_tolerance helps",
                    CheckKind::error});
  checks.push_back({"interface_flux", seen.max_flux_mismatch, 1e-6, 1e-2, "%",
                    "the heat out of the glass and the heat into a tool differ; this is an error of the program, "
                    "please report it with the case"});
  checks.push_back(thermal_skin(scene, state, seen.skins));
  if (scene.has_light() || scene.enclosure)
    checks.push_back({"light", seen.light.heat > 0 ? seen.light.uncertain / seen.light.heat : 0, 0.01, 0.1, "%",
                      "the heat exchanged may be wrong by up to this: by so much do four parts of the rays that carry "
                      "light differ; more numerics.light_rays help",
                      CheckKind::error});
  checks.push_back(overshoot(scene, seen.bounds, state.time, &TemperatureBounds::overshoot, "overshoot", "above"));
  checks.push_back(overshoot(scene, seen.bounds, state.time, &TemperatureBounds::undershoot, "undershoot", "below"));
  if (scene.interfaces.empty()) return;
  checks.push_back({"conductance_table", static_cast<double>(seen.clamped_lookups), 0, no_limit, "",
                    "so many look-ups of a conductance table were outside its range and were clamped to its ends; a "
                    "table over a wider range of pressure and viscosity helps"});
}

}  // namespace parison::forming
