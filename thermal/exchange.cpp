// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/exchange.hpp"

#include <cmath>

#include "thermal/system.hpp"
#include "thermal/time/step_matrix.hpp"

namespace parison::thermal {

namespace {

/// Heat that an area in contact would give the air if it were free: linear T + quartic |T|^3 T - constant, W.
struct FreeSurface {
  double linear, quartic, constant;  ///< W/m2/K, W/m2/K4, W/m2

  explicit FreeSurface(const ExchangeCoefficients& exchange)
      : linear(exchange.h),
        quartic(exchange.emissivity * stefan_boltzmann),
        constant(exchange.h * exchange.air_temperature + quartic * std::pow(exchange.ambient_temperature, 4)) {}

  double heat(double area, double T) const {
    return (linear * area + quartic * area * T * T * std::abs(T)) * T - constant * area;
  }
  /// With respect to T, W/K.
  double derivative(double area, double T) const {
    return linear * area + 4 * (quartic * area) * (T * T) * std::abs(T);
  }
};

/// Boundary, counted through all bodies, that each mid-side node of a body's boundary lies on, by node.
std::vector<Index> boundaries_of_mid_nodes(const HeatSystem& system, Index body) {
  const core::Mesh& mesh = *system.problem->bodies[body].mesh;
  std::vector<Index> boundary(mesh.nodes.size());
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    boundary[edge.nodes[2]] = system.first_boundary[body] + edge.boundary_id;
  return boundary;
}

bool face_alike(const core::InterfacePoint& a, const core::InterfacePoint& b) {
  return a.slave_nodes == b.slave_nodes && a.master_nodes == b.master_nodes && a.slave_body == b.slave_body &&
         a.master_body == b.master_body;
}

HeatSegment start_segment(HeatSystem& system, const core::InterfacePoint& point, Index at,
                          std::vector<std::vector<Index>>& boundaries) {
  for (const Index body : {point.slave_body, point.master_body})
    if (boundaries[body].empty()) boundaries[body] = boundaries_of_mid_nodes(system, body);
  const auto slave = edge_unknowns(system, point.slave_body, point.slave_nodes);
  const auto master = edge_unknowns(system, point.master_body, point.master_nodes);
  return {{slave[0], slave[1], slave[2], master[0], master[1], master[2]},
          at,
          at,
          point.slave_body,
          point.master_body,
          boundaries[point.slave_body][point.slave_nodes[2]],
          boundaries[point.master_body][point.master_nodes[2]],
          find_pair(system, {point.slave_body, point.master_body})};
}

/// Adds the heat across the interface, and takes off the exchange with the air that the area in contact does not have.
void add_contact_heat(const HeatSystem& system, double time, const std::vector<ExchangeCoefficients>& exchange,
                      const Eigen::VectorXd& temperature, Flows& flows, Eigen::VectorXd* power) {
  using Eigen::Vector3d;
  const HeatInterface& interface = system.interface;
  const auto [T1, T2] = side_temperatures(interface, temperature);
  const std::vector<FreeSurface> air(exchange.begin(), exchange.end());  // by boundary, counted through all bodies
  Eigen::ArrayXd h(T1.size());
  system.problem->law(time, system.problem->interface, {T1, T2}, h, nullptr);
  for (const HeatSegment& segment : interface.segments) {
    const FreeSurface &slave_air = air[segment.slave_boundary], &master_air = air[segment.master_boundary];
    // Heat by unknown of the segment.
    Vector3d from_slave = Vector3d::Zero(), to_master = from_slave, covered1 = from_slave, covered2 = from_slave;
    for (Index i = segment.first_point; i < segment.last_point; ++i) {
      const Eigen::Map<const Vector3d> s(&interface.shape(0, i)), m(&interface.shape(3, i));
      const double across = interface.area[i] * h[i] * (T1[i] - T2[i]);
      from_slave += across * s;
      to_master += across * m;
      covered1 += slave_air.heat(interface.area[i], T1[i]) * s;
      covered2 += master_air.heat(interface.area[i], T2[i]) * m;
    }
    flows.across[segment.pair] += from_slave.sum();
    flows.received[segment.pair] += to_master.sum();
    flows.to_air[segment.slave_body] -= covered1.sum();
    flows.to_air[segment.master_body] -= covered2.sum();
    flows.exchanged[segment.slave_boundary] -= covered1.sum();
    flows.exchanged[segment.master_boundary] -= covered2.sum();
    if (!power) continue;
    for (int i = 0; i < 3; ++i) {
      (*power)[segment.unknowns[i]] -= from_slave[i] - covered1[i];
      (*power)[segment.unknowns[3 + i]] -= -to_master[i] - covered2[i];
    }
  }
}

}  // namespace

std::vector<Index> edges_of_mid_nodes(const core::Mesh& mesh) {
  std::vector<Index> edge(mesh.nodes.size(), -1);
  for (std::size_t e = 0; e < mesh.boundary_edges().size(); ++e)
    edge[mesh.boundary_edges()[e].nodes[2]] = static_cast<Index>(e);
  return edge;
}

void add_edges(HeatSystem& system, Index body_index, Index first_boundary_edge) {
  const BodyView& body = system.problem->bodies[body_index];
  const auto& rule = core::edge_rule(3);
  for (std::size_t e = 0; e < body.mesh->boundary_edges().size(); ++e) {
    const core::BoundaryEdge& boundary = body.mesh->boundary_edges()[e];
    if (!exchange_of(body.exchange, boundary.boundary_id)) continue;
    HeatEdge edge{edge_unknowns(system, body_index, boundary.nodes),
                  first_boundary_edge + static_cast<Index>(e),
                  system.first_boundary[body_index] + boundary.boundary_id,
                  body_index,
                  {},
                  {}};
    for (int q = 0; q < 3; ++q) {
      edge.area[q] = core::map_edge_point(*body.mesh, boundary.nodes, system.problem->geometry, rule[q]).area;
      edge.shape[q] = edge_shapes()[q];
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
  std::vector<std::vector<Index>> boundaries(system.problem->bodies.size());
  for (Index i = 0; i < count; ++i) {
    if (i == 0 || !face_alike(points[i - 1], points[i]))
      interface.segments.push_back(start_segment(system, points[i], i, boundaries));
    interface.segments.back().last_point = i + 1;
    const auto &slave = points[i].slave_shape, &master = points[i].master_shape;
    interface.shape.col(i) << slave[0], slave[1], slave[2], master[0], master[1], master[2];
    interface.area[i] = points[i].contact_weight * points[i].area;
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

void add_exchange(const HeatSystem& system, double time, const Eigen::VectorXd& temperature, Flows& flows,
                  Eigen::VectorXd* power) {
  const std::vector<ExchangeCoefficients> exchange = exchange_at(system.problem->bodies, system.first_boundary, time);
  for (const HeatEdge& edge : system.edges)
    for (int q = 0; q < 3; ++q) {
      const double T = interpolate(temperature, edge.unknowns.data(), edge.shape[q]);
      const double heat = edge.area[q] * surface_flux(exchange[edge.boundary], T).q;
      flows.to_air[edge.body] += heat;
      flows.exchanged[edge.boundary] += heat;
      if (power)
        for (int i = 0; i < 3; ++i) (*power)[edge.unknowns[i]] -= edge.shape[q][i] * heat;
    }
  if (!system.interface.segments.empty()) add_contact_heat(system, time, exchange, temperature, flows, power);
}

namespace {

ContactDerivatives linearise_contact(const HeatSystem& system, double time,
                                     const std::vector<ExchangeCoefficients>& exchange,
                                     const Eigen::VectorXd& temperature) {
  const HeatInterface& interface = system.interface;
  if (interface.segments.empty()) return {};
  const auto [T1, T2] = side_temperatures(interface, temperature);
  const std::vector<FreeSurface> air(exchange.begin(), exchange.end());  // by boundary, counted through all bodies
  Eigen::ArrayXd h(T1.size()), dh_dT(T1.size());
  system.problem->law(time, system.problem->interface, {T1, T2}, h, &dh_dT);
  ContactDerivatives result{interface.area * h, interface.area * dh_dT * (T1 - T2), Eigen::ArrayXd(T1.size()),
                            Eigen::ArrayXd(T1.size())};
  for (const HeatSegment& segment : interface.segments) {
    const FreeSurface &slave_air = air[segment.slave_boundary], &master_air = air[segment.master_boundary];
    for (Index i = segment.first_point; i < segment.last_point; ++i) {
      result.slave_air[i] = slave_air.derivative(interface.area[i], T1[i]);
      result.master_air[i] = master_air.derivative(interface.area[i], T2[i]);
    }
  }
  return result;
}

void add_edges(StepMatrix& matrix, const HeatSystem& system, const Linearisation& derivatives, double step) {
  for (std::size_t e = 0; e < system.edges.size(); ++e) {
    const HeatEdge& edge = system.edges[e];
    const auto& [a, b, c] = derivatives.edges[e];
    add_edge(matrix, system, edge.boundary_edge, edge.unknowns, {step * a, step * b, step * c}, edge.shape);
  }
}

/// Adds one dense matrix for each segment, the sum over its points.
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

void linearise_exchange(const HeatSystem& system, double time, const Eigen::VectorXd& temperature,
                        Linearisation& result) {
  const std::vector<ExchangeCoefficients> exchange = exchange_at(system.problem->bodies, system.first_boundary, time);
  for (const HeatEdge& edge : system.edges) {
    auto& derivatives = result.edges.emplace_back();
    for (int q = 0; q < 3; ++q) {
      const double T = interpolate(temperature, edge.unknowns.data(), edge.shape[q]);
      derivatives[q] = edge.area[q] * surface_flux(exchange[edge.boundary], T).dq_dT;
    }
  }
  result.contacts = linearise_contact(system, time, exchange, temperature);
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

void assemble_exchange(StepMatrix& matrix, const HeatSystem& system, double time, const Eigen::VectorXd& temperature,
                       double step) {
  Linearisation derivatives;
  linearise_exchange(system, time, temperature, derivatives);
  add_edges(matrix, system, derivatives, step);
  if (!system.interface.segments.empty()) add_segments(matrix, system, derivatives.contacts, step);
}

}  // namespace parison::thermal
