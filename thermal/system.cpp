// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/system.hpp"

#include <algorithm>
#include <cassert>

namespace parison::thermal {

namespace {

/// Jacobian of a cell's map at a point of triangle_rule(4).
struct Map {
  core::Point along_a, along_b;  ///< derivatives of the position
  double determinant, depth;
};
Map map_at(const core::Mesh& mesh, Index cell, core::Geometry geometry, std::size_t q) {
  const CellShapes<6>& shapes = cell_shapes<6>();
  core::Point x = core::Point::Zero(), u = x, v = x;
  for (int i = 0; i < 6; ++i) {
    const core::Point& node = mesh.nodes[mesh.cells[cell][i]];
    x += shapes.value(q, i) * node;
    u += shapes.slope_a(q, i) * node;
    v += shapes.slope_b(q, i) * node;
  }
  return {u, v, u[0] * v[1] - u[1] * v[0], core::depth(geometry, x)};
}

/// Linear in the cell: a quadratic through thicknesses that jump would turn negative.
double thickness_at(const BodyView& body, Index cell, std::size_t q) {
  double w = 0;
  for (int i = 0; i < 3; ++i) w += cell_shapes<3>().value(q, i) * (*body.wall_thickness)[body.mesh->cells[cell][i]];
  return w;
}

void add_cells(HeatSystem& system, const BodyView& body, Index first_unknown) {
  const auto& rule = core::triangle_rule(4);
  const core::Geometry geometry = system.problem->geometry;
  const bool same = body.mesh == body.mass_mesh;
  const bool thin = body.wall_thickness && body.material->radiation;
  const int used = system.problem->order == 2 ? 6 : 3;
  for (Index c = 0; c < body.mesh->cell_count(); ++c) {
    HeatCell& cell = system.cells.emplace_back();
    for (int i = 0; i < used; ++i) cell.unknowns[i] = first_unknown + body.mesh->cells[c][i];
    for (std::size_t q = 0; q < rule.size(); ++q) {
      const Map map = map_at(*body.mesh, c, geometry, q);
      const double scale = rule[q].weight * map.depth / map.determinant;
      cell.aa[q] = scale * map.along_b.squaredNorm();
      cell.ab[q] = -scale * map.along_a.dot(map.along_b);
      cell.bb[q] = scale * map.along_a.squaredNorm();
      const Map then = same ? map : map_at(*body.mass_mesh, c, geometry, q);
      cell.mass[q] = body.density * rule[q].weight * then.determinant * then.depth;
      cell.thin_wall[q] = thin ? thin_wall_factor(*body.material->radiation, thickness_at(body, c, q)) : 1;
    }
  }
}

template <int N>
void add_source(HeatSystem& system, const BodyLaws& laws, const std::vector<double>& source) {
  for (Index c = laws.first_cell; c < laws.last_cell; ++c) {
    const Eigen::Map<const Eigen::Matrix<double, 6, 1>> at(source.data() + 6 * (c - laws.first_cell));
    const Eigen::Matrix<double, N, 1> own = cell_shapes<N>().value.transpose() * at;
    for (int i = 0; i < N; ++i) system.source[system.cells[c].unknowns[i]] += own[i];
  }
}

void add_prescribed(HeatSystem& system, const BodyView& body, Index body_index) {
  if (body.prescribed.empty()) return;
  for (const core::BoundaryEdge& edge : body.mesh->boundary) {
    if (!body.prescribed[edge.piece]) continue;
    for (const Index unknown : edge_unknowns(system, body_index, edge.nodes)) {
      if (system.is_prescribed[unknown]) continue;
      system.is_prescribed[unknown] = 1;
      system.prescribed.emplace_back(unknown, *body.prescribed[edge.piece]);
    }
  }
}

}  // namespace

HeatSystem make_heat_system(const Problem& problem) {
  assert(problem.order == 1 || problem.order == 2);
  HeatSystem system;
  system.problem = &problem;
  system.first_unknown.push_back(0);
  for (const BodyView& body : problem.bodies) {
    assert(body.mesh->cell_count() == body.mass_mesh->cell_count());
    assert(body.exchange.empty() || body.exchange.size() == body.mesh->pieces.size());
    assert(body.prescribed.empty() || body.prescribed.size() == body.mesh->pieces.size());
    const Index count = problem.order == 2 ? body.mesh->node_count() : body.mesh->vertex_count;
    system.first_unknown.push_back(system.first_unknown.back() + count);
  }
  system.is_prescribed.assign(system.size(), 0);
  system.source.setZero(system.size());
  std::size_t cells = 0;
  for (const BodyView& body : problem.bodies) cells += body.mesh->cells.size();
  system.cells.reserve(cells);
  Index boundary_edges = 0;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const BodyView& body = problem.bodies[b];
    const Index first_cell = static_cast<Index>(system.cells.size());
    add_cells(system, body, system.first_unknown[b]);
    system.bodies.push_back({Enthalpy(body.material->heat_capacity), Conductivity(*body.material), first_cell,
                             static_cast<Index>(system.cells.size())});
    if (body.source) (problem.order == 2 ? add_source<6> : add_source<3>)(system, system.bodies.back(), *body.source);
    add_edges(system, static_cast<Index>(b), boundary_edges);
    boundary_edges += static_cast<Index>(body.mesh->boundary.size());
    add_prescribed(system, body, static_cast<Index>(b));
  }
  add_interface(system);
  return system;
}

