// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/light.hpp"

#include <cassert>

#include "thermal/system.hpp"

namespace parison::thermal {

namespace {

const core::Mesh& mesh_of(const Light& light, const HeatSystem& system) {
  return *system.problem->bodies[light.body].mesh;
}

bool same_laws(const Radiation& a, const Radiation& b) {
  if (a.model != b.model || a.refractive_index != b.refractive_index || a.bands.size() != b.bands.size()) return false;
  for (std::size_t k = 0; k < a.bands.size(); ++k)
    if (a.bands[k].up_to != b.bands[k].up_to || a.bands[k].absorption != b.bands[k].absorption ||
        a.bands[k].relative.x != b.bands[k].relative.x || a.bands[k].relative.y != b.bands[k].relative.y)
      return false;
  return true;
}

/// Pattern and symbolic factors for the mesh.
void analyse(KeptLight& kept, const core::Mesh& mesh, Index size) {
  core::Cliques cliques;
  for (const auto& nodes : mesh.cells()) cliques.add(nodes.data(), 6);
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) cliques.add(edge.nodes.data(), 3);
  kept.assembly = core::make_assembly(size, cliques);
  kept.cells = mesh.cells();
  kept.factor.clear();
  for (int k = 0; k < kept.laws.group_count(); ++k) {
    kept.factor.emplace_back();
    kept.factor.back().analyse(kept.assembly.matrix);
  }
}

void add_edges(Light& light, const HeatSystem& system, Index first_boundary_edge) {
  const BodyView& body = system.problem->bodies[light.body];
  const auto& rule = core::edge_rule(3);
  for (std::size_t e = 0; e < body.mesh->boundary_edges().size(); ++e) {
    const core::BoundaryEdge& boundary = body.mesh->boundary_edges()[e];
    const bool black = !body.prescribed.empty() && body.prescribed[boundary.boundary_id];
    if (!black && !body.light.surroundings[boundary.boundary_id]) continue;
    LightEdge edge{edge_unknowns(system, light.body, boundary.nodes),
                   boundary.nodes,
                   first_boundary_edge + static_cast<Index>(e),
                   boundary.nodes[2],
                   boundary.boundary_id,
                   black,
                   {},
                   edge_shapes()};
    for (int q = 0; q < 3; ++q) {
      edge.area[q] = core::map_edge_point(*body.mesh, boundary.nodes, system.problem->geometry, rule[q]).area;
    }
    light.edges.push_back(edge);
  }
}

/// Boundary of the glass that each of its edges' mid-side nodes lies on, by node.
std::vector<Index> boundaries_of_mid_nodes(const core::Mesh& mesh) {
  std::vector<Index> boundary(mesh.nodes.size());
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) boundary[edge.nodes[2]] = edge.boundary_id;
  return boundary;
}

void add_contacts(Light& light, const HeatSystem& system) {
  if (system.problem->interface.empty()) return;
  const auto& bodies = system.problem->bodies;
  const SurfaceLight& own = bodies[light.body].light;
  const std::vector<Index> boundaries = boundaries_of_mid_nodes(*bodies[light.body].mesh);
  for (const core::InterfacePoint& point : system.problem->interface) {
    assert(point.slave_body == light.body);
    const auto& shape = point.slave_shape;
    const Index boundary = boundaries[point.slave_nodes[2]];
    const bool open = bool(own.surroundings[boundary]);
    const double emissivity = bodies[point.master_body].light.emissivity;
    light.contacts.push_back({point.slave_nodes,
                              {shape[0], shape[1], shape[2]},
                              boundary,
                              open,
                              emissivity,
                              open ? own.emissivity : 0,
                              grey_exchange(own.emissivity, emissivity)});
  }
}

