// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/exchange.hpp"

#include <algorithm>
#include <cmath>

#include "thermal/system.hpp"
#include "thermal/time/step_matrix.hpp"

namespace parison::thermal {

namespace {

const SurfaceExchange* exchange_of(const BodyView& body, Index boundary_id) {
  if (body.exchange.empty() || !body.exchange[boundary_id]) return nullptr;
  return &*body.exchange[boundary_id];
}

/// What a square metre of a boundary gives the air: linear T + quartic |T|^3 T - constant, W/m2.
struct AirLaw {
  double linear = 0, quartic = 0, constant = 0;
};
AirLaw air_law(const SurfaceExchange* exchange) {
  if (!exchange) return {};
  const double radiant = exchange->emissivity * stefan_boltzmann;
  return {exchange->h, radiant,
          exchange->h * exchange->air_temperature + radiant * std::pow(exchange->ambient_temperature, 4)};
}

/// The boundaries of a body's boundary and the air on them.
struct BodyAir {
  std::vector<AirLaw> laws;        ///< by boundary
  std::vector<Index> boundary_id;  ///< of the boundary edge with a given mid node

  const AirLaw& at(Index mid_node) const { return laws[boundary_id[mid_node]]; }
};
BodyAir body_air(const BodyView& body) {
  BodyAir air;
  for (std::size_t p = 0; p < body.mesh->boundaries().size(); ++p)
    air.laws.push_back(air_law(exchange_of(body, static_cast<Index>(p))));
  air.boundary_id.resize(body.mesh->nodes.size());
  for (const core::BoundaryEdge& edge : body.mesh->boundary_edges()) air.boundary_id[edge.nodes[2]] = edge.boundary_id;
  return air;
}

void resize(CoveredExchange& covered, Index size) {
  covered.linear.resize(size);
  covered.quartic.resize(size);
  covered.constant.resize(size);
}

/// Covers the points of a segment on one of its sides.
void cover(CoveredExchange& covered, const HeatSegment& segment, const Eigen::ArrayXd& area, const AirLaw& air) {
  for (Index i = segment.first_point; i < segment.last_point; ++i) {
    covered.linear[i] = air.linear * area[i];
    covered.quartic[i] = air.quartic * area[i];
    covered.constant[i] = air.constant * area[i];
  }
}

Index find_pair(HeatSystem& system, const std::pair<Index, Index>& pair) {
  const auto found = std::find(system.pairs.begin(), system.pairs.end(), pair);
  const auto index = static_cast<Index>(found - system.pairs.begin());
  if (found == system.pairs.end()) system.pairs.push_back(pair);
  return index;
}

bool face_alike(const core::InterfacePoint& a, const core::InterfacePoint& b) {
  return a.slave_nodes == b.slave_nodes && a.master_nodes == b.master_nodes && a.slave_body == b.slave_body &&
         a.master_body == b.master_body;
}

HeatSegment start_segment(HeatSystem& system, const core::InterfacePoint& point, Index at) {
  const auto slave = edge_unknowns(system, point.slave_body, point.slave_nodes);
  const auto master = edge_unknowns(system, point.master_body, point.master_nodes);
  return {{slave[0], slave[1], slave[2], master[0], master[1], master[2]}, at, at, point.slave_body, point.master_body,
          find_pair(system, {point.slave_body, point.master_body})};
}

/// Heat across the interface and what its cover keeps from the air.
void add_contact_heat(const HeatSystem& system, const Eigen::VectorXd& temperature, Flows& flows,
                      Eigen::VectorXd* power) {
  using Eigen::Vector3d;
  const HeatInterface& interface = system.interface;
  const auto [T1, T2] = side_temperatures(interface, temperature);
  Eigen::ArrayXd h(T1.size());
  system.problem->law(system.problem->interface, T1, h, nullptr);
  for (const HeatSegment& segment : interface.segments) {
    // In shares of the unknowns.
    Vector3d from_slave = Vector3d::Zero(), to_master = from_slave, covered1 = from_slave, covered2 = from_slave;
    for (Index i = segment.first_point; i < segment.last_point; ++i) {
      const Eigen::Map<const Vector3d> s(&interface.shape(0, i)), m(&interface.shape(3, i));
      const double across = interface.area[i] * h[i] * (T1[i] - T2[i]);
      from_slave += across * s;
      to_master += across * m;
      covered1 += interface.slave_air.heat(i, T1[i]) * s;
      covered2 += interface.master_air.heat(i, T2[i]) * m;
    }
    flows.across[segment.pair] += from_slave.sum();
    flows.received[segment.pair] += to_master.sum();
    flows.to_air[segment.slave_body] -= covered1.sum();
    flows.to_air[segment.master_body] -= covered2.sum();
    if (!power) continue;
    for (int i = 0; i < 3; ++i) {
      (*power)[segment.unknowns[i]] -= from_slave[i] - covered1[i];
      (*power)[segment.unknowns[3 + i]] -= -to_master[i] - covered2[i];
    }
  }
}

}  // namespace

void add_edges(HeatSystem& system, Index body_index, Index first_boundary_edge) {
  const BodyView& body = system.problem->bodies[body_index];
  const auto& rule = core::edge_rule(3);
  for (std::size_t e = 0; e < body.mesh->boundary_edges().size(); ++e) {
    const core::BoundaryEdge& boundary = body.mesh->boundary_edges()[e];
    const SurfaceExchange* exchange = exchange_of(body, boundary.boundary_id);
    if (!exchange) continue;
    HeatEdge edge{edge_unknowns(system, body_index, boundary.nodes),
                  first_boundary_edge + static_cast<Index>(e),
                  body_index,
                  *exchange,
                  {},
                  {}};
    for (int q = 0; q < 3; ++q) {
      edge.area[q] = core::map_edge_point(*body.mesh, boundary.nodes, system.problem->geometry, rule[q]).area;
      edge.shape[q] = unknown_weights(edge_shapes()[q], system.problem->order);
    }
    system.edges.push_back(edge);
  }
}

void add_interface(HeatSystem& system) {
  const auto& points = system.problem->interface;
  const auto count = static_cast<Index>(points.size());
  HeatInterface& interface = system.interface;
  interface.shape.resize(6, count);
  interface.area.resize(count);
  interface.segments.reserve(count);
  resize(interface.slave_air, count);
  resize(interface.master_air, count);
  for (Index i = 0; i < count; ++i) {
    if (i == 0 || !face_alike(points[i - 1], points[i]))
      interface.segments.push_back(start_segment(system, points[i], i));
    interface.segments.back().last_point = i + 1;
    const auto slave = unknown_weights(points[i].slave_shape, system.problem->order);
    const auto master = unknown_weights(points[i].master_shape, system.problem->order);
    interface.shape.col(i) << slave[0], slave[1], slave[2], master[0], master[1], master[2];
    interface.area[i] = points[i].contact_weight * points[i].area;
  }
  if (count == 0) return;
  std::vector<BodyAir> air(system.problem->bodies.size());
  for (const auto& [slave, master] : system.pairs)
    for (const Index body : {slave, master})
      if (air[body].boundary_id.empty()) air[body] = body_air(system.problem->bodies[body]);
  for (const HeatSegment& segment : interface.segments) {
    const core::InterfacePoint& point = points[segment.first_point];
    cover(interface.slave_air, segment, interface.area, air[point.slave_body].at(point.slave_nodes[2]));
    cover(interface.master_air, segment, interface.area, air[point.master_body].at(point.master_nodes[2]));
  }
}

SideTemperatures side_temperatures(const HeatInterface& interface, const Eigen::VectorXd& temperature) {
  SideTemperatures at{Eigen::ArrayXd(interface.area.size()), Eigen::ArrayXd(interface.area.size())};
  for (const HeatSegment& segment : interface.segments) {
    const auto& u = segment.unknowns;
    const double T0 = temperature[u[0]], T1 = temperature[u[1]], T2 = temperature[u[2]];
    const double T3 = temperature[u[3]], T4 = temperature[u[4]], T5 = temperature[u[5]];
    for (Index i = segment.first_point; i < segment.last_point; ++i) {
      const auto shape = interface.shape.col(i);
      at.slave[i] = shape[0] * T0 + shape[1] * T1 + shape[2] * T2;
      at.master[i] = shape[3] * T3 + shape[4] * T4 + shape[5] * T5;
    }
  }
  return at;
}

void add_exchange(const HeatSystem& system, const Eigen::VectorXd& temperature, Flows& flows, Eigen::VectorXd* power) {
  for (const HeatEdge& edge : system.edges)
    for (int q = 0; q < 3; ++q) {
      const double T = interpolate(temperature, edge.unknowns.data(), edge.shape[q]);
      const double heat = edge.area[q] * surface_flux(edge.exchange, T).q;
      flows.to_air[edge.body] += heat;
      if (power)
        for (int i = 0; i < 3; ++i) (*power)[edge.unknowns[i]] -= edge.shape[q][i] * heat;
    }
  if (!system.interface.segments.empty()) add_contact_heat(system, temperature, flows, power);
}

namespace {

ContactDerivatives linearise_contact(const HeatSystem& system, const Eigen::VectorXd& temperature) {
  const HeatInterface& interface = system.interface;
  if (interface.segments.empty()) return {};
  const auto [T1, T2] = side_temperatures(interface, temperature);
  Eigen::ArrayXd h(T1.size()), dh_dT(T1.size());
  system.problem->law(system.problem->interface, T1, h, &dh_dT);
  return {interface.area * h, interface.area * dh_dT * (T1 - T2), interface.slave_air.derivative(T1),
          interface.master_air.derivative(T2)};
}

void add_edges(StepMatrix& matrix, const HeatSystem& system, const Linearisation& derivatives, double step) {
  for (std::size_t e = 0; e < system.edges.size(); ++e) {
    const HeatEdge& edge = system.edges[e];
    std::array<double, 9> local{};
    for (int q = 0; q < 3; ++q)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j)
          local[i * 3 + j] += step * derivatives.edges[e][q] * edge.shape[q][i] * edge.shape[q][j];
    const Index clique = static_cast<Index>(system.cells.size()) + edge.boundary_edge;
    add_clique(matrix, system, clique, 3, edge.unknowns.data(), local.data());
  }
}

/// The points of a segment share their clique: one entry in the matrix for all of them.
void add_segments(StepMatrix& matrix, const HeatSystem& system, const ContactDerivatives& derivatives, double step) {
  using RowMajor = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  const Eigen::ArrayXd across = step * derivatives.across;
  const Eigen::ArrayXd slave = step * (derivatives.across + derivatives.conductance.max(0) - derivatives.slave_air);
  const Eigen::ArrayXd master = step * (derivatives.across - derivatives.master_air);
  for (std::size_t k = 0; k < system.interface.segments.size(); ++k) {
    const HeatSegment& segment = system.interface.segments[k];
    RowMajor local = RowMajor::Zero();
    for (Index i = segment.first_point; i < segment.last_point; ++i) {
      const Eigen::Vector3d s = system.interface.shape.col(i).head<3>(), m = system.interface.shape.col(i).tail<3>();
      local.topLeftCorner<3, 3>() += slave[i] * s * s.transpose();
      local.bottomLeftCorner<3, 3>() -= across[i] * m * s.transpose();
      local.bottomRightCorner<3, 3>() += master[i] * m * m.transpose();
    }
    add_clique(matrix, system, matrix.segment_clique[k], 6, segment.unknowns.data(), local.data());
  }
}

}  // namespace

