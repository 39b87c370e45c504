// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/system.hpp"

#include <cassert>
#include <numeric>

#include "core/process/work_times.hpp"
#include "thermal/cells/cell_kernels.hpp"

namespace parison::thermal {

namespace {

using Batches = std::vector<CellBatch>;

std::shared_ptr<const Batches> batches_of(const BodyView& body, core::Geometry geometry, KeptCells* kept) {
  const core::Mesh &mesh = *body.mesh, &mass = *body.mass_mesh;
  if (!kept || has_thin_wall(body)) return std::make_shared<const Batches>(make_batches(body, geometry));
  if (!kept->batches || kept->geometry != geometry || kept->density != body.density || kept->cells != mesh.cells() ||
      kept->nodes != mesh.nodes || kept->mass_nodes != mass.nodes ||
      (body.mass_temperature && kept->mass_temperature != *body.mass_temperature))
    *kept = {mesh.nodes,   mass.nodes,  mesh.cells(),
             body.density, geometry,    std::make_shared<const Batches>(make_batches(body, geometry)),
             kept->light,  kept->views, body.mass_temperature ? *body.mass_temperature : Eigen::VectorXd()};
  return kept->batches;
}

/// Adds the unknowns of a body's cells, by cell and by batch of cells.
void add_unknowns(HeatSystem& system, const core::Mesh& mesh, Index first_unknown) {
  for (const auto& nodes : mesh.cells()) {
    auto& unknowns = system.cells.emplace_back();
    for (int i = 0; i < 6; ++i) unknowns[i] = first_unknown + nodes[i];
  }
  for (Index batch = 0; batch < core::batch_count(mesh.cell_count()); ++batch) {
    BatchIndices<6>& unknowns = system.batches.emplace_back();
    core::set_nodes(mesh.cells(), batch, unknowns);
    for (auto& of_node : unknowns)
      for (Index& unknown : of_node) unknown += first_unknown;
  }
}

void add_source(HeatSystem& system, const BodyLaws& laws, const std::vector<double>& source) {
  for (Index c = laws.first_cell; c < laws.last_cell; ++c) {
    const Eigen::Map<const Eigen::Matrix<double, 6, 1>> at(source.data() + 6 * (c - laws.first_cell));
    const Eigen::Matrix<double, 6, 1> own = cell_shapes<6>().value.transpose() * at;
    for (int i = 0; i < 6; ++i) system.source[system.cells[c][i]] += own[i];
  }
}

void add_prescribed(HeatSystem& system, const BodyView& body, Index body_index) {
  if (body.prescribed.empty()) return;
  for (const core::BoundaryEdge& edge : body.mesh->boundary_edges()) {
    if (!body.prescribed[edge.boundary_id]) continue;
    for (const Index unknown : edge_unknowns(system, body_index, edge.nodes))
      prescribe(system, {unknown, body_index, &*body.prescribed[edge.boundary_id],
                         system.first_boundary[body_index] + edge.boundary_id});
  }
}

/// Prepares the light in the glass and the enclosure's view factors.
void prepare_radiation(HeatSystem& system, const std::vector<Index>& first_boundary_edge,
                       std::vector<KeptCells>* kept) {
  const core::WorkTimer timer(&core::WorkTimes::radiation);
  if (system.problem->enclosure) {
    KeptTraces<TracedViews> none;
    system.enclosure = make_enclosure(system, kept ? kept->front().views : none);
  }
  for (std::size_t b = 0; b < system.problem->bodies.size(); ++b) {
    if (!has_light(*system.problem->bodies[b].material)) continue;
    std::shared_ptr<KeptLight> none;
    system.light.push_back(
        make_light(system, static_cast<Index>(b), first_boundary_edge[b], kept ? (*kept)[b].light : none));
  }
}

std::vector<std::pair<Index, Index>> nodes_and_boundaries(const Problem& problem) {
  std::vector<std::pair<Index, Index>> counts;
  for (const BodyView& body : problem.bodies) {
    assert(body.mesh->cell_count() == body.mass_mesh->cell_count());
    assert(body.exchange.empty() || body.exchange.size() == body.mesh->boundaries().size());
    assert(body.prescribed.empty() || body.prescribed.size() == body.mesh->boundaries().size());
    counts.emplace_back(body.mesh->node_count(), static_cast<Index>(body.mesh->boundaries().size()));
  }
  return counts;
}

}  // namespace

HeatSystem make_heat_system(const Problem& problem, std::vector<KeptCells>* kept) {
  HeatSystem system;
  system.problem = &problem;
  number_unknowns(system, nodes_and_boundaries(problem));
  std::size_t cells = 0;
  for (const BodyView& body : problem.bodies) cells += body.mesh->cells().size();
  system.cells.reserve(cells);
  system.batches.reserve(cells / batch_size + problem.bodies.size());
  if (kept) kept->resize(problem.bodies.size());
  Index boundary_edges = 0;
  std::vector<Index> first_boundary_edge;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const BodyView& body = problem.bodies[b];
    const auto first_cell = static_cast<Index>(system.cells.size()),
               first_batch = static_cast<Index>(system.batches.size());
    add_unknowns(system, *body.mesh, system.first_unknown[b]);
    system.bodies.push_back({Enthalpy(body.material->heat_capacity), Conductivity(*body.material), first_cell,
                             static_cast<Index>(system.cells.size()), first_batch,
                             batches_of(body, problem.geometry, kept ? &(*kept)[b] : nullptr)});
    if (body.source) {
      add_source(system, system.bodies.back(), *body.source);
      system.body_source[b] = std::accumulate(body.source->begin(), body.source->end(), 0.0);
    }
    add_edges(system, static_cast<Index>(b), boundary_edges);
    first_boundary_edge.push_back(boundary_edges);
    boundary_edges += static_cast<Index>(body.mesh->boundary_edges().size());
    add_prescribed(system, body, static_cast<Index>(b));
  }
  add_interface(system);
  prepare_radiation(system, first_boundary_edge, kept);
  return system;
}

