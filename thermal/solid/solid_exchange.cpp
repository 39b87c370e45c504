// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/solid/solid_exchange.hpp"

#include <algorithm>

#include "core/mesh/element.hpp"
#include "thermal/exchange.hpp"

namespace parison::thermal {

namespace {

using Shape = std::array<double, 9>;

double interpolate(const Eigen::VectorXd& temperature, const Index* unknowns, const Shape& shape) {
  double T = 0;
  for (int i = 0; i < 9; ++i) T += shape[i] * temperature[unknowns[i]];
  return T;
}

SideTemperatures side_temperatures(const SolidSystem& system, const Eigen::VectorXd& temperature) {
  const auto& points = system.problem->interface.points;
  SideTemperatures at{Eigen::ArrayXd(points.size()), Eigen::ArrayXd(points.size())};
  for (const SolidHeatPair& contact : system.contacts)
    for (Index i = contact.first_point; i < contact.last_point; ++i) {
      const auto& point = points[static_cast<std::size_t>(i)];
      at.slave[i] = interpolate(temperature, contact.unknowns.data(), point.slave_shape);
      at.master[i] = interpolate(temperature, contact.unknowns.data() + 9, point.master_shape);
    }
  return at;
}

/// Heat by unknown of a pair of faces, W.
struct PairHeat {
  Shape from_slave{}, to_master{}, slave_air{}, master_air{};
};

double sum(const Shape& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

/// Books the heat of a pair; what its area would give the air if it were free is taken off.
void book(const SolidHeatPair& contact, const core::FacePair& faces, const PairHeat& heat, Response& response) {
  Flows& flows = response.flows;
  const double slave_air = sum(heat.slave_air), master_air = sum(heat.master_air);
  flows.across[contact.body_pair] += sum(heat.from_slave);
  flows.received[contact.body_pair] += sum(heat.to_master);
  flows.to_air[faces.slave_body] -= slave_air;
  flows.to_air[faces.master_body] -= master_air;
  flows.exchanged[contact.slave_boundary] -= slave_air;
  flows.exchanged[contact.master_boundary] -= master_air;
  for (int i = 0; i < 9; ++i) {
    response.power[contact.unknowns[i]] -= heat.from_slave[i] - heat.slave_air[i];
    response.power[contact.unknowns[9 + i]] += heat.to_master[i] + heat.master_air[i];
  }
}

void add_contact_heat(const SolidSystem& system, double time, const std::vector<ExchangeCoefficients>& exchange,
                      const Eigen::VectorXd& temperature, Response& response) {
  const core::SolidInterface& interface = system.problem->interface;
  const auto [T1, T2] = side_temperatures(system, temperature);
  Eigen::ArrayXd h(T1.size());
  system.problem->law(time, interface.points, {T1, T2}, h, nullptr);
  for (const SolidHeatPair& contact : system.contacts) {
    PairHeat heat;
    for (Index i = contact.first_point; i < contact.last_point; ++i) {
      const auto& point = interface.points[static_cast<std::size_t>(i)];
      const double area = point.contact_weight * point.area, across = area * h[i] * (T1[i] - T2[i]);
      const double slave_air = area * surface_flux(exchange[contact.slave_boundary], T1[i]).q;
      const double master_air = area * surface_flux(exchange[contact.master_boundary], T2[i]).q;
      for (int k = 0; k < 9; ++k) {
        heat.from_slave[k] += across * point.slave_shape[k];
        heat.slave_air[k] += slave_air * point.slave_shape[k];
        heat.to_master[k] += across * point.master_shape[k];
        heat.master_air[k] += master_air * point.master_shape[k];
      }
    }
    book(contact, interface.pairs[contact.pair], heat, response);
  }
}

SolidHeatPair start_contact(SolidSystem& system, Index pair, Index at) {
  const core::FacePair& faces = system.problem->interface.pairs[pair];
  const core::QuadFace& slave = (*system.problem->bodies[faces.slave_body].faces)[faces.slave_face];
  const core::QuadFace& master = (*system.problem->bodies[faces.master_body].faces)[faces.master_face];
  SolidHeatPair contact{{},
                        at,
                        at,
                        pair,
                        find_pair(system, {faces.slave_body, faces.master_body}),
                        system.first_boundary[faces.slave_body] + slave.boundary_id,
                        system.first_boundary[faces.master_body] + master.boundary_id};
  for (int i = 0; i < 9; ++i) {
    contact.unknowns[i] = system.first_unknown[faces.slave_body] + slave.nodes[i];
    contact.unknowns[9 + i] = system.first_unknown[faces.master_body] + master.nodes[i];
  }
  return contact;
}

}  // namespace

const std::array<Shape, 9>& face_shapes() {
  static const std::array<Shape, 9> shapes = [] {
    std::array<Shape, 9> made;
    const auto& rule = core::edge_rule(3);
    for (int q = 0; q < 9; ++q) made[q] = core::quad_shape(rule[q % 3].s, rule[q / 3].s);
    return made;
  }();
  return shapes;
}

void add_faces(SolidSystem& system, Index body_index) {
  const SolidBodyView& body = system.problem->bodies[body_index];
  const auto& rule = core::edge_rule(3);
  for (std::size_t f = 0; f < body.faces->size(); ++f) {
    const core::QuadFace& face = (*body.faces)[f];
    if (!exchange_of(body.exchange, face.boundary_id)) continue;
    SolidHeatFace& heat = system.faces.emplace_back();
    for (int i = 0; i < 9; ++i) heat.unknowns[i] = system.first_unknown[body_index] + face.nodes[i];
    for (int q = 0; q < 9; ++q) {
      const auto &a = rule[q % 3], &b = rule[q / 3];
      heat.area[q] = a.weight * b.weight * core::face_place(*body.nodes, face, a.s, b.s).area().norm();
    }
    heat.clique = system.first_face[body_index] + static_cast<Index>(f);
    heat.boundary = system.first_boundary[body_index] + face.boundary_id;
    heat.body = body_index;
  }
}

void add_contacts(SolidSystem& system) {
  const auto& points = system.problem->interface.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto at = static_cast<Index>(i);
    if (i == 0 || points[i].pair != points[i - 1].pair)
      system.contacts.push_back(start_contact(system, points[i].pair, at));
    system.contacts.back().last_point = at + 1;
  }
}

void add_exchange(const SolidSystem& system, double time, const Eigen::VectorXd& temperature, Response& response) {
  const std::vector<ExchangeCoefficients> exchange = exchange_at(system.problem->bodies, system.first_boundary, time);
  for (const SolidHeatFace& face : system.faces)
    for (int q = 0; q < 9; ++q) {
      const Shape& shape = face_shapes()[q];
      const double T = interpolate(temperature, face.unknowns.data(), shape);
      const double heat = face.area[q] * surface_flux(exchange[face.boundary], T).q;
      response.flows.to_air[face.body] += heat;
      response.flows.exchanged[face.boundary] += heat;
      for (int i = 0; i < 9; ++i) response.power[face.unknowns[i]] -= shape[i] * heat;
    }
  if (!system.contacts.empty()) add_contact_heat(system, time, exchange, temperature, response);
}

namespace {

void add_face_matrices(const SolidSystem& system, const std::vector<ExchangeCoefficients>& exchange,
                       const Eigen::VectorXd& temperature, double step, const ExchangeMatrices& add) {
  for (const SolidHeatFace& face : system.faces) {
    std::array<double, 81> matrix{};
    for (int q = 0; q < 9; ++q) {
      const Shape& shape = face_shapes()[q];
      const double T = interpolate(temperature, face.unknowns.data(), shape);
      const double slope = step * face.area[q] * surface_flux(exchange[face.boundary], T).dq_dT;
      for (int i = 0; i < 9; ++i)
        for (int j = 0; j <= i; ++j) matrix[i * 9 + j] += slope * shape[i] * shape[j];
    }
    add.face(face.clique, face.unknowns, matrix);
  }
}

/// Slopes of the heat at a point of the interface, times the step, J/K: across, and with the slave's and the master's
/// temperature less what the air would take.
struct PointSlopes {
  double across, slave, master;
};

void add_point(const core::SolidInterfacePoint& point, const PointSlopes& slopes, std::array<double, 324>& matrix) {
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j <= i; ++j) {
      matrix[i * 18 + j] += slopes.slave * point.slave_shape[i] * point.slave_shape[j];
      matrix[(9 + i) * 18 + 9 + j] += slopes.master * point.master_shape[i] * point.master_shape[j];
    }
    for (int j = 0; j < 9; ++j)
      matrix[(9 + i) * 18 + j] -= slopes.across * point.master_shape[i] * point.slave_shape[j];
  }
}

}  // namespace

