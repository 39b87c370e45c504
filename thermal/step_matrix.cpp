// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/step_matrix.hpp"

#include <algorithm>

#include "thermal/shapes.hpp"

namespace parison::thermal {

namespace {

std::pair<Index, Index> clique_key(const HeatContact& contact) { return {contact.unknowns[2], contact.unknowns[5]}; }

std::vector<Index> list_topology(const HeatSystem& system) {
  std::vector<Index> topology;
  for (const HeatCell& cell : system.cells) topology.insert(topology.end(), cell.unknowns.begin(), cell.unknowns.end());
  for (std::size_t b = 0; b < system.problem->bodies.size(); ++b)
    for (const core::BoundaryEdge& edge : system.problem->bodies[b].mesh->boundary)
      for (const Index node : edge.nodes) topology.push_back(system.first_unknown[b] + node);
  return topology;
}

/// Adds a dense symmetric matrix of N unknowns without the rows and columns of prescribed ones.
template <std::size_t N>
void add(StepMatrix& matrix, const HeatSystem& system, Index clique, const std::array<Index, N>& unknowns,
         std::array<double, N * N>& local) {
  if (!system.prescribed.empty())
    for (std::size_t i = 0; i < N; ++i)
      if (system.is_prescribed[unknowns[i]])
        for (std::size_t j = 0; j < N; ++j) local[i * N + j] = local[j * N + i] = 0;
  core::add_clique(matrix.assembly.matrix, matrix.assembly.scatter, clique, static_cast<Index>(N), local.data());
}

void add_cells(StepMatrix& matrix, const HeatSystem& system, const Eigen::VectorXd& temperature, double step) {
  const CellShapes& shapes = cell_shapes();
  for (const BodyLaws& laws : system.bodies)
    for (Index c = laws.first_cell; c < laws.last_cell; ++c) {
      const HeatCell& cell = system.cells[c];
      std::array<double, 36> local{};
      for (int q = 0; q < 6; ++q) {
        const HeatPoint& point = cell.points[q];
        double at = 0;
        for (int i = 0; i < 6; ++i) at += shapes[q][i] * temperature[cell.unknowns[i]];
        const double capacity = point.mass * laws.enthalpy(at).c;
        const double conduction = step * point.volume * conductivity(*laws.material, at, point.thin_wall);
        for (int i = 0; i < 6; ++i)
          for (int j = 0; j <= i; ++j)
            local[i * 6 + j] +=
                capacity * shapes[q][i] * shapes[q][j] + conduction * point.gradient[i].dot(point.gradient[j]);
      }
      add(matrix, system, c, cell.unknowns, local);
    }
}

void add_edges(StepMatrix& matrix, const HeatSystem& system, const Eigen::VectorXd& temperature, double step) {
  const EdgeShapes& shapes = edge_shapes();
  for (const HeatEdge& edge : system.edges) {
    std::array<double, 9> local{};
    for (int q = 0; q < 3; ++q) {
      const double T = interpolate(temperature, edge.unknowns.data(), shapes[q]);
      const double slope = step * edge.area[q] * surface_flux(edge.exchange, T).dq_dT;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j) local[i * 3 + j] += slope * shapes[q][i] * shapes[q][j];
    }
    add(matrix, system, static_cast<Index>(system.cells.size()) + edge.boundary_edge, edge.unknowns, local);
  }
}

void add_contacts(StepMatrix& matrix, const HeatSystem& system, const Eigen::VectorXd& temperature, double step) {
  for (const HeatContact& contact : system.contacts) {
    const core::InterfacePoint& point = *contact.point;
    const double closed = step * point.closure * point.area;
    if (closed == 0) continue;
    const double T1 = interpolate(temperature, contact.unknowns.data(), point.slave_shape);
    const double T2 = interpolate(temperature, contact.unknowns.data() + 3, point.master_shape);
    const double across = closed * system.problem->law(point, T1).h;
    const double slave_air = contact.slave_air ? closed * surface_flux(*contact.slave_air, T1).dq_dT : 0;
    const double master_air = contact.master_air ? closed * surface_flux(*contact.master_air, T2).dq_dT : 0;
    const auto &s = point.slave_shape, &m = point.master_shape;
    std::array<double, 36> local{};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        local[i * 6 + j] = (across - slave_air) * s[i] * s[j];
        local[(i + 3) * 6 + j] = -across * m[i] * s[j];
        local[(i + 3) * 6 + j + 3] = (across - master_air) * m[i] * m[j];
      }
    add(matrix, system, matrix.contact_clique.at(clique_key(contact)), contact.unknowns, local);
  }
}

}  // namespace

void prepare(StepMatrix& matrix, const HeatSystem& system) {
  std::vector<Index> topology = list_topology(system);
  if (system.is_prescribed != matrix.is_prescribed) matrix.factored_step = 0;
  matrix.is_prescribed = system.is_prescribed;
  const bool known = topology == matrix.topology &&
                     std::all_of(system.contacts.begin(), system.contacts.end(), [&](const HeatContact& contact) {
                       return matrix.contact_clique.count(clique_key(contact)) > 0;
                     });
  if (known) return;
  core::Cliques cliques;
  const std::size_t cell_unknowns = 6 * system.cells.size();
  for (std::size_t k = 0; k < topology.size(); k += k < cell_unknowns ? 6 : 3)
    cliques.add(topology.data() + k, k < cell_unknowns ? 6 : 3);
  matrix.contact_clique.clear();
  for (const HeatContact& contact : system.contacts)
    if (matrix.contact_clique.emplace(clique_key(contact), cliques.count()).second)
      cliques.add(contact.unknowns.data(), 6);
  matrix.assembly = core::make_assembly(system.size(), cliques);
  matrix.cholesky.analyse(matrix.assembly.matrix);
  matrix.topology = std::move(topology);
  matrix.factored_step = 0;
}

bool factorise(StepMatrix& matrix, const HeatSystem& system, const Eigen::VectorXd& temperature, double step) {
  core::SymmetricMatrix& values = matrix.assembly.matrix;
  std::fill(values.value.begin(), values.value.end(), 0.0);
  add_cells(matrix, system, temperature, step);
  add_edges(matrix, system, temperature, step);
  add_contacts(matrix, system, temperature, step);
  for (const auto& [unknown, value] : system.prescribed) values.value[values.column_start[unknown]] = 1;
  matrix.diagonal.resize(values.size);
  for (Index i = 0; i < values.size; ++i) matrix.diagonal[i] = values.value[values.column_start[i]];
  ++matrix.factorisations;
  const bool done = matrix.cholesky.factorise(values);
  matrix.factored_step = done ? step : 0;
  return done;
}

}  // namespace parison::thermal