TracedPlaces traced_places(const std::vector<KeptCells>& kept) {
  TracedPlaces places;
  for (const KeptCells& body : kept) {
    if (body.light && body.light->rays.last) {
      places.rays = body.light->rays.last->nodes;
      for (const SurfaceKind kind : body.light->rays.last->kinds) places.surfaces.push_back(static_cast<Index>(kind));
      for (const auto& band : body.light->rays.last->absorption)
        if (body.light->varies) places.absorption.insert(places.absorption.end(), band.begin(), band.end());
    }
    if (!body.views.last) continue;
    const TracedViews& views = *body.views.last;
    for (const auto& nodes : views.nodes) places.views.insert(places.views.end(), nodes.begin(), nodes.end());
    for (const auto& area : views.edge_open) places.open_area.insert(places.open_area.end(), area.begin(), area.end());
    for (const auto& area : views.edge_full) places.area.insert(places.area.end(), area.begin(), area.end());
  }
  return places;
}

std::array<Index, 3> edge_unknowns(const HeatSystem& system, Index body, const std::array<Index, 3>& nodes) {
  const Index first = system.first_unknown[body];
  return {first + nodes[0], first + nodes[1], first + nodes[2]};
}

double heat_content(const BodyView& body, core::Geometry geometry, const Eigen::VectorXd& temperature) {
  const Enthalpy enthalpy(body.material->heat_capacity);
  if (body.mass_temperature)
    return body.density * core::integral(*body.mass_mesh, geometry, temperature, *body.mass_temperature,
                                         [&, &relative = body.material->relative_density](double T, double then) {
                                           return relative(then) * enthalpy(T).h;
                                         });
  return body.density * core::integral(*body.mass_mesh, geometry, temperature, [&](double T) { return enthalpy(T).h; });
}

namespace {

/// Power of the volume source into each unknown, W.
Eigen::VectorXd source_power(const HeatSystem& system, const Eigen::VectorXd& factors) {
  Eigen::VectorXd power = system.source;
  for (Index b = 0; b < factors.size(); ++b) power.segment(system.first_unknown[b], system.size_of(b)) *= factors[b];
  return power;
}

/// Adds the heat by light and between the surfaces of an enclosure to the flows and, unless null, to the power into
/// each unknown, W.
void add_radiation(const HeatSystem& system, double time, const Eigen::VectorXd& temperature, Flows& flows,
                   Eigen::VectorXd* power) {
  const core::WorkTimer timer(&core::WorkTimes::radiation);
  for (const Light& light : system.light) add_light(light, system, time, temperature, flows, power);
  if (system.enclosure) add_enclosure(system, time, temperature, flows, power);
}

Response evaluate(const HeatSystem& system, double time, const Eigen::VectorXd& temperature,
                  const Eigen::VectorXd* rate) {
  const Eigen::VectorXd factors = source_factors(system.problem->bodies, time);
  Response response{Eigen::VectorXd::Zero(system.size()), source_power(system, factors), source_flows(system, factors)};
  add_cells(system, temperature, rate, response);
  add_exchange(system, time, temperature, response.flows, &response.power);
  add_radiation(system, time, temperature, response.flows, &response.power);
  return response;
}

}  // namespace

Response evaluate(const HeatSystem& system, double time, const Eigen::VectorXd& temperature) {
  return evaluate(system, time, temperature, nullptr);
}

Response evaluate(const HeatSystem& system, double time, const Eigen::VectorXd& temperature,
                  const Eigen::VectorXd& rate) {
  return evaluate(system, time, temperature, &rate);
}

Flows evaluate_flows(const HeatSystem& system, double time, const Eigen::VectorXd& temperature) {
  Flows flows = source_flows(system, source_factors(system.problem->bodies, time));
  add_exchange(system, time, temperature, flows, nullptr);
  add_radiation(system, time, temperature, flows, nullptr);
  return flows;
}

void impose_prescribed_rate(const HeatSystem& system, double time, Eigen::VectorXd& rate) {
  for (const PrescribedUnknown& at : system.prescribed) rate[at.unknown] = at.temperature->derivative(time);
}

}  // namespace parison::thermal
