// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/exchange.hpp"

#include <algorithm>

#include "thermal/system.hpp"

namespace parison::thermal {

namespace {

const SurfaceExchange* exchange_of(const BodyView& body, Index piece) {
  if (body.exchange.empty() || !body.exchange[piece]) return nullptr;
  return &*body.exchange[piece];
}

/// Exchange of the boundary edge with a given mid node, by node of every body.
std::vector<std::vector<const SurfaceExchange*>> exchange_by_mid_node(const Problem& problem) {
  std::vector<std::vector<const SurfaceExchange*>> result;
  for (const BodyView& body : problem.bodies) {
    result.emplace_back(body.mesh->node_count(), nullptr);
    for (const core::BoundaryEdge& edge : body.mesh->boundary)
      result.back()[edge.nodes[2]] = exchange_of(body, edge.piece);
  }
  return result;
}

}  // namespace

void add_edges(HeatSystem& system, Index body_index, Index first_boundary_edge) {
  const BodyView& body = system.problem->bodies[body_index];
  const auto& rule = core::edge_rule(3);
  for (std::size_t e = 0; e < body.mesh->boundary.size(); ++e) {
    const core::BoundaryEdge& boundary = body.mesh->boundary[e];
    const SurfaceExchange* exchange = exchange_of(body, boundary.piece);
    if (!exchange) continue;
    HeatEdge edge{edge_unknowns(system, body_index, boundary.nodes), first_boundary_edge + static_cast<Index>(e),
                  body_index, *exchange, {}, {}};
    for (int q = 0; q < 3; ++q) {
      edge.area[q] = core::map_edge_point(*body.mesh, boundary.nodes, system.problem->geometry, rule[q]).area;
      edge.shape[q] = unknown_weights(edge_shapes()[q], system.problem->order);
    }
    system.edges.push_back(edge);
  }
}

void add_contacts(HeatSystem& system) {
  system.contacts.reserve(system.problem->interface.size());
  const auto air = exchange_by_mid_node(*system.problem);
  for (const core::InterfacePoint& point : system.problem->interface) {
    const int order = system.problem->order;
    HeatContact contact{{}, unknown_weights(point.slave_shape, order), unknown_weights(point.master_shape, order),
                        &point, 0, {}, {}};
    const auto slave = edge_unknowns(system, point.slave_body, point.slave_nodes);
    const auto master = edge_unknowns(system, point.master_body, point.master_nodes);
    std::copy(slave.begin(), slave.end(), contact.unknowns.begin());
    std::copy(master.begin(), master.end(), contact.unknowns.begin() + 3);
    if (const auto* exchange = air[point.slave_body][point.slave_nodes[2]]) contact.slave_air = *exchange;
    if (const auto* exchange = air[point.master_body][point.master_nodes[2]]) contact.master_air = *exchange;
    const std::pair pair{point.slave_body, point.master_body};
    const auto found = std::find(system.pairs.begin(), system.pairs.end(), pair);
    contact.pair = static_cast<Index>(found - system.pairs.begin());
    if (found == system.pairs.end()) system.pairs.push_back(pair);
    system.contacts.push_back(contact);
  }
}

void add_exchange(const HeatSystem& system, const Eigen::VectorXd& temperature, Flows& flows, Eigen::VectorXd* power) {
  const auto take = [&](const Index* unknowns, const auto& shape, double heat) {
    if (power)
      for (int i = 0; i < 3; ++i) (*power)[unknowns[i]] -= shape[i] * heat;
  };
  for (const HeatEdge& edge : system.edges)
    for (int q = 0; q < 3; ++q) {
      const double T = interpolate(temperature, edge.unknowns.data(), edge.shape[q]);
      const double heat = edge.area[q] * surface_flux(edge.exchange, T).q;
      flows.to_air[edge.body] += heat;
      take(edge.unknowns.data(), edge.shape[q], heat);
    }
  for (const HeatContact& contact : system.contacts) {
    const core::InterfacePoint& point = *contact.point;
    const double closed = point.closure * point.area;
    if (closed == 0) continue;
    const Index *slave = contact.unknowns.data(), *master = slave + 3;
    const double T1 = interpolate(temperature, slave, contact.slave_shape);
    const double T2 = interpolate(temperature, master, contact.master_shape);
    const double across = closed * system.problem->law(point, T1).h * (T1 - T2);
    const double slave_air = contact.slave_air ? closed * surface_flux(*contact.slave_air, T1).q : 0;
    const double master_air = contact.master_air ? closed * surface_flux(*contact.master_air, T2).q : 0;
    for (int i = 0; i < 3; ++i) {
      flows.across[contact.pair] += contact.slave_shape[i] * across;
      flows.received[contact.pair] += contact.master_shape[i] * across;
    }
    flows.to_air[point.slave_body] -= slave_air;
    flows.to_air[point.master_body] -= master_air;
    take(slave, contact.slave_shape, across - slave_air);
    take(master, contact.master_shape, -across - master_air);
  }
}

}  // namespace parison::thermal
