// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "thermal/linearise.hpp"
#include "thermal/step_matrix.hpp"

namespace parison::thermal {

namespace {

ContactSlopes linearise_contact(const HeatSystem& system, const HeatContact& contact,
                                const Eigen::VectorXd& temperature) {
  const core::InterfacePoint& point = *contact.point;
  const double closed = point.closure * point.area;
  if (closed == 0) return {};
  const double T1 = interpolate(temperature, contact.unknowns.data(), contact.slave_shape);
  const double T2 = interpolate(temperature, contact.unknowns.data() + 3, contact.master_shape);
  const core::Conductance law = system.problem->law(point, T1);
  return {closed * law.h, closed * law.dh_dT * (T1 - T2),
          contact.slave_air ? closed * surface_flux(*contact.slave_air, T1).dq_dT : 0,
          contact.master_air ? closed * surface_flux(*contact.master_air, T2).dq_dT : 0};
}

void add_edges(StepMatrix& matrix, const HeatSystem& system, const Linearisation& slopes, double step) {
  for (std::size_t e = 0; e < system.edges.size(); ++e) {
    const HeatEdge& edge = system.edges[e];
    std::array<double, 9> local{};
    for (int q = 0; q < 3; ++q)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j)
          local[i * 3 + j] += step * slopes.edges[e][q] * edge.shape[q][i] * edge.shape[q][j];
    const Index clique = static_cast<Index>(system.cells.size()) + edge.boundary_edge;
    add_clique(matrix, system, clique, 3, edge.unknowns.data(), local.data());
  }
}

/// The points of a segment follow one another and share their clique: one entry in the matrix for all of them.
void add_contacts(StepMatrix& matrix, const HeatSystem& system, const Linearisation& slopes, double step) {
  std::array<double, 36> local{};
  bool any = false;
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const HeatContact& contact = system.contacts[c];
    const auto& [across, conductance, slave_air, master_air] = slopes.contacts[c];
    if (across != 0) {
      any = true;
      const auto &s = contact.slave_shape, &m = contact.master_shape;
      const double slave = step * (across + std::max(conductance, 0.0) - slave_air);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          local[i * 6 + j] += slave * s[i] * s[j];
          local[(i + 3) * 6 + j] -= step * across * m[i] * s[j];
          local[(i + 3) * 6 + j + 3] += step * (across - master_air) * m[i] * m[j];
        }
    }
    const bool last = c + 1 == system.contacts.size() || system.contacts[c + 1].unknowns != contact.unknowns;
    if (!last || !any) continue;
    const Index clique = matrix.contact_clique.at(clique_key(contact));
    add_clique(matrix, system, clique, 6, contact.unknowns.data(), local.data());
    local.fill(0);
    any = false;
  }
}

}  // namespace

void linearise_exchange(const HeatSystem& system, const Eigen::VectorXd& temperature, Linearisation& result) {
  for (const HeatEdge& edge : system.edges) {
    auto& slopes = result.edges.emplace_back();
    for (int q = 0; q < 3; ++q) {
      const double T = interpolate(temperature, edge.unknowns.data(), edge.shape[q]);
      slopes[q] = edge.area[q] * surface_flux(edge.exchange, T).dq_dT;
    }
  }
  for (const HeatContact& contact : system.contacts)
    result.contacts.push_back(linearise_contact(system, contact, temperature));
}

void apply_exchange(const HeatSystem& system, const Linearisation& linearisation, double step,
                    const Eigen::VectorXd& change, Eigen::VectorXd& result) {
  const auto add = [&](const Index* unknowns, const std::array<double, 3>& shape, double heat) {
    for (int i = 0; i < 3; ++i) result[unknowns[i]] += step * shape[i] * heat;
  };
  for (std::size_t e = 0; e < system.edges.size(); ++e) {
    const HeatEdge& edge = system.edges[e];
    for (int q = 0; q < 3; ++q)
      add(edge.unknowns.data(), edge.shape[q],
          linearisation.edges[e][q] * interpolate(change, edge.unknowns.data(), edge.shape[q]));
  }
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const HeatContact& contact = system.contacts[i];
    const ContactSlopes& slopes = linearisation.contacts[i];
    const Index *slave = contact.unknowns.data(), *master = slave + 3;
    const double d1 = interpolate(change, slave, contact.slave_shape);
    const double d2 = interpolate(change, master, contact.master_shape);
    const double across = slopes.across * (d1 - d2) + slopes.conductance * d1;
    add(slave, contact.slave_shape, across - slopes.slave_air * d1);
    add(master, contact.master_shape, -across - slopes.master_air * d2);
  }
}

void assemble_exchange(StepMatrix& matrix, const HeatSystem& system, const Linearisation& slopes, double step) {
  add_edges(matrix, system, slopes, step);
  add_contacts(matrix, system, slopes, step);
}

}  // namespace parison::thermal