void for_each_exchange_matrix(const SolidSystem& system, double time, const Eigen::VectorXd& temperature, double step,
                              const ExchangeMatrices& add) {
  const std::vector<ExchangeCoefficients> exchange = exchange_at(system.problem->bodies, system.first_boundary, time);
  add_face_matrices(system, exchange, temperature, step, add);
  if (system.contacts.empty()) return;
  const auto& points = system.problem->interface.points;
  const auto [T1, T2] = side_temperatures(system, temperature);
  Eigen::ArrayXd h(T1.size()), dh_dT(T1.size());
  system.problem->law(time, points, {T1, T2}, h, &dh_dT);
  for (const SolidHeatPair& contact : system.contacts) {
    std::array<double, 324> matrix{};
    for (Index i = contact.first_point; i < contact.last_point; ++i) {
      const auto& point = points[static_cast<std::size_t>(i)];
      const double area = step * point.contact_weight * point.area, across = area * h[i];
      const double stiffening = area * std::max(dh_dT[i] * (T1[i] - T2[i]), 0.0);
      const double slave_air = area * surface_flux(exchange[contact.slave_boundary], T1[i]).dq_dT;
      const double master_air = area * surface_flux(exchange[contact.master_boundary], T2[i]).dq_dT;
      add_point(point, {across, across + stiffening - slave_air, across - master_air}, matrix);
    }
    add.contact(contact.pair, contact.unknowns, matrix);
  }
}

}  // namespace parison::thermal
