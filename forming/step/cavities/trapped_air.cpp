// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/cavities/trapped_air.hpp"

#include <algorithm>
#include <cmath>

#include "core/mesh/tolerances.hpp"
#include "forming/flow/contact/constraints.hpp"
#include "forming/step/cavities/air_cavities.hpp"
#include "forming/step/contact/contact_geometry.hpp"

namespace parison::forming {

namespace {

/// Volume over exposed area below which air between glass and tool escapes through the roughness, of the glass's size.
constexpr double roughness = core::tolerance::junction;

std::vector<OutlinedTool> outlined_tools(const Scene& scene, const State& state) {
  std::vector<OutlinedTool> tools;
  for (const StageTool& entry : scene.stages[state.stage].tools) {
    const Tool& tool = scene.tools[entry.tool];
    OutlinedTool outlined{entry.tool, &tool.profile, contact_boundaries(tool), {}, state.tools[entry.tool].offset};
    for (const auto& boundary : tool.boundaries)
      outlined.symmetry_boundaries.push_back(boundary.kind == BoundaryKind::symmetry);
    tools.push_back(std::move(outlined));
  }
  return tools;
}

/// Tools in contact with the nodes; before the first solve of a stage those that touch by their gap.
std::vector<Index> tools_in_contact(const Scene& scene, const State& state) {
  std::vector<Index> tools = state.glass.contact_tool;
  if (state.last_step > 0) return tools;
  const auto nodes = contact_nodes(state.glass.mesh);
  const double touching = core::tolerance::contact_after_remesh * core::size(scene.glass.profile);
  for (const StageTool& entry : scene.stages[state.stage].tools) {
    const auto gaps = tool_gaps(scene, state, nodes, entry.tool, touching);
    for (const Index node : nodes)
      if (tools[node] < 0 && gaps[node] <= touching) tools[node] = entry.tool;
  }
  return tools;
}

/// Shares of a cavity's exposed edges that belonged to each earlier cavity, and to the open.
struct Origin {
  std::vector<double> cavity;
  double open = 0;
};

Origin origin_of(const AirCavity& cavity, const core::Mesh& mesh, const CavityAir& before, double reach) {
  Origin origin{std::vector<double>(before.volume.size(), 0.0), 0};
  const double share = 1.0 / double(cavity.edges.size());
  for (const Index e : cavity.edges) {
    const Point& x = mesh.nodes[mesh.boundary_edges()[e].nodes[2]];
    double least = reach * reach;
    Index source = before.marker.empty() ? -1 : -2;  // at the start all surface was in the open
    for (std::size_t m = 0; m < before.marker.size(); ++m)
      if (const double distance = (before.marker[m] - x).squaredNorm(); distance < least) {
        least = distance;
        source = before.marker_cavity[m];
      }
    if (source == -1) origin.open += share;
    if (source >= 0) origin.cavity[source] += share;
  }
  return origin;
}

/// Whether the machine supplies the cavity, by a pressure on one of its boundaries.
bool is_supplied(const AirCavity& cavity, const core::Mesh& mesh, const Stage& stage) {
  return std::any_of(cavity.edges.begin(), cavity.edges.end(), [&](Index e) {
    return stage.pressure.count(mesh.boundaries()[mesh.boundary_edges()[e].boundary_id].name) > 0;
  });
}

/// The sealed cavities that hold their air, and the air of the step's start in each.
struct Sealed {
  std::vector<AirCavity> cavities;
  std::vector<double> energy, amount;
};

/// Divides the air of earlier cavities among those that have their surface, by volume. A cavity that comes from the
/// open has air of the stage, one that comes from contact none.
void share_air(const std::vector<Origin>& origins, const CavityAir& before, const TrappedAirLaw& law, Sealed& sealed) {
  const std::size_t count = sealed.cavities.size();
  for (std::size_t i = 0; i < count; ++i)
    sealed.energy.push_back(origins[i].open * law.ambient * sealed.cavities[i].volume);
  sealed.amount = sealed.energy;
  for (std::size_t k = 0; k < before.volume.size(); ++k) {
    double all = 0;
    for (std::size_t i = 0; i < count; ++i) all += origins[i].cavity[k] * sealed.cavities[i].volume;
    for (std::size_t i = 0; all > 0 && i < count; ++i) {
      const double part = origins[i].cavity[k] * sealed.cavities[i].volume / all;
      sealed.energy[i] += part * before.energy[k];
      sealed.amount[i] += part * before.amount[k];
    }
  }
}

/// Whether a cavity has opened in contact alone, so that it holds no air.
bool is_void(const Origin& origin, const CavityAir& before) {
  double energy = origin.open;
  for (std::size_t k = 0; k < origin.cavity.size(); ++k) energy += origin.cavity[k] * before.energy[k];
  return energy == 0;
}

Sealed sealed_cavities(const Scene& scene, const State& state, const ExposedGlass& glass, const TrappedAirLaw& law) {
  const double chord = scene.accuracy.surface_size,
               sagitta = core::tolerance::at_tool * core::size(scene.glass.profile);
  const auto outlines = tool_outlines(outlined_tools(scene, state), scene.geometry, chord, sagitta);
  Sealed sealed;
  std::vector<Origin> origins;
  for (auto& cavity : air_cavities(glass, outlines, Index(scene.tools.size()), law.seal_gap)) {
    if (is_supplied(cavity, glass.mesh, scene.stages[state.stage])) continue;
    const double thin = roughness * core::size(scene.glass.profile) * cavity.exposed_area;
    Origin origin = origin_of(cavity, glass.mesh, state.cavity_air, scene.accuracy.surface_size);
    if (cavity.volume < thin && !is_void(origin, state.cavity_air)) continue;
    cavity.volume = std::max(cavity.volume, 1e-6 * thin);
    sealed.cavities.push_back(std::move(cavity));
    origins.push_back(std::move(origin));
  }
  share_air(origins, state.cavity_air, law, sealed);
  return sealed;
}

/// What is behind each boundary edge: contact, or the air around the machine, but for the cavities. Contact on a
/// boundary with a pressure is supplied like the rest of it.
std::vector<Index> outside_of_cavities(const ExposedGlass& glass, const Stage& stage) {
  std::vector<Index> behind;
  for (std::size_t e = 0; e < glass.exposed.size(); ++e) {
    const auto& edge = glass.mesh.boundary_edges()[e];
    const bool touches = !glass.exposed[e] && glass.mesh.kind_of(edge) == BoundaryKind::contact &&
                         stage.pressure.count(glass.mesh.boundaries()[edge.boundary_id].name) == 0;
    behind.push_back(touches ? flow::no_air : flow::open_air);
  }
  return behind;
}

}  // namespace

void seal_air(StepStart& start) {
  const Scene& scene = start.scene;
  const State& state = start.state;
  const Stage& stage = scene.stages[state.stage];
  const TrappedAirLaw& law = *stage.trapped_air;
  const auto touching = tools_in_contact(scene, state);
  const core::Mesh& mesh = state.glass.mesh;
  const ExposedGlass glass{mesh, scene.geometry, exposed_edges(mesh, touching), touching};
  Sealed sealed = sealed_cavities(scene, state, glass, law);
  start.air = flow::TrappedAir{law.ambient, start.dt, outside_of_cavities(glass, stage), {}};
  const double vent = law.vent_area * std::sqrt(gas_constant_of_air * law.temperature);
  for (std::size_t i = 0; i < sealed.cavities.size(); ++i) {
    AirCavity& cavity = sealed.cavities[i];
    for (const Index e : cavity.edges) start.air->behind[e] = static_cast<Index>(i);
    start.air->pockets.push_back(
        {cavity.volume, sealed.energy[i], law.exponent, sealed.energy[i] > 0 ? vent : 0, std::move(cavity.tool_area)});
  }
  start.air_amount = std::move(sealed.amount);
}

void store_air(const StepStart& start, const flow::Solution& solution, State& state) {
  CavityAir& air = state.cavity_air;
  air = {};
  for (std::size_t i = 0; i < solution.pockets.size(); ++i) {
    const auto& pocket = solution.pockets[i];
    const auto& first = start.air->pockets[i];
    air.volume.push_back(std::max(pocket.volume, 1e-6 * first.volume));
    const double sealed = first.energy * std::pow(first.volume / air.volume.back(), first.exponent - 1);
    air.energy.push_back(std::max(0.0, sealed - first.exponent * pocket.outflow));
    air.amount.push_back(std::max(0.0, start.air_amount[i] - pocket.outflow));
  }
  const core::Mesh& mesh = start.state.glass.mesh;
  for (std::size_t e = 0; e < solution.exposed.size(); ++e) {
    const auto& edge = mesh.boundary_edges()[e];
    const auto kind = mesh.kind_of(edge);
    if (!solution.exposed[e] || (kind != BoundaryKind::contact && kind != BoundaryKind::air)) continue;
    const Index middle = edge.nodes[2];
    air.marker.push_back(mesh.nodes[middle] + start.dt * flow::node_velocity(solution.velocity, middle));
    air.marker_cavity.push_back(solution.air_behind[e]);
  }
  for (std::size_t t = 0; t < solution.tool_air_force.size(); ++t) state.tools[t].force += solution.tool_air_force[t];
}

}  // namespace parison::forming
