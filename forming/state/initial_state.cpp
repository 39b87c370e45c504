// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/state/initial_state.hpp"

#include <algorithm>
#include <cmath>

#include "remesh/mesher/mesh_profile.hpp"
#include "thermal/problem.hpp"

namespace parison::forming {

namespace {

core::Mesh mesh_of(const Body& body, double size, double contact_size, double growth) {
  if (const auto& mapped = body.mesh.mapped)
    return remesh::mesh_mapped(body.profile, mapped->along_first, mapped->along_second, mapped->ratio_first,
                               mapped->ratio_second);
  remesh::ProfileSizes sizes;
  sizes.size = body.mesh.size.value_or(size);
  sizes.contact_size = body.mesh.contact_size.value_or(contact_size);
  sizes.growth = body.mesh.growth.value_or(growth);
  sizes.fine_boundaries = contact_boundaries(body);
  return remesh::mesh_profile(body.profile, sizes);
}

/// Largest edge inside a tool, m.
constexpr double coarse_tool_size = 8e-3;
/// Largest edge inside the gob, in edges on its surface.
constexpr double inner_glass_size = 4;

}  // namespace

const Body& body_of(const Scene& scene, Index body) {
  return body == 0 ? static_cast<const Body&>(scene.glass) : scene.tools[body - 1];
}

BoundaryKind boundary_kind(const Body& body, const std::string& boundary) {
  for (const auto& known : body.boundaries)
    if (known.name == boundary) return known.kind;
  return BoundaryKind::contact;
}

std::vector<bool> symmetry_boundaries(const Body& body, const core::Mesh& mesh) {
  std::vector<bool> flags;
  for (const auto& name : mesh.boundary_names) flags.push_back(boundary_kind(body, name) == BoundaryKind::symmetry);
  return flags;
}

std::vector<bool> contact_boundaries(const Body& body, const core::Mesh& mesh) {
  std::vector<bool> flags;
  for (const auto& name : mesh.boundary_names) flags.push_back(boundary_kind(body, name) == BoundaryKind::contact);
  return flags;
}

std::vector<bool> contact_boundaries(const Body& body) {
  std::vector<bool> flags;
  for (const auto& boundary : body.boundaries) flags.push_back(boundary.kind == BoundaryKind::contact);
  return flags;
}

core::Mesh mass_mesh(const State& state) {
  core::Mesh mesh = state.bodies[0].mesh;
  mesh.nodes = state.mass_nodes;
  return mesh;
}

double glass_heat(const Scene& scene, const State& state) {
  const core::Mesh mass = mass_mesh(state);
  thermal::BodyView view{&mass, &mass, state.density, &*scene.glass.thermal, {}, {}};
  return thermal::heat_content(view, scene.geometry, state.bodies[0].temperature);
}

State initial_state(const Scene& scene) {
  const Accuracy& accuracy = scene.accuracy;
  State state;
  const auto bodies = 1 + static_cast<Index>(scene.tools.size());
  for (Index b = 0; b < bodies; ++b) {
    const Body& body = body_of(scene, b);
    BodyState start;
    // Where nothing flows the first meshes serve the whole run.
    const double fraction = scene.has_flow() ? 1.0 : static_edge_factor;
    const double contact_size = scene.has_flow() ? accuracy.surface_size : fraction * accuracy.skin_size;
    start.mesh =
        b == 0 ? mesh_of(body, inner_glass_size * fraction * accuracy.surface_size, contact_size, accuracy.glass_growth)
               : mesh_of(body, coarse_tool_size, fraction * accuracy.tool_contact_size, accuracy.tool_growth);
    if (body.thermal) start.temperature.setConstant(start.mesh.node_count(), body.initial_temperature);
    if (scene.has_flow() && b == 0 && !body.thermal)
      start.temperature.setConstant(start.mesh.node_count(), body.initial_temperature);
    start.offset = body.position;
    start.max_surface_temperature = body.initial_temperature;
    state.bodies.push_back(std::move(start));
  }
  const core::Mesh& glass = state.bodies[0].mesh;
  state.mass_nodes = glass.nodes;
  state.density = scene.has_heat() ? scene.glass.thermal->density : scene.has_flow() ? scene.glass.flow->density : 0;
  state.initial_volume = core::volume(glass, scene.geometry);
  if (scene.has_flow())
    state.velocity = state.acceleration = state.dilatation_mode = Eigen::VectorXd::Zero(core::dim * glass.node_count());
  state.contact.tool.assign(glass.nodes.size(), -1);
  state.contact.tool_before = state.contact.tool;
  state.contact.pressure.setZero(glass.node_count());
  for (const auto& probe : scene.probes) state.probes.push_back(probe.point);
  if (scene.has_heat()) state.initial_heat = glass_heat(scene, state);
  return state;
}

}  // namespace parison::forming
