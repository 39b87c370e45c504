// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/state/initial_state.hpp"

#include <algorithm>

#include "core/mesh/tolerances.hpp"
#include "forming/state/skin_size.hpp"
#include "forming/state/start_temperature.hpp"
#include "remesh/mesher/mesh_profile.hpp"
#include "thermal/problem.hpp"

namespace parison::forming {

namespace {

/// Sizes of a body's first mesh, m: at the boundaries that have a skin the edge that resolves it.
remesh::ProfileSizes first_sizes(const Scene& scene, Index index, double size, double contact_size, double growth) {
  const Body& body = body_of(scene, index);
  remesh::ProfileSizes sizes;
  sizes.size = body.mesh.size.value_or(size);
  sizes.growth = body.mesh.growth.value_or(growth);
  sizes.fine_boundaries = contact_boundaries(body);
  sizes.has_skin = scene.has_heat();
  double edge = contact_edge(scene, index, contact_size);
  const Index last_stage = last_meshed_stage(scene);
  for (std::size_t b = 0; b < body.boundaries.size(); ++b) {
    const double wanted = sizes.fine_boundaries[b] ? contact_size : sizes.size;
    const double needed = surroundings_edge(scene, index, b, wanted, last_stage);
    if (needed >= wanted) continue;
    sizes.fine_boundaries[b] = true;
    edge = std::min(edge, needed);
  }
  sizes.contact_size = body.mesh.contact_size.value_or(edge);
  return sizes;
}

/// A mesh of the profile in which the temperatures at the start fit, as far as its cells suffice.
core::Mesh fitting_mesh(const Scene& scene, Index index, remesh::ProfileSizes sizes) {
  constexpr int most = 8;
  const Body& body = body_of(scene, index);
  core::Mesh mesh = remesh::mesh_profile(body.profile, sizes);
  const PlacedTemperature function = start_function(scene, index);
  for (int pass = 0; function && pass < most && mesh.cell_count() < 0.5 * scene.accuracy.max_cells; ++pass) {
    const FieldMisfit found = misfit(mesh, scene.geometry, start_temperature(scene, index, mesh), function);
    if (found.share() <= start_field_tolerance) break;
    const std::vector<double> wanted = fitting_sizes(mesh, found);
    sizes.sources.clear();
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
      const auto& nodes = mesh.cells()[cell];
      const Point middle = (mesh.nodes[nodes[0]] + mesh.nodes[nodes[1]] + mesh.nodes[nodes[2]]) / 3;
      sizes.sources.push_back({middle, wanted[cell], wanted[cell]});
    }
    mesh = remesh::mesh_profile(body.profile, sizes);
  }
  return mesh;
}

core::Mesh mesh_of(const Scene& scene, Index index, double size, double contact_size, double growth) {
  const Body& body = body_of(scene, index);
  const auto& mapped = body.mesh.mapped;
  core::Mesh mesh = mapped ? remesh::mesh_mapped(body.profile, mapped->along_first, mapped->along_second,
                                                 mapped->ratio_first, mapped->ratio_second)
                           : fitting_mesh(scene, index, first_sizes(scene, index, size, contact_size, growth));
  for (std::size_t i = 0; i < body.boundaries.size(); ++i) mesh.edit().boundaries[i].kind = body.boundaries[i].kind;
  return mesh;
}

/// Largest edge inside the gob, in edges on its surface.
constexpr double inner_glass_size = 4;

/// Where nothing flows the first meshes serve the whole run.
double edge_factor(const Scene& scene) {
  return scene.has_flow() ? 1.0 : static_edge_factor;
}

bool exists(const Scene& scene, Needs needs) {
  switch (needs) {
    case Needs::nothing:
      return true;
    case Needs::flow:
      return scene.has_flow();
    case Needs::gap_law:
      return scene.has_gap_law();
    case Needs::cooling:
      return false;  // until a stage cools the glass
    case Needs::heat_or_flow:
      return scene.has_heat() || scene.has_flow();
  }
  return false;
}

/// The mass of the glass in its mesh and temperatures.
void lay_initial_mass(const Scene& scene, GlassState& glass) {
  glass.mass_nodes = glass.mesh.nodes;
  glass.density = scene.glass.density();
  if (scene.expands()) glass.mass_temperature = glass.temperature;
  glass.mass = glass.density * relative_mass(scene, glass);
}

GlassState initial_glass(const Scene& scene) {
  const Accuracy& accuracy = scene.accuracy;
  GlassState glass;
  const double factor = edge_factor(scene);
  const double wanted = scene.has_flow() ? accuracy.surface_size : factor * accuracy.skin_size;
  glass.mesh = mesh_of(scene, glass_body, inner_glass_size * factor * accuracy.surface_size, wanted, edge_growth);
  for_each_glass_field([&](const auto& field) {
    if (!exists(scene, field.needs)) return;
    const auto size = field.components * place_count(field.location, glass.mesh);
    (glass.*field.values).resize(size);
    std::fill((glass.*field.values).begin(), (glass.*field.values).end(), field.at_rest());
  });
  if (glass.temperature.size() > 0) glass.temperature = start_temperature(scene, glass_body, glass.mesh);
  glass.initial_volume = core::volume(glass.mesh, scene.geometry);
  lay_initial_mass(scene, glass);
  return glass;
}

ToolState initial_tool(const Scene& scene, Index index) {
  const Tool& tool = scene.tools[index];
  const Accuracy& accuracy = scene.accuracy;
  ToolState state;
  const double factor = edge_factor(scene);
  state.mesh = mesh_of(scene, body_of_tool(index), core::tolerance::tool_edge * core::size(scene.glass.profile),
                       factor * accuracy.tool_contact_size, edge_growth);
  if (tool.thermal) state.temperature = start_temperature(scene, body_of_tool(index), state.mesh);
  state.heat_through.assign(state.mesh.boundaries().size(), 0);
  state.offset = tool.position;
  return state;
}

}  // namespace

