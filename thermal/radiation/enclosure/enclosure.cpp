// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/enclosure/enclosure.hpp"

#include <algorithm>
#include <utility>

#include "thermal/radiation/enclosure/view_tracing.hpp"
#include "thermal/system.hpp"

namespace parison::thermal {

namespace {

/// Emissive power of a black body in the part of the spectrum in which surfaces are grey: all of it, or beyond the
/// bands of the glass.
Emission grey_emission(const HeatSystem& system, double temperature) {
  if (!system.light.empty()) return system.light.front().laws().opaque_emission(temperature);
  const double cube = stefan_boltzmann * temperature * temperature * std::abs(temperature);
  return {cube * temperature, 4 * cube};
}

double value_at(const EnclosurePoint& point, const Eigen::VectorXd& values) {
  return interpolate(values, point.unknowns.data(), point.shape);
}

/// What the patches absorb of the excess, of the emissive powers of patches and surroundings, W/m2.
Eigen::ArrayXd grey_absorbed(const Enclosure& enclosure, const Eigen::ArrayXd& emitted,
                             const Eigen::ArrayXd& surroundings) {
  const Eigen::ArrayXd radiosity = enclosure.emissivity * emitted + (1 - enclosure.emissivity) * surroundings;
  return enclosure.emissivity * enclosure.grey.solve(excess_source(enclosure, radiosity, surroundings)).array();
}

}  // namespace

Eigen::ArrayXd surroundings_of(const Enclosure& enclosure, double time, const std::function<double(double)>& emission) {
  Eigen::ArrayXd emitted(static_cast<Eigen::Index>(enclosure.patches.size()));
  for (Eigen::Index p = 0; p < emitted.size(); ++p)
    emitted[p] = emission((*enclosure.patches[static_cast<std::size_t>(p)].surroundings)(time));
  return emitted;
}

Eigen::VectorXd excess_source(const Enclosure& enclosure, const Eigen::ArrayXd& radiosity,
                              const Eigen::ArrayXd& surroundings) {
  return (enclosure.views.between * radiosity.matrix()).array() -
         (enclosure.area - enclosure.views.open.array()) * surroundings;
}

void add_excess(const Enclosure& enclosure, const HeatSystem& system, const Eigen::ArrayXd& absorbed, Flows& flows,
                Eigen::VectorXd* power, Index but) {
  for (const EnclosurePoint& point : enclosure.points) {
    const EnclosurePatch& patch = enclosure.patches[static_cast<std::size_t>(point.patch)];
    const double heat = point.area * absorbed[point.patch];
    flows.to_air[patch.body] -= heat;
    flows.from_enclosure[patch.body] += heat;
    if (patch.body == but) continue;
    flows.exchanged[system.first_boundary[static_cast<std::size_t>(patch.body)] + patch.boundary] -= heat;
    if (power)
      for (int i = 0; i < 3; ++i) (*power)[point.unknowns[i]] += point.shape[i] * heat;
  }
}

void add_enclosure(const HeatSystem& system, double time, const Eigen::VectorXd& temperature, Flows& flows,
                   Eigen::VectorXd* power) {
  const Enclosure& enclosure = *system.enclosure;
  if (enclosure.patches.empty()) return;
  const auto emission = [&](double T) { return grey_emission(system, T).value; };
  const Eigen::ArrayXd emitted =
      patch_means(enclosure, [&](std::size_t i) { return emission(value_at(enclosure.points[i], temperature)); });
  const Eigen::ArrayXd absorbed = grey_absorbed(enclosure, emitted, surroundings_of(enclosure, time, emission));
  const Eigen::VectorXd before = flows.to_air;
  add_excess(enclosure, system, absorbed, flows, power);
  for (const Light& light : system.light)
    flows.light_to_air[light.body] += flows.to_air[light.body] - before[light.body];
}

Eigen::ArrayXd linearise_enclosure(const HeatSystem& system, const Eigen::VectorXd& temperature) {
  const Enclosure& enclosure = *system.enclosure;
  Eigen::ArrayXd derivatives(static_cast<Eigen::Index>(enclosure.points.size()));
  for (Eigen::Index i = 0; i < derivatives.size(); ++i)
    derivatives[i] =
        grey_emission(system, value_at(enclosure.points[static_cast<std::size_t>(i)], temperature)).derivative;
  return derivatives;
}

void apply_enclosure(const HeatSystem& system, const Eigen::ArrayXd& derivatives, double step,
                     const Eigen::VectorXd& change, Eigen::VectorXd& result) {
  const Enclosure& enclosure = *system.enclosure;
  if (enclosure.patches.empty()) return;
  const Eigen::ArrayXd emitted = patch_means(enclosure, [&](std::size_t i) {
    return derivatives[static_cast<Eigen::Index>(i)] * value_at(enclosure.points[i], change);
  });
  const Eigen::ArrayXd absorbed = grey_absorbed(enclosure, emitted, Eigen::ArrayXd::Zero(emitted.size()));
  for (const EnclosurePoint& point : enclosure.points)
    for (int i = 0; i < 3; ++i) result[point.unknowns[i]] -= step * point.shape[i] * point.area * absorbed[point.patch];
}

namespace {

/// Whether a boundary takes part: it sees the surroundings, and its temperature is not prescribed.
bool takes_part(const BodyView& body, Index boundary) {
  return !body.light.surroundings.empty() && body.light.surroundings[boundary] &&
         (body.prescribed.empty() || !body.prescribed[boundary]);
}

/// Calls what(body, edge, unknowns, shape, area) for each point of the surfaces and, with the area negative, of the
/// interface.
template <typename What>
void for_each_point(const HeatSystem& system, What&& what) {
  const Problem& problem = *system.problem;
  std::vector<std::vector<Index>> edge_of(problem.bodies.size());
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const core::Mesh& mesh = *problem.bodies[b].mesh;
    edge_of[b] = edges_of_mid_nodes(mesh);
    for (std::size_t e = 0; e < mesh.boundary_edges().size(); ++e) {
      const core::BoundaryEdge& edge = mesh.boundary_edges()[e];
      if (!takes_part(problem.bodies[b], edge.boundary_id)) continue;
      const auto unknowns = edge_unknowns(system, static_cast<Index>(b), edge.nodes);
      for (int q = 0; q < 3; ++q)
        what(static_cast<Index>(b), static_cast<Index>(e), unknowns, edge_shapes()[q],
             core::map_edge_point(mesh, edge.nodes, problem.geometry, core::edge_rule(3)[q]).area);
    }
  }
  for (std::size_t i = 0; i < problem.interface.size(); ++i) {
    const core::InterfacePoint& point = problem.interface[i];
    const double area = -system.interface.area[static_cast<Index>(i)];
    const auto side = [&](Index body, const std::array<Index, 3>& nodes, const std::array<double, 3>& shape) {
      const Index edge = edge_of[body][nodes[2]];
      if (takes_part(problem.bodies[body], problem.bodies[body].mesh->boundary_edges()[edge].boundary_id))
        what(body, edge, edge_unknowns(system, body, nodes), shape, area);
    };
    side(point.slave_body, point.slave_nodes, point.slave_shape);
    side(point.master_body, point.master_nodes, point.master_shape);
  }
}

/// Areas of the edges that take part: open, and in all.
std::pair<EdgeAreas, EdgeAreas> edge_areas(const HeatSystem& system) {
  EdgeAreas open, full;
  for (const BodyView& body : system.problem->bodies)
    open.emplace_back(body.mesh->boundary_edges().size(), 0.0), full.push_back(open.back());
  for_each_point(system, [&](Index body, Index edge, const auto&, const auto&, double area) {
    open[body][edge] += area;
    full[body][edge] += std::max(0.0, area);
  });
  return {std::move(open), std::move(full)};
}

void add_points(Enclosure& enclosure, const HeatSystem& system) {
  std::vector<std::vector<Index>> patch_of;
  patch_of.reserve(system.problem->bodies.size());
  for (const BodyView& body : system.problem->bodies) patch_of.emplace_back(body.mesh->boundary_edges().size(), -1);
  for (const OpenEdge& at : enclosure.traced->edges) patch_of[at.body][at.edge] = at.patch;
  for_each_point(system, [&](Index body, Index edge, const auto& unknowns, const auto& shape, double area) {
    if (patch_of[body][edge] >= 0) enclosure.points.push_back({unknowns, shape, area, patch_of[body][edge], edge});
  });
}

void add_patches(Enclosure& enclosure, const HeatSystem& system) {
  const TracedViews& traced = *enclosure.traced;
  enclosure.patches.resize(traced.views.open.size());
  for (const OpenEdge& at : traced.edges) {
    if (at.patch < 0) continue;
    const BodyView& body = system.problem->bodies[at.body];
    const Index boundary = body.mesh->boundary_edges()[at.edge].boundary_id;
    enclosure.patches[at.patch] = {at.body, boundary, body.light.emissivity, &*body.light.surroundings[boundary]};
  }
}

/// The traced views, closed for the areas that are open now. What is left of a patch that has been covered since takes
/// no part.
Views present_views(const TracedViews& traced, Eigen::ArrayXd& area) {
  Views views = traced.views;
  for (Eigen::Index p = 0; p < area.size(); ++p) {
    if (area[p] > covered * traced.full[p]) continue;
    area[p] = covered * traced.full[p];
    views.between.row(p).setZero(), views.between.col(p).setZero();
    views.open[p] = area[p];
  }
  return closed(std::move(views), area);
}

}  // namespace

std::shared_ptr<const Enclosure> make_enclosure(const HeatSystem& system, KeptTraces<TracedViews>& kept) {
  const auto [open, full] = edge_areas(system);
  const std::shared_ptr<const TracedViews> traced = views_that_serve(system, open, full, kept);
  auto enclosure = std::make_shared<Enclosure>();
  enclosure->traced = traced;
  add_patches(*enclosure, system);
  add_points(*enclosure, system);
  const auto count = static_cast<Eigen::Index>(enclosure->patches.size());
  enclosure->area.setZero(count), enclosure->emissivity.resize(count);
  for (const EnclosurePoint& point : enclosure->points) enclosure->area[point.patch] += point.area;
  for (Eigen::Index p = 0; p < count; ++p) enclosure->emissivity[p] = enclosure->patches[p].emissivity;
  enclosure->views = present_views(*traced, enclosure->area);
  if (count == 0) return enclosure;
  Eigen::MatrixXd radiosity = -enclosure->views.between * (1 - enclosure->emissivity).matrix().asDiagonal();
  radiosity.diagonal().array() += enclosure->area;
  enclosure->grey.compute(radiosity);
  return enclosure;
}

}  // namespace parison::thermal