Eigen::VectorXd join(const HeatSystem& system, const std::vector<Eigen::VectorXd>& temperature) {
  Eigen::VectorXd joined(system.size());
  for (std::size_t b = 0; b < temperature.size(); ++b) {
    const Index count = system.first_unknown[b + 1] - system.first_unknown[b];
    assert(temperature[b].size() == system.problem->bodies[b].mesh->node_count());
    joined.segment(system.first_unknown[b], count) = temperature[b].head(count);
  }
  return joined;
}

std::vector<Eigen::VectorXd> split(const HeatSystem& system, const Eigen::VectorXd& joined) {
  std::vector<Eigen::VectorXd> temperature;
  const auto& first = system.first_unknown;
  for (std::size_t b = 0; b + 1 < first.size(); ++b) {
    const Eigen::VectorXd own = joined.segment(first[b], first[b + 1] - first[b]);
    temperature.push_back(system.problem->order == 2 ? own : core::from_vertices(*system.problem->bodies[b].mesh, own));
  }
  return temperature;
}

std::array<Index, 3> edge_unknowns(const HeatSystem& system, Index body, const std::array<Index, 3>& nodes) {
  const Index first = system.first_unknown[body];
  return {first + nodes[0], first + nodes[1], first + (system.problem->order == 2 ? nodes[2] : nodes[0])};
}

Index body_of(const HeatSystem& system, Index unknown) {
  const auto& first = system.first_unknown;
  return static_cast<Index>(std::upper_bound(first.begin(), first.end(), unknown) - first.begin() - 1);
}

Ledger empty_ledger(const HeatSystem& system) {
  Ledger ledger;
  ledger.bodies.resize(system.bodies.size());
  for (const auto& [slave, master] : system.pairs) ledger.pairs.push_back({slave, master});
  return ledger;
}

void book(Ledger& ledger, const Flows& flows, double duration) {
  for (std::size_t b = 0; b < ledger.bodies.size(); ++b) {
    ledger.bodies[b].to_air += duration * flows.to_air[b];
    ledger.bodies[b].from_source += duration * flows.from_source[b];
  }
  for (std::size_t p = 0; p < ledger.pairs.size(); ++p) {
    ledger.pairs[p].heat += duration * flows.across[p];
    ledger.pairs[p].received += duration * flows.received[p];
  }
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
