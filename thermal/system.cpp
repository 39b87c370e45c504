// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/system.hpp"

#include <algorithm>
#include <cassert>

namespace parison::thermal {

namespace {

const SurfaceExchange* exchange_of(const BodyView& body, Index piece) {
  if (body.exchange.empty() || !body.exchange[piece]) return nullptr;
  return &*body.exchange[piece];
}

void add_cells(HeatSystem& system, const BodyView& body, Index first_unknown) {
  const auto& rule = core::triangle_rule(4);
  const core::Geometry geometry = system.problem->geometry;
  const bool same = body.mesh == body.mass_mesh;
  const bool thin = body.wall_thickness && body.material->radiation;
  for (Index c = 0; c < body.mesh->cell_count(); ++c) {
    HeatCell cell;
    for (int i = 0; i < 6; ++i) cell.unknowns[i] = first_unknown + body.mesh->cells[c][i];
    for (std::size_t q = 0; q < rule.size(); ++q) {
      const core::CellPoint at = core::map_cell_point(*body.mesh, c, geometry, rule[q]);
      HeatPoint& point = cell.points[q];
      point.gradient = at.gradient;
      point.volume = at.volume;
      point.mass =
          body.density * (same ? at.volume : core::map_cell_point(*body.mass_mesh, c, geometry, rule[q]).volume);
      point.thin_wall = 1;
      if (thin) {
        double w = 0;  // linear: a quadratic through thicknesses that jump would turn negative
        for (int i = 0; i < 3; ++i) w += at.linear[i] * (*body.wall_thickness)[body.mesh->cells[c][i]];
        point.thin_wall = thin_wall_factor(*body.material->radiation, w);
      }
      point.source = body.source ? (*body.source)[c * rule.size() + q] : 0;
    }
    system.cells.push_back(cell);
  }
}

void add_edges(HeatSystem& system, Index body_index, Index first_boundary_edge) {
  const BodyView& body = system.problem->bodies[body_index];
  const auto& rule = core::edge_rule(3);
  for (std::size_t e = 0; e < body.mesh->boundary.size(); ++e) {
    const core::BoundaryEdge& boundary = body.mesh->boundary[e];
    const SurfaceExchange* exchange = exchange_of(body, boundary.piece);
    if (!exchange) continue;
    HeatEdge edge{{}, first_boundary_edge + static_cast<Index>(e), body_index, *exchange, {}};
    for (int i = 0; i < 3; ++i) {
      edge.unknowns[i] = system.first_unknown[body_index] + boundary.nodes[i];
      edge.area[i] = core::map_edge_point(*body.mesh, boundary.nodes, system.problem->geometry, rule[i]).area;
    }
    system.edges.push_back(edge);
  }
}

void add_prescribed(HeatSystem& system, const BodyView& body, Index first_unknown) {
  if (body.prescribed.empty()) return;
  for (const core::BoundaryEdge& edge : body.mesh->boundary) {
    if (!body.prescribed[edge.piece]) continue;
    for (const Index node : edge.nodes) {
      if (system.is_prescribed[first_unknown + node]) continue;
      system.is_prescribed[first_unknown + node] = 1;
      system.prescribed.emplace_back(first_unknown + node, *body.prescribed[edge.piece]);
    }
  }
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

void add_contacts(HeatSystem& system) {
  const auto air = exchange_by_mid_node(*system.problem);
  for (const core::InterfacePoint& point : system.problem->interface) {
    HeatContact contact{{}, &point, 0, {}, {}};
    for (int i = 0; i < 3; ++i) {
      contact.unknowns[i] = system.first_unknown[point.slave_body] + point.slave_nodes[i];
      contact.unknowns[i + 3] = system.first_unknown[point.master_body] + point.master_nodes[i];
    }
    if (const auto* exchange = air[point.slave_body][point.slave_nodes[2]]) contact.slave_air = *exchange;
    if (const auto* exchange = air[point.master_body][point.master_nodes[2]]) contact.master_air = *exchange;
    const std::pair pair{point.slave_body, point.master_body};
    const auto found = std::find(system.pairs.begin(), system.pairs.end(), pair);
    contact.pair = static_cast<Index>(found - system.pairs.begin());
    if (found == system.pairs.end()) system.pairs.push_back(pair);
    system.contacts.push_back(contact);
  }
}

}  // namespace

HeatSystem make_heat_system(const Problem& problem) {
  HeatSystem system;
  system.problem = &problem;
  system.first_unknown.push_back(0);
  for (const BodyView& body : problem.bodies) {
    assert(body.mesh->cell_count() == body.mass_mesh->cell_count());
    assert(body.exchange.empty() || body.exchange.size() == body.mesh->pieces.size());
    assert(body.prescribed.empty() || body.prescribed.size() == body.mesh->pieces.size());
    system.first_unknown.push_back(system.first_unknown.back() + body.mesh->node_count());
  }
  system.is_prescribed.assign(system.size(), 0);
  Index boundary_edges = 0;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const BodyView& body = problem.bodies[b];
    const Index first_cell = static_cast<Index>(system.cells.size());
    add_cells(system, body, system.first_unknown[b]);
    system.bodies.push_back({body.material, Enthalpy(body.material->heat_capacity), first_cell,
                             static_cast<Index>(system.cells.size())});
    add_edges(system, static_cast<Index>(b), boundary_edges);
    boundary_edges += static_cast<Index>(body.mesh->boundary.size());
    add_prescribed(system, body, system.first_unknown[b]);
  }
  add_contacts(system);
  return system;
}

Eigen::VectorXd join(const HeatSystem& system, const std::vector<Eigen::VectorXd>& temperature) {
  Eigen::VectorXd joined(system.size());
  for (std::size_t b = 0; b < temperature.size(); ++b) {
    assert(temperature[b].size() == system.first_unknown[b + 1] - system.first_unknown[b]);
    joined.segment(system.first_unknown[b], temperature[b].size()) = temperature[b];
  }
  return joined;
}

std::vector<Eigen::VectorXd> split(const HeatSystem& system, const Eigen::VectorXd& joined) {
  std::vector<Eigen::VectorXd> temperature;
  const auto& first = system.first_unknown;
  for (std::size_t b = 0; b + 1 < first.size(); ++b)
    temperature.push_back(joined.segment(first[b], first[b + 1] - first[b]));
  return temperature;
}

Index body_of(const HeatSystem& system, Index unknown) {
  const auto& first = system.first_unknown;
  return static_cast<Index>(std::upper_bound(first.begin(), first.end(), unknown) - first.begin() - 1);
}

Ledger empty_ledger(const HeatSystem& system) {
  Ledger ledger;
  ledger.bodies.resize(system.bodies.size());
  for (const auto& [slave, master] : system.pairs) ledger.pairs.push_back({slave, master, 0});
  return ledger;
}

void book(Ledger& ledger, const Flows& flows, double duration) {
  for (std::size_t b = 0; b < ledger.bodies.size(); ++b) {
    ledger.bodies[b].to_air += duration * flows.to_air[b];
    ledger.bodies[b].from_source += duration * flows.from_source[b];
  }
  for (std::size_t p = 0; p < ledger.pairs.size(); ++p) ledger.pairs[p].heat += duration * flows.across[p];
}

void book_content(Ledger& ledger, const HeatSystem& system, const Eigen::VectorXd& before,
                  const Eigen::VectorXd& after) {
  const Eigen::VectorXd change = after - before;
  for (std::size_t b = 0; b < ledger.bodies.size(); ++b)
    ledger.bodies[b].content_change +=
        change.segment(system.first_unknown[b], system.first_unknown[b + 1] - system.first_unknown[b]).sum();
}

double heat_content(const BodyView& body, core::Geometry geometry, const Eigen::VectorXd& temperature) {
  const Enthalpy enthalpy(body.material->heat_capacity);
  double content = 0;
  for (Index c = 0; c < body.mass_mesh->cell_count(); ++c)
    for (const auto& at : core::triangle_rule(4)) {
      const core::CellPoint point = core::map_cell_point(*body.mass_mesh, c, geometry, at);
      double T = 0;
      for (int i = 0; i < 6; ++i) T += point.shape[i] * temperature[body.mass_mesh->cells[c][i]];
      content += body.density * point.volume * enthalpy(T).h;
    }
  return content;
}

}  // namespace parison::thermal