core::Mesh mass_mesh(const GlassState& glass) {
  core::Mesh mesh = glass.mesh;
  mesh.nodes = glass.mass_nodes;
  return mesh;
}

double relative_mass(const Scene& scene, const core::Mesh& mesh, const Eigen::VectorXd& temperature) {
  if (!scene.expands()) return core::volume(mesh, scene.geometry);
  return core::integral(mesh, scene.geometry, temperature, scene.glass.relative_density());
}

double relative_mass(const Scene& scene, const GlassState& glass) {
  return relative_mass(scene, mass_mesh(glass), glass.mass_temperature);
}

void distribute_mass(const Scene& scene, const GlassState& before, GlassState& glass) {
  glass.mass_nodes = glass.mesh.nodes;
  if (scene.expands()) glass.mass_temperature = glass.temperature;
  glass.density = before.density * relative_mass(scene, before) / relative_mass(scene, glass);
}

double glass_heat(const Scene& scene, const State& state) {
  const core::Mesh mass = mass_mesh(state.glass);
  thermal::BodyView view{&mass, &mass, state.glass.density, &*scene.glass.thermal, {}, {}};
  if (scene.expands()) view.mass_temperature = &state.glass.mass_temperature;
  return thermal::heat_content(view, scene.geometry, state.glass.temperature);
}

State initial_state(const Scene& scene) {
  State state;
  state.glass = initial_glass(scene);
  for (std::size_t i = 0; i < scene.tools.size(); ++i)
    state.tools.push_back(initial_tool(scene, static_cast<Index>(i)));
  for (const auto& probe : scene.probes) state.probes.push_back(probe.point);
  if (scene.has_heat()) state.glass.initial_heat = glass_heat(scene, state);
  return state;
}

void set_start_temperature(const Scene& scene, State& state) {
  state.glass.temperature = start_temperature(scene, glass_body, state.glass.mesh);
  if (scene.expands()) lay_initial_mass(scene, state.glass);
  if (scene.has_heat()) state.glass.initial_heat = glass_heat(scene, state);
}

}  // namespace parison::forming