void linearise_exchange(const HeatSystem& system, const Eigen::VectorXd& temperature, Linearisation& result) {
  for (const HeatEdge& edge : system.edges) {
    auto& derivatives = result.edges.emplace_back();
    for (int q = 0; q < 3; ++q) {
      const double T = interpolate(temperature, edge.unknowns.data(), edge.shape[q]);
      derivatives[q] = edge.area[q] * surface_flux(edge.exchange, T).dq_dT;
    }
  }
  result.contacts = linearise_contact(system, temperature);
}

void apply_exchange(const HeatSystem& system, const Linearisation& linearisation, double step,
                    const Eigen::VectorXd& change, Eigen::VectorXd& result) {
  for (std::size_t e = 0; e < system.edges.size(); ++e) {
    const HeatEdge& edge = system.edges[e];
    for (int q = 0; q < 3; ++q) {
      const double heat = step * linearisation.edges[e][q] * interpolate(change, edge.unknowns.data(), edge.shape[q]);
      for (int i = 0; i < 3; ++i) result[edge.unknowns[i]] += edge.shape[q][i] * heat;
    }
  }
  if (system.interface.segments.empty()) return;
  const auto [d1, d2] = side_temperatures(system.interface, change);
  const ContactDerivatives& derivatives = linearisation.contacts;
  const Eigen::ArrayXd across = step * (derivatives.across * (d1 - d2) + derivatives.conductance * d1);
  const Eigen::ArrayXd slave = across - step * derivatives.slave_air * d1,
                       master = -across - step * derivatives.master_air * d2;
  for (const HeatSegment& segment : system.interface.segments) {
    Eigen::Matrix<double, 6, 1> out = Eigen::Matrix<double, 6, 1>::Zero();
    for (Index i = segment.first_point; i < segment.last_point; ++i) {
      out.head<3>() += slave[i] * system.interface.shape.col(i).head<3>();
      out.tail<3>() += master[i] * system.interface.shape.col(i).tail<3>();
    }
    for (int i = 0; i < 6; ++i) result[segment.unknowns[i]] += out[i];
  }
}

void assemble_exchange(StepMatrix& matrix, const HeatSystem& system, const Eigen::VectorXd& temperature, double step) {
  Linearisation derivatives;
  linearise_exchange(system, temperature, derivatives);
  add_edges(matrix, system, derivatives, step);
  if (!system.interface.segments.empty()) add_segments(matrix, system, derivatives.contacts, step);
}

}  // namespace parison::thermal