/// Adds coefficients times shape functions of the surface to a group's matrix. The points of the interface lie on edges
/// of the glass, whose cliques follow the cells'.
void assemble_surface(const Light& light, int group, const HeatSystem& system, Index first_boundary_edge,
                      core::SymmetricMatrix& matrix) {
  const core::Scatter& scatter = light.kept->assembly.scatter;
  const core::Mesh& mesh = mesh_of(light, system);
  constexpr Index count = 3;
  std::vector<Eigen::Matrix3d> local(mesh.boundary_edges().size(), Eigen::Matrix3d::Zero());
  for (const LightEdge& edge : light.edges)
    for (int q = 0; q < 3; ++q) {
      const Eigen::Map<const Eigen::Vector3d> shape(edge.shape[q].data());
      local[edge.boundary_edge - first_boundary_edge] +=
          light.coefficient(group, edge) * edge.area[q] * shape * shape.transpose();
    }
  if (!light.contacts.empty()) {
    const std::vector<Index> edge_of = edges_of_mid_nodes(mesh);
    for (std::size_t i = 0; i < light.contacts.size(); ++i) {
      const LightContact& contact = light.contacts[i];
      local[edge_of[system.problem->interface[i].slave_nodes[2]]] +=
          (light.to_tool(group, contact) - light.open(group, contact)) * system.interface.area[static_cast<Index>(i)] *
          contact.shape * contact.shape.transpose();
    }
  }
  for (std::size_t e = 0; e < local.size(); ++e) {
    std::array<double, 9> packed{};
    for (Index i = 0; i < count; ++i)
      for (Index j = 0; j <= i; ++j) packed[i * count + j] = local[e](i, j);
    core::add_clique(matrix, scatter, mesh.cell_count() + static_cast<Index>(e), count, packed.data());
  }
}

void factorise(Light& light, const HeatSystem& system, Index first_boundary_edge) {
  KeptLight& kept = *light.kept;
  const auto& cells = *system.bodies[light.body].cells;
  for (int k = 0; k < kept.laws.group_count(); ++k) {
    core::SymmetricMatrix& matrix = kept.assembly.matrix;
    std::fill(matrix.value.begin(), matrix.value.end(), 0.0);
    const LightGroup& group = kept.laws.group(k);
    assemble_group(cells, light.volumes, light.relative_of(k), mesh_of(light, system).cell_count(), group.diffusion,
                   group.absorption, kept.assembly);
    assemble_surface(light, k, system, first_boundary_edge, matrix);
    light.solvable = kept.factor[k].factorise(matrix) && light.solvable;
  }
}

/// Sets the absorption at the points where it depends on temperature.
void set_relative_absorption(Light& light, const BodyView& view) {
  light.kept->varies = absorption_varies(*view.material);
  if (!light.kept->varies) return;
  assert(view.absorption_at);
  const Field temperature = at_points(light.batches.data(), light.batches.size(), view.absorption_at->data());
  for (const Band& band : view.material->radiation->bands) {
    Field& relative = light.relative.emplace_back();
    if (band.relative.x.empty()) continue;
    relative = temperature;
    for (PointValues& values : relative)
      for (VectorizedArray& at : values)
        for (int lane = 0; lane < core::batch_size; ++lane) at[lane] = band.relative(at[lane]);
  }
}

}  // namespace

Light make_light(const HeatSystem& system, Index body, Index first_boundary_edge, std::shared_ptr<KeptLight>& kept) {
  const BodyView& view = system.problem->bodies[body];
  const core::Mesh& mesh = *view.mesh;
  assert(view.light.surroundings.size() == mesh.boundaries().size());
  if (!kept || !same_laws(kept->radiation, *view.material->radiation))
    kept = std::make_shared<KeptLight>(*view.material->radiation);
  Light light{body, mesh.node_count(), {}, {}, {}, {}, {}, {}, kept, true};
  light.batches.resize(core::batch_count(mesh.cell_count()));
  for (std::size_t b = 0; b < light.batches.size(); ++b)
    core::set_nodes(mesh.cells(), static_cast<Index>(b), light.batches[b]);
  light.volumes = make_volumes(view, system.problem->geometry);
  set_relative_absorption(light, view);
  add_edges(light, system, first_boundary_edge);
  add_contacts(light, system);
  if (view.material->radiation->model == Radiation::Model::transfer) {
    light.rays = make_ray_exchange(light, system, kept->rays);
    if (system.enclosure) light.enclosure = make_ray_enclosure(light, system);
  } else {
    if (kept->cells != mesh.cells()) analyse(*kept, mesh, light.size);
    factorise(light, system, first_boundary_edge);
  }
  return light;
}

}  // namespace parison::thermal
